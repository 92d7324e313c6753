// Bounds of numbers in the deck: small predicates that can say what they allow.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "deck/numbers.hpp"
#include "deck/values.hpp"

namespace mortise {

/// What a number, or each entry of an array, must fulfil.
struct Bound {
  std::string text;                   ///< completes "must be ...", e.g. "> 0"; empty: anything
  std::function<bool(double)> holds;  ///< empty: anything
  std::string reason;                 ///< why, where a user would ask

  /// The same bound, with a reason that is printed with the error.
  Bound because(std::string why) const { return {text, holds, std::move(why)}; }
};

inline const Bound anything{};
inline const Bound positive{"> 0", [](double x) { return x > 0; }, ""};

/// x >= lower
inline Bound at_least(double lower) {
  return {">= " + shortest(lower), [=](double x) { return x >= lower; }, ""};
}
/// lower < x < upper
inline Bound between(double lower, double upper) {
  return {"in (" + shortest(lower) + ", " + shortest(upper) + ")", [=](double x) { return x > lower && x < upper; }, ""};
}
/// lower <= x <= upper
inline Bound within(double lower, double upper) {
  return {"in [" + shortest(lower) + ", " + shortest(upper) + "]", [=](double x) { return x >= lower && x <= upper; }, ""};
}

/// The first number of `value` that breaks the bound, as text; nothing if all keep it (and for values without numbers).
inline std::optional<std::string> first_outside(const Bound& bound, double value) {
  if (!bound.holds || bound.holds(value)) return std::nullopt;
  return "";
}
inline std::optional<std::string> first_outside(const Bound&, const std::string&) { return std::nullopt; }
template <class Sequence>
std::optional<std::string> first_outside_of(const Bound& bound, const Sequence& values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (first_outside(bound, values[i])) return "entry " + std::to_string(i + 1) + ", " + show(values[i]) + ", ";
  }
  return std::nullopt;
}
template <class T>
std::optional<std::string> first_outside(const Bound& bound, const std::vector<T>& values) {
  return first_outside_of(bound, values);
}
template <class T, std::size_t N>
std::optional<std::string> first_outside(const Bound& bound, const std::array<T, N>& values) {
  return first_outside_of(bound, values);
}
template <class T>
std::optional<std::string> first_outside(const Bound& bound, const std::optional<T>& value) {
  return value ? first_outside(bound, *value) : std::nullopt;
}

}  // namespace mortise
