// Applies the bounds and rules of a description to data that no deck was read for.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "mesh/checks.hpp"
#include "mesh/recipes/descriptions.hpp"

namespace mortise::recipes {

/// The checking kind of Fields (deck/fields.hpp), with the verbs that recipes use.
class DataCheck {
 public:
  explicit DataCheck(const std::string& source) : errors_(source) {}

  template <class T>
  void required(const std::string& name, const T& value, const Bound& bound, const std::string&, const std::string&) {
    shown_[name] = show(value);
    const auto outside = first_outside(bound, value);
    if (outside) fail(name, *outside + "must be " + bound.text);
  }
  template <class T>
  void optional(const std::string& name, const T& value, const Bound& bound, const std::string& unit, const std::string& help) {
    required(name, value, bound, unit, help);
  }
  template <class T, class V>
  void choice(const std::string&, const T&, const Choices<V>&, Presence, const std::string&) {}
  void rule(const std::string&, const std::vector<std::string>& names, bool holds, const std::string& text,
            const std::string& limit = "") {
    const bool is_judged = std::none_of(names.begin(), names.end(), [this](const auto& name) { return failed_.count(name) > 0; });
    if (!holds && is_judged) fail(names.front(), text + limit);
  }

  /// @throws MeshError with every bound and rule that is broken (M41)
  void throw_if_any() const { errors_.throw_if_any(); }

 private:
  void fail(const std::string& name, const std::string& what) {
    failed_.insert(name);
    errors_.add("M41", fmt::format("\"{}\" = {} - {}", name, shown_[name], what));
  }

  MeshErrors errors_;
  std::map<std::string, std::string> shown_;
  std::set<std::string> failed_;
};

/// @throws MeshError if data of a recipe break its description
template <class Kind>
void check_data(Kind o) {
  DataCheck check(fmt::format("recipe \"{}\"", Kind::name));
  describe(check, o);
  check.throw_if_any();
}

}  // namespace mortise::recipes
