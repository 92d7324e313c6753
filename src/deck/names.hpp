// Words of decks that are printed as well as read.
#pragma once

#include "deck/fields.hpp"
#include "deck/options.hpp"

namespace mortise {

inline const Choices<FormulationKind> formulation_names{{"standard", FormulationKind::standard},
                                                        {"f-bar", FormulationKind::f_bar},
                                                        {"enhanced strain", FormulationKind::enhanced},
                                                        {"mixed", FormulationKind::mixed}};

inline const Choices<TangentKind> tangent_names{{"quadrature point", TangentKind::quadrature_point},
                                                {"analytic", TangentKind::analytic},
                                                {"whole element", TangentKind::whole_element},
                                                {"complex step", TangentKind::complex_step},
                                                {"central differences", TangentKind::central_differences},
                                                {"forward differences", TangentKind::forward_differences},
                                                {"backward differences", TangentKind::backward_differences}};

/// The name of the support that a body in plane strain makes.
inline std::string plane_strain_support(const std::string& body) { return "plane strain of " + body; }

/// The word that stands for a value.
template <class Value>
const std::string& word_for(const Choices<Value>& choices, Value value) {
  for (const auto& [word, one] : choices)
    if (one == value) return word;
  return choices.front().first;
}

}  // namespace mortise
