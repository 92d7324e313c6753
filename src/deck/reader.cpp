// The parts of the reader that do not depend on the type of a value.
#include "deck/reader.hpp"

#include <algorithm>
#include <iterator>
#include <map>

#include "errors.hpp"

namespace mortise {

namespace {

/// Why a name chosen by the user is refused, or an empty string. Such names become column names and parts of `mesh/set`.
std::string name_fault(const std::string& name) {
  if (name.empty()) return "a name must not be empty";
  if (name.front() == ' ' || name.back() == ' ') return "a name must not begin or end with a blank";
  for (const char c : name) {
    const std::string forbidden = ",./\"'";
    if (forbidden.find(c) != std::string::npos) return "a name must not contain a comma, dot, slash or quote";
    if (static_cast<unsigned char>(c) < 32) return "a name must not contain control characters";
  }
  return "";
}

}  // namespace

std::string quoted_names(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "\"" : ", \"") + name + "\"";
  return text;
}

std::string not_among(const std::string& what, const std::string& name, const std::vector<std::string>& known) {
  constexpr std::size_t shown = 30, searched = 1000;  // a deck with thousands of names and errors must not take minutes
  const auto first_of = [&](std::size_t n) {
    return std::vector<std::string>(known.begin(), known.begin() + static_cast<long>(std::min(known.size(), n)));
  };
  const std::string hint = did_you_mean(name, first_of(searched));
  return what + hint + (hint.empty() ? "; " : " ") + "allowed: " + (known.empty() ? "none" : join(first_of(shown))) +
         (known.size() > shown ? ", ..." : "");
}

void Reader::words(const std::string& name, std::vector<std::string>& target, const std::vector<std::string>& allowed,
                   const std::string&) {
  std::vector<std::string> found;
  if (!is_given(name, Presence::optional) || !has_type(name, type_name(found), "")) return;
  if (const std::string reason = read_value(*list_.parameter(name), found); !reason.empty()) {
    fail("D09", name, reason);
    return;
  }
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto entry = found.begin() + static_cast<long>(i);
    if (std::find(allowed.begin(), allowed.end(), found[i]) == allowed.end()) {
      fail("D10", name, not_among("does not know " + in_quotes(found[i]), found[i], allowed));
    } else if (std::find(found.begin(), entry, found[i]) != entry) {
      fail("D05", name, "repeats " + in_quotes(found[i]));
    }
  }
  target = std::move(found);
}

void Reader::formula(const std::string& name, std::optional<std::string>& target, const std::string&, const std::string&) {
  if (!is_given(name, Presence::optional) || !has_type(name, "string", " (a formula in t, x, y, z)")) return;
  target = list_.parameter(name)->value;
  findings_.formulas.push_back({below_path(name), *target});
}

void Reader::number_or_formula(const std::string& name, std::optional<NumberOrFormula>& target, const Bound& bound,
                               const std::vector<std::string>& variables, const std::string& unit, const std::string&) {
  if (!is_given(name, Presence::optional)) return;
  const DeckParameter& parameter = *list_.parameter(name);
  if (parameter.type == "string") {
    target = parameter.value;
    findings_.formulas.push_back({below_path(name), parameter.value, variables});
  } else if (double number = 0; has_type(name, "double", ", or \"string\" (a formula in " + join(variables) + ")") &&
                                read(name, number, bound, unit)) {
    target = number;
  }
}

void Reader::exactly_one_of(const std::vector<std::string>& names) {
  checks_.push_back([this, names] {
    std::map<std::pair<int, int>, std::string> set;  // in the order of the text
    for (const std::string& name : names) {
      if (failed_.count(name) > 0) return;
      if (const DeckParameter* parameter = list_.parameter(name)) set[{parameter->place.line, parameter->place.column}] = name;
      if (const DeckList* below = list_.list(name)) set[{below->place.line, below->place.column}] = name;
    }
    const std::string demand = "exactly one of " + quoted_names(names) + " must be set";
    if (set.empty()) fail_here("D12", demand + ", none is");
    if (set.size() < 2) return;
    fail("D12", std::next(set.begin())->second, demand + ", but " + in_quotes(set.begin()->second) + " is set already");
  });
}

void Reader::at_least_one_of(const std::vector<std::string>& names) {
  checks_.push_back([this, names] {
    const auto is_seen = [this](const std::string& name) { return is_set(name) || failed_.count(name) > 0; };
    if (std::any_of(names.begin(), names.end(), is_seen)) return;
    fail_here("D12", "at least one of " + quoted_names(names) + " must be set");
  });
}

void Reader::only_with(const std::vector<std::string>& names, const std::string& governor, bool holds, const std::string& text) {
  if (holds) return;
  checks_.push_back([this, names, governor, text] {
    if (failed_.count(governor) > 0) return;
    for (const std::string& name : names) {
      if (is_set(name)) fail("D13", name, "is set but unused: it has a meaning only with " + text);
    }
  });
}

void Reader::refuse_parameters_of_other_kinds(const std::string& governor, const Choices<std::vector<std::string>>& kinds) {
  const auto holds = [](const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  for (const auto& [word, parameters] : kinds) {
    for (const std::string& name : parameters) {
      if (holds(known_, name) || holds(of_other_kinds_, name)) continue;
      of_other_kinds_.push_back(name);
      std::string owners;
      for (const auto& [owner, names] : kinds) {
        if (holds(names, name)) owners += (owners.empty() ? "" : ", ") + in_quotes(owner);
      }
      checks_.push_back([this, holds, governor, name = name, owners] {
        if (!is_set(name) || failed_.count(governor) > 0 || holds(missing_, governor)) return;
        fail("D13", name, "is set but unused: it has a meaning only with " + in_quotes(governor) + " = " + owners);
      });
    }
  }
}

void Reader::rule(const std::string& code, const std::vector<std::string>& names, bool holds, const std::string& text,
                  const std::string& limit) {
  if (holds) return;
  checks_.push_back([this, code, names, what = text + limit] {
    for (const std::string& name : names) {
      const bool is_missing = std::find(missing_.begin(), missing_.end(), name) != missing_.end();
      if (is_missing || failed_.count(name) > 0) return;
    }
    const auto set = std::find_if(names.begin(), names.end(), [this](const std::string& name) { return is_set(name); });
    if (set != names.end()) {
      fail(code, *set, what);
    } else {
      fail_here(code, in_quotes(names.front()) + " " + what);
    }
  });
}

void Reader::finish() {
  const auto check_known = [this](const std::string& name, const char* kind) {
    if (std::find(known_.begin(), known_.end(), name) != known_.end()) return;
    if (std::find(of_other_kinds_.begin(), of_other_kinds_.end(), name) != of_other_kinds_.end()) return;
    fail("D06", name, not_among(std::string("unknown ") + kind, name, known_));
    // A misspelt name is one error: what it stands for is neither missing nor to be judged with others.
    const std::string meant = nearest_name(name, known_);
    if (meant.empty() || is_set(meant)) return;
    failed_.insert(meant);
    missing_.erase(std::remove(missing_.begin(), missing_.end(), meant), missing_.end());
  };
  for (const DeckParameter& parameter : list_.parameters) check_known(parameter.name, "parameter");
  for (const DeckList& below : list_.lists) check_known(below.name, "list");
  for (const std::string& name : missing_) fail_here("D07", "required " + in_quotes(name) + " is missing");
  for (const std::function<void()>& check : checks_) check();
}

bool Reader::is_given(const std::string& name, Presence presence) {
  known_.push_back(name);
  if (list_.list(name) != nullptr) return fail("D09", name, "must be a Parameter, not a ParameterList");
  const DeckParameter* parameter = list_.parameter(name);
  if (parameter == nullptr) {
    if (presence == Presence::required) missing_.push_back(name);
    return false;
  }
  if (!parameter->is_sound) failed_.insert(name);
  return parameter->is_sound;
}

bool Reader::has_type(const std::string& name, const std::string& wanted, const std::string& meaning) {
  const DeckParameter& parameter = *list_.parameter(name);
  if (is_type_allowed(parameter.type, wanted)) return true;
  return fail("D09", name, "must have type=\"" + wanted + "\"" + meaning + ", not \"" + parameter.type + "\"");
}

const DeckList* Reader::find_list(const std::string& name, Presence presence) {
  known_.push_back(name);
  if (list_.parameter(name) != nullptr) {
    fail("D09", name, "must be a ParameterList, not a Parameter");
    return nullptr;
  }
  const DeckList* below = list_.list(name);
  if (below == nullptr) {
    if (presence == Presence::required) missing_.push_back(name);
  } else if (presence != Presence::optional && below->lists.empty() && below->parameters.empty()) {
    fail("D18", name, "is declared but empty");
    return nullptr;
  }
  return below;
}

void Reader::check_entries(const DeckList& list, const std::string& name) {
  for (const DeckParameter& parameter : list.parameters) {
    std::vector<std::string> path = below_path(name);
    path.push_back(parameter.name);
    findings_.problems.push_back(
        source_.problem("D06", path, "unknown parameter; this list holds only lists, one for each named entry"));
  }
  for (const DeckList& entry : list.lists) {
    const std::string fault = name_fault(entry.name);
    if (fault.empty()) continue;
    std::vector<std::string> path = below_path(name);
    path.push_back(entry.name);
    findings_.problems.push_back(source_.problem("D11", path, fault));
  }
}

bool Reader::fail(const std::string& code, const std::string& name, const std::string& what, const std::string& unit) {
  failed_.insert(name);
  findings_.problems.push_back(source_.problem(code, below_path(name), what, unit));
  return false;
}

void Reader::fail_here(const std::string& code, const std::string& what) {
  findings_.problems.push_back(source_.problem(code, path_, what));
}

std::vector<std::string> Reader::below_path(const std::string& name) const {
  std::vector<std::string> path = path_;
  path.push_back(name);
  return path;
}

bool Reader::is_set(const std::string& name) const { return list_.parameter(name) != nullptr || list_.list(name) != nullptr; }

}  // namespace mortise
