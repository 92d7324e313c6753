// What a deck says about the time scheme: each kind with the parameters that it has.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "deck/bounds.hpp"
#include "deck/fields.hpp"
#include "physics/time_scheme.hpp"

namespace mortise {

namespace schemes {

struct NoParameters {};

struct Static : NoParameters {
  static constexpr const char* name = "static";
  static constexpr const char* help = "equilibrium at each step; t only orders the loading";
};

struct ForwardEuler : NoParameters {
  static constexpr const char* name = "forward euler";
  static constexpr const char* help = "explicit, first order, for comparison; without supports and contact";
};

struct BackwardEuler : NoParameters {
  static constexpr const char* name = "backward euler";
  static constexpr const char* help = "first order, dissipates much (thesis eqs. 5.12-5.18)";
};

struct Trapezoidal : NoParameters {
  static constexpr const char* name = "trapezoidal";
  static constexpr const char* help = "second order, mean of the forces at both ends of the step (5.19-5.21)";
};

struct Midpoint : NoParameters {
  static constexpr const char* name = "midpoint";
  static constexpr const char* help = "second order, forces at the mean positions; keeps both momenta (5.22-5.26)";
};

/// How the alpha schemes find their forces.
struct AlphaForces {
  ForceReading reading = ForceReading::at_point;
  bool allow_unstable = false;
};

struct GeneralisedAlpha : AlphaForces {
  static constexpr const char* name = "generalised alpha";
  static constexpr const char* help = "second order, damps high frequencies as asked for (5.27-5.32)";
  std::optional<double> spectral_radius;
  std::optional<double> alpha_m, alpha_f, beta, gamma;
};

struct Newmark : AlphaForces {
  static constexpr const char* name = "newmark";
  static constexpr const char* help = "Newmark's method; 1/4 and 1/2 give the average acceleration";
  double beta = 0.25, gamma = 0.5;
};

struct Hht : AlphaForces {
  static constexpr const char* name = "hht";
  static constexpr const char* help = "Hilber, Hughes and Taylor: second order, forces at n + 1 - alpha, inertia at n + 1";
  double alpha = 0.05;
};

struct Wbz : AlphaForces {
  static constexpr const char* name = "wbz";
  static constexpr const char* help = "Wood, Bossak and Zienkiewicz: second order, inertia at n + 1 + alpha, forces at n + 1";
  double alpha = 0.1;
};

struct VariationalMidpoint {
  static constexpr const char* name = "variational midpoint";
  static constexpr const char* help =
      "from a discrete Lagrangian with the potential at (1 - alpha) q_n + alpha q_n+1 (5.34); keeps both momenta; at 1/2 it is "
      "the "
      "midpoint rule, elsewhere of first order and stable at short steps only";
  double alpha = 0.5;
};

struct EnergyMomentum : NoParameters {
  static constexpr const char* name = "energy momentum";
  static constexpr const char* help =
      "second order; keeps the energy and both momenta of what is conservative at any step size (5.45-5.64)";
};

struct EnergyMomentumMidpointContact : NoParameters {
  static constexpr const char* name = "energy momentum midpoint contact";
  static constexpr const char* help =
      "as energy momentum, with contact forces at the mean positions (5.115, 5.117): keeps both momenta; what contact does to "
      "the "
      "energy is in the ledger";
};

}  // namespace schemes

using SchemeKind = std::variant<schemes::Static, schemes::ForwardEuler, schemes::BackwardEuler, schemes::Trapezoidal,
                                schemes::Midpoint, schemes::GeneralisedAlpha, schemes::Newmark, schemes::Hht, schemes::Wbz,
                                schemes::VariationalMidpoint, schemes::EnergyMomentum, schemes::EnergyMomentumMidpointContact>;

/// The numbers of a kind.
TimeScheme scheme_of(const SchemeKind& kind);

/// What keeps a kind from running as the deck says, empty if nothing: numbers that are unstable, alone or with multipliers.
std::string instability(const SchemeKind& kind, bool has_multipliers);

namespace schemes {

template <class Fields>
void describe(Fields&, NoParameters&) {}

template <class Fields>
void describe_forces(Fields& f, AlphaForces& o) {
  f.choice("forces", o.reading, Choices<ForceReading>{{"at point", ForceReading::at_point}, {"mean", ForceReading::mean}},
           Presence::optional, "at point: those of the weighted positions; mean: the weighted mean of those at both ends");
  f.optional("allow unstable", o.allow_unstable, anything, "", "run although energy may grow without bound");
}

template <class Fields>
void describe(Fields& f, GeneralisedAlpha& o) {
  f.optional("spectral radius", o.spectral_radius, within(0, 1), "-",
             "factor on the highest frequencies per step; gives all four numbers (beta = (1 - alpha m + alpha f)^2/4); default: "
             "0.8, unless the four numbers are given");
  f.optional("alpha m", o.alpha_m, between(-5, 1), "-", "weight of the old acceleration");
  f.optional("alpha f", o.alpha_f, at_least(0), "-", "weight of the old positions or forces");
  f.optional("beta", o.beta, positive, "-", "of Newmark's positions");
  f.optional("gamma", o.gamma, positive, "-", "of Newmark's velocities");
  const int given = o.alpha_m.has_value() + o.alpha_f.has_value() + o.beta.has_value() + o.gamma.has_value();
  f.rule("D07", {"alpha m", "alpha f", "beta", "gamma"}, given == 0 || given == 4,
         "needs \"alpha m\", \"alpha f\", \"beta\" and \"gamma\"");
  f.rule("D19", {"spectral radius"}, !o.spectral_radius || given == 0,
         "cannot stand beside \"alpha m\", \"alpha f\", \"beta\" or \"gamma\", which it gives");
  describe_forces(f, o);
}

template <class Fields>
void describe(Fields& f, Newmark& o) {
  f.optional("beta", o.beta, positive, "-", "of the positions");
  f.optional("gamma", o.gamma, positive, "-", "of the velocities; second order at 1/2 alone");
  describe_forces(f, o);
}

template <class Fields>
void describe(Fields& f, Hht& o) {
  f.optional("alpha", o.alpha, within(0, 1.0 / 3), "-", "0: Newmark's average acceleration; 1/3: most damping");
  describe_forces(f, o);
}

template <class Fields>
void describe(Fields& f, Wbz& o) {
  f.optional("alpha", o.alpha, within(0, 1), "-", "0: Newmark's average acceleration; 1: most damping");
  describe_forces(f, o);
}

template <class Fields>
void describe(Fields& f, VariationalMidpoint& o) {
  f.optional("alpha", o.alpha, within(0, 0.99), "-", "weight of the new positions; 0: symplectic Euler");
}

}  // namespace schemes

}  // namespace mortise
