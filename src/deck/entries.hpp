// What the entries of a deck are called, by what they have in common.
#pragma once

#include "deck/names.hpp"

namespace mortise {

template <class Options>
std::vector<std::string> names_in(const Named<Options>& entries) {
  std::vector<std::string> names;
  for (const auto& entry : entries) names.push_back(entry.first);
  return names;
}

/// Names of several lists, one list after the other.
template <class... Options>
std::vector<std::string> names_in_all(const Named<Options>&... lists) {
  std::vector<std::string> names;
  const auto append = [&](const std::vector<std::string>& more) { names.insert(names.end(), more.begin(), more.end()); };
  (append(names_in(lists)), ...);
  return names;
}

/// All that moves by its mass: initial conditions and body forces know it by its name.
inline std::vector<std::string> moving_names(const DeckOptions& options) {
  return names_in_all(options.bodies, options.masses, options.strings);
}

/// All that has contact pressures.
inline std::vector<std::string> contact_names(const DeckOptions& options) {
  return names_in_all(options.contact, options.obstacles, options.rods);
}

/// All that has a contact force: the history has columns for each by its name.
inline std::vector<std::string> force_names(const DeckOptions& options) {
  return names_in_all(options.contact, options.ties, options.obstacles, options.rods);
}

/// The supports that bodies in plane strain make.
inline std::vector<std::string> plane_strain_supports(const DeckOptions& options) {
  std::vector<std::string> names;
  for (const auto& [name, body] : options.bodies)
    if (body.kinematics == Kinematics::plane_strain) names.push_back(plane_strain_support(name));
  return names;
}

/// f(list, entries) for each list of entries that have an `activity`.
template <class Deck, class Function>
void for_each_acting_list(Deck& options, Function f) {
  f("supports", options.supports);
  f("springs", options.springs);
  f("loads", options.loads);
  f("contact", options.contact);
  f("ties", options.ties);
  f("obstacles", options.obstacles);
  f("rods", options.rods);
}

}  // namespace mortise
