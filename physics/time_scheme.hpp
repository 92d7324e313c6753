// Time integration schemes as numbers: where inertia, forces and constraints of a step are evaluated, and how the state follows.
//
// The unknown of a step is q = q_{n+1}; everything else of the new state is a combination of dq = q_{n+1} - q_n, v_n and a_n.
// One residual serves all schemes:
//   M a* + C v* + f_int* + f_contact* - f_ext* = 0
#pragma once

#include <optional>

namespace mortise {

/// dq, v and a are the factors of q_{n+1} - q_n, v_n and a_n in a combination of them.
struct Combination {
  double dq, v, a;
};

/// Kinematics of one step of given length.
struct StepKinematics {
  Combination inertia;       ///< a*, the acceleration in the residual
  Combination damping;       ///< v*, the velocity in the residual
  Combination velocity;      ///< v_{n+1}
  Combination acceleration;  ///< a_{n+1}; for schemes that do not carry it on, a* again
};

/// How internal and external forces of a step are found.
enum class ForceReading {
  at_point,    ///< F(q_theta), q_theta = (1 - theta) q_n + theta q_{n+1}, at time t_n + theta dt
  mean,        ///< (1 - theta) F(q_n) + theta F(q_{n+1})
  algorithmic  ///< discrete gradient of the strain energy (thesis eq. 5.61); all else at theta
};

/// Numbers of the generalised-alpha family (thesis eqs. 5.27-5.32).
struct AlphaNumbers {
  double alpha_m, alpha_f, beta, gamma;

  /// Second order, damping of the highest frequencies given by the spectral radius there (Chung & Hulbert 1993):
  /// alpha_m = (2 rho - 1)/(rho + 1), alpha_f = rho/(rho + 1), beta = (1 - alpha_m + alpha_f)^2/4.
  static AlphaNumbers from_spectral_radius(double rho) { return second_order((2 * rho - 1) / (rho + 1), rho / (rho + 1)); }
  static AlphaNumbers second_order(double alpha_m, double alpha_f) {
    const double shift = alpha_f - alpha_m;
    return {alpha_m, alpha_f, 0.25 * (1 + shift) * (1 + shift), 0.5 + shift};
  }
  /// Stable for linear systems at every step length (Chung & Hulbert 1993).
  bool is_unconditionally_stable() const {
    constexpr double round_off = 1e-12;
    return alpha_m <= alpha_f + round_off && alpha_f <= 0.5 + round_off && beta >= 0.25 + 0.5 * (alpha_f - alpha_m) - round_off;
  }
};

/// A scheme of `conventions.md`, section 6.
struct TimeScheme {
  /// dq = dt ((1 - w) v_n + w v_{n+1}) with this w, and a* = (v_{n+1} - v_n)/dt; 0: there is no inertia, unless `alpha` is set.
  double velocity_weight = 0;
  std::optional<AlphaNumbers> alpha;
  ForceReading forces = ForceReading::at_point;
  double theta = 1;             ///< of `forces`
  double constraint_theta = 1;  ///< where Jacobians of constraints stand; ForceReading::mean: as the forces
  /// Jacobians of constraints are discrete gradients over the step instead, so that constraints do no work (thesis eq. 5.97).
  bool has_discrete_contact = false;
  /// Forward Euler: the step is solved for q_n + dt v_{n+1}, and the new position is q_n + dt v_n.
  bool is_explicit_in_position = false;

  bool has_inertia() const { return velocity_weight > 0 || alpha.has_value(); }

  /// Between steps: nothing has moved, all stands where it is.
  TimeScheme at_rest() const {
    TimeScheme scheme = *this;
    scheme.forces = ForceReading::at_point;
    scheme.theta = scheme.constraint_theta = 1;
    return scheme;
  }

  /// @param dt length of the step [s]; 0: the state as it stands, a* = a_n and v* = v_n
  StepKinematics kinematics(double dt) const {
    const Combination old_velocity{0, 1, 0}, old_acceleration{0, 0, 1};
    if (dt == 0 || !has_inertia()) {
      const double rate = dt > 0 ? 1 / dt : 0;  // without inertia only damping knows velocities
      return {old_acceleration, dt > 0 ? Combination{rate, 0, 0} : old_velocity, old_velocity, old_acceleration};
    }
    if (alpha) return of_alpha(*alpha, dt);
    const double w = velocity_weight;
    const Combination mean{1 / (w * dt * dt), -1 / (w * dt), 0}, end{1 / (w * dt), -(1 - w) / w, 0};
    const double to_force = forces == ForceReading::mean ? 0.5 : theta;
    return {mean, {to_force * end.dq, 1 - to_force + to_force * end.v, 0}, end, mean};
  }

 private:
  static StepKinematics of_alpha(const AlphaNumbers& n, double dt) {
    const Combination acceleration{1 / (n.beta * dt * dt), -1 / (n.beta * dt), 1 - 0.5 / n.beta};
    const Combination velocity{n.gamma * dt * acceleration.dq, 1 + n.gamma * dt * acceleration.v,
                               dt * (1 - n.gamma + n.gamma * acceleration.a)};
    const auto between = [](double old_weight, const Combination& before, const Combination& after) {
      return Combination{(1 - old_weight) * after.dq, old_weight * before.v + (1 - old_weight) * after.v,
                         old_weight * before.a + (1 - old_weight) * after.a};
    };
    return {between(n.alpha_m, {0, 0, 1}, acceleration), between(n.alpha_f, {0, 1, 0}, velocity), velocity, acceleration};
  }
};

}  // namespace mortise
