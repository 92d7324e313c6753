// Which formulations exist on which element types: the one place where both meet.
#pragma once

#include "deck/options.hpp"
#include "mesh/topology.hpp"
#include "physics/formulations/enhanced.hpp"
#include "physics/formulations/f_bar.hpp"
#include "physics/formulations/mixed.hpp"
#include "physics/formulations/standard.hpp"

namespace mortise {

/// Calls f(formulation) with a value of the type for `kind` on elements of `type`. @return false if there is no such formulation
template <class Function>
bool with_formulation(FormulationKind kind, ElementType type, Function f) {
  if (!is_solid(type)) return false;
  switch (kind) {
    case FormulationKind::standard:
      with_element(type, [&](auto element) { f(Standard<decltype(element)>{}); });
      return true;
    case FormulationKind::f_bar:
      if (type == ElementType::hex8) f(FBar<Hex8>{});
      return type == ElementType::hex8;
    case FormulationKind::enhanced:
      if (type == ElementType::hex8) f(Enhanced<Hex8>{});
      return type == ElementType::hex8;
    case FormulationKind::mixed:
      if (type == ElementType::hex8) f(Mixed<Hex8, 1>{});
      if (type == ElementType::hex27) f(Mixed<Hex27, 4>{});
      return type == ElementType::hex8 || type == ElementType::hex27;
  }
  return false;
}

/// Pressures per element of a formulation that exists.
inline int n_pressures(FormulationKind kind, ElementType type) {
  int n = 0;
  with_formulation(kind, type, [&](auto formulation) { n = formulation.n_pressures; });
  return n;
}

}  // namespace mortise
