#include "scene_loads.hpp"

#include <fmt/format.h>

#include <cmath>

namespace mortise {

double evaluate(const PlacedFormula& formula, double t, const Point& X, std::string& fault) {
  const double v = formula.formula(t, X);
  if (!std::isfinite(v) && fault.empty())
    fault = fmt::format("{}gives {} at t = {}, x = {}, y = {}, z = {} - must be a finite number", formula.where, v, t, X[0], X[1],
                        X[2]);
  return v;
}

Vec3<double> evaluate(const PlacedVector& formulas, double t, const Point& X, std::string& fault) {
  Vec3<double> values{0, 0, 0};
  for (int i = 0; i < 3; ++i)
    if (formulas[i]) values[i] = evaluate(*formulas[i], t, X, fault);
  return values;
}

bool Support::holds(int axis) const {
  if (const auto* displacement = std::get_if<motions::Displacement>(&motion)) return displacement->displacement[axis].has_value();
  if (const auto* velocity = std::get_if<motions::Velocity>(&motion)) return velocity->velocity[axis].has_value();
  if (const auto* symmetry = std::get_if<motions::Symmetry>(&motion)) return symmetry->axis == axis;
  return true;
}

bool Load::follows() const {
  const auto* traction = std::get_if<forces::SideTraction>(&what);
  return std::holds_alternative<forces::SidePressure>(what) || (traction && traction->over_current_area);
}

const std::vector<Side>& Load::sides() const {
  const auto* traction = std::get_if<forces::SideTraction>(&what);
  return traction ? traction->sides : std::get<forces::SidePressure>(what).sides;
}

}  // namespace mortise
