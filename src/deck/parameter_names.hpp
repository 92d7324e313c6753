// Which names a description knows: what tells parameters of one kind from those of another.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "deck/bounds.hpp"
#include "deck/fields.hpp"
#include "deck/options.hpp"

namespace mortise {

/// The collecting kind of Fields (fields.hpp): the names directly in one list.
class ParameterNames {
 public:
  template <class T>
  void required(const std::string& name, const T&, const Bound&, const std::string&, const std::string&) {
    names.push_back(name);
  }
  template <class T>
  void optional(const std::string& name, const T&, const Bound&, const std::string&, const std::string&) {
    names.push_back(name);
  }
  template <class T, class V>
  void choice(const std::string& name, const T&, const Choices<V>&, Presence, const std::string&) {
    names.push_back(name);
  }
  template <class Kinds>
  void kind(const std::string& name, Kinds&, Presence, const std::string&) {
    names.push_back(name);
    for_each_kind<Kinds>([this](auto one) { describe(*this, one); });
  }
  void words(const std::string& name, const std::vector<std::string>&, const std::vector<std::string>&, const std::string&) {
    names.push_back(name);
  }
  void formula(const std::string& name, const std::optional<std::string>&, const std::string&, const std::string&) {
    names.push_back(name);
  }
  void number_or_formula(const std::string& name, const std::optional<NumberOrFormula>&, const Bound&,
                         const std::vector<std::string>&, const std::string&, const std::string&) {
    names.push_back(name);
  }
  template <class Options>
  void list(const std::string& name, const Options&, Presence, const std::string&) {
    names.push_back(name);
  }
  template <class Options>
  void named(const std::string& name, const Named<Options>&, Presence, const std::string&) {
    names.push_back(name);
  }
  void exactly_one_of(const std::vector<std::string>&) {}
  void at_least_one_of(const std::vector<std::string>&) {}
  void only_with(const std::vector<std::string>&, const std::string&, bool, const std::string&) {}
  void rule(const std::string&, const std::vector<std::string>&, bool, const std::string&, const std::string& = "") {}

  std::vector<std::string> names;
};

/// The names of each kind's own parameters, behind the kind's word.
template <class Kinds>
Choices<std::vector<std::string>> parameters_of_kinds() {
  Choices<std::vector<std::string>> kinds;
  for_each_kind<Kinds>([&](auto one) {
    ParameterNames parameters;
    describe(parameters, one);
    kinds.emplace_back(one.name, parameters.names);
  });
  return kinds;
}

}  // namespace mortise
