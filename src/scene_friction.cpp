#include "scene_friction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace mortise {
namespace {

/// The derivative of f >= 0 at x >= 0 by differences of step h: central, of fourth order, or one-sided of second order next to 0.
/// Where f has no value nearby it is taken as constant.
template <class Function>
double difference(Function f, double x, double h) {
  const double slope = x >= 2 * h ? (8 * (f(x + h) - f(x - h)) - (f(x + 2 * h) - f(x - 2 * h))) / (12 * h)
                                  : (4 * f(x + h) - f(x + 2 * h) - 3 * f(x)) / (2 * h);
  return std::isfinite(slope) ? slope : 0;
}

std::string number_or_text(const std::variant<double, PlacedFormula>& value) {
  if (const double* number = std::get_if<double>(&value)) return fmt::format("{:g}", *number);
  return "\"" + std::get<PlacedFormula>(value).formula.text() + "\"";
}

std::string in_words(const friction::Coulomb& law) { return "Coulomb's friction " + number_or_text(law.coefficient); }
std::string in_words(const friction::Tresca& law) { return "Tresca's friction " + number_or_text(law.bound); }

}  // namespace

FrictionCoefficient coefficient_at(const friction::Coulomb& law, double t, double p, double v, double no_speed,
                                   std::string& fault) {
  if (const double* number = std::get_if<double>(&law.coefficient)) return {*number, *number};
  const PlacedFormula& placed = std::get<PlacedFormula>(law.coefficient);
  const auto mu = [&](double pressure, double speed) { return placed.formula.at({t, pressure, speed}); };
  constexpr double part = 1e-4;
  const double p0 = std::max(p, 0.0);
  FrictionCoefficient at{mu(p0, v), mu(p0, 0)};
  if (!(std::isfinite(at.value) && at.value >= 0) && fault.empty())
    fault = fmt::format("{}gives {} at t = {}, p = {}, v = {} - must be a finite number that is not negative", placed.where,
                        at.value, t, p0, v);
  if (p > 0) at.of_pressure = difference([&](double pressure) { return mu(pressure, v); }, p, part * p);
  at.of_speed = difference([&](double speed) { return mu(p0, speed); }, v, part * std::max(v, no_speed));
  return at;
}

double bound_at(const friction::Tresca& law, double t, std::string& fault) {
  if (const double* number = std::get_if<double>(&law.bound)) return *number;
  const PlacedFormula& placed = std::get<PlacedFormula>(law.bound);
  const double bound = placed.formula.at({t});
  if (!(std::isfinite(bound) && bound >= 0) && fault.empty())
    fault = fmt::format("{}gives {} at t = {} - must be a finite number that is not negative", placed.where, bound, t);
  return bound;
}

void check(const Friction& friction, double t, std::string& fault) {
  if (const auto* coulomb = std::get_if<friction::Coulomb>(&friction.law)) {
    coefficient_at(*coulomb, t, 0, 0, 1, fault);
  } else {
    bound_at(std::get<friction::Tresca>(friction.law), t, fault);
  }
}

std::string in_words(const Friction& friction) {
  const std::string stick = friction.penalty ? fmt::format("stick penalised by {:g}", *friction.penalty)
                            : friction.regularisation
                                ? fmt::format("regularised by a slip speed of {:g}", *friction.regularisation)
                                : "exact stick";
  return std::visit([](const auto& law) { return in_words(law); }, friction.law) + ", " + stick;
}

}  // namespace mortise
