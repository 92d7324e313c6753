// What a deck says about the friction of a pair, and its description: units, bounds and help (see fields.hpp).
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "deck/bounds.hpp"
#include "deck/fields.hpp"

namespace mortise {

/// A number, or the text of a formula.
using NumberOrFormula = std::variant<double, std::string>;

/// How the slip of a step is measured.
enum class SlipForm {
  automatic,   ///< moment free where forces act within the step, thesis where they act at its end
  thesis,      ///< motion weighted with the mortar integrals (thesis eq. 5.124)
  moment_free  ///< the same without the spin of the pair of facets, and a force without moment
};

/// Friction of a pair: none unless it has a coefficient (Coulomb) or a bound (Tresca).
struct FrictionOptions {
  std::optional<NumberOrFormula> coefficient;  ///< in t, p, v
  std::optional<NumberOrFormula> bound;        ///< in t [Pa]
  std::optional<double> tangential_penalty;    ///< none: exact stick
  std::optional<double> slip_regularisation;   ///< slip speed of the regularised law [m/s]; none: stick and slip are two things
  SlipForm slip = SlipForm::automatic;

  bool acts() const { return coefficient || bound; }
  std::string law() const { return bound ? "friction bound" : "friction coefficient"; }  ///< the parameter that calls for it
};

/// What its formulas are in.
inline const std::vector<std::string> friction_coefficient_variables{"t", "p", "v"}, friction_bound_variables{"t"};

template <class Fields>
void describe(Fields& f, FrictionOptions& o) {
  f.number_or_formula(
      "friction coefficient", o.coefficient, at_least(0), friction_coefficient_variables, "-",
      "Coulomb's: greatest tangential traction over pressure. A formula may use the pressure p at the node, its slip speed v, in "
      "statics too the slip of the step over its length, and the time t at the end of the step; its value must be finite and not "
      "negative, at p = 0 and v = 0 too. Neither \"friction coefficient\" nor \"friction bound\": no friction, and nothing "
      "tangential is computed");
  f.number_or_formula("friction bound", o.bound, at_least(0), friction_bound_variables, "force/length^2",
                      "Tresca's: greatest tangential traction wherever surfaces touch, whatever the pressure");
  f.rule("D19", {"friction bound", "friction coefficient"}, !o.bound || !o.coefficient,
         "contradicts \"friction coefficient\": take one of them");
  f.optional(
      "tangential penalty", o.tangential_penalty, positive, "force/length^3",
      "stiffness of stick per area, as a spring that is let out at the bound (thesis eqs. 5.123-5.127); left out: exact stick");
  f.optional("slip regularisation", o.slip_regularisation, positive, "length/time",
             "for comparison with other programs: no stick, the traction is the bound times v / sqrt(v^2 + this^2) against the "
             "slip velocity, so that what should rest creeps; left out: stick and slip");
  f.rule("D19", {"slip regularisation", "tangential penalty"}, !o.slip_regularisation || !o.tangential_penalty,
         "contradicts \"tangential penalty\": nothing sticks");
  f.choice(
      "slip", o.slip,
      Choices<SlipForm>{{"automatic", SlipForm::automatic}, {"thesis", SlipForm::thesis}, {"moment free", SlipForm::moment_free}},
      Presence::optional,
      "how the slip of a step is measured. thesis: motion weighted with the mortar integrals (eq. 5.124). moment free: the same "
      "without the spin of each pair of facets, with a force that has no moment; objective. automatic: moment free where the "
      "scheme's forces act within the step, else thesis");
  f.only_with({"tangential penalty", "slip regularisation", "slip"}, "friction coefficient", o.acts(),
              "\"friction coefficient\" or \"friction bound\"");
}

}  // namespace mortise
