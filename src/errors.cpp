// Composes the text of user errors, with suggestions for misspelt names.
#include "errors.hpp"

#include <algorithm>

namespace mortise {

namespace {

constexpr std::size_t listed_errors = 20;

std::string in_lines(const std::vector<std::string>& messages) {
  std::string text;
  for (std::size_t i = 0; i < std::min(messages.size(), listed_errors); ++i) {
    if (i > 0) text += '\n';
    text += messages[i];
  }
  if (messages.size() > listed_errors) {
    const std::size_t rest = messages.size() - listed_errors;
    text += "\nand " + std::to_string(rest) + (rest == 1 ? " more error" : " more errors");
  }
  return text;
}

/// Damerau-Levenshtein distance in its restricted form (insert, delete, replace, swap two neighbours once).
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before_last, last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({replaced, last[j] + 1, row[j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
    before_last = last;
    last = row;
  }
  return last[b.size()];
}

}  // namespace

UserError::UserError(ExitCode code, const std::vector<std::string>& messages)
    : std::runtime_error(in_lines(messages)), code_(code) {}

std::string nearest_name(const std::string& name, const std::vector<std::string>& known) {
  const std::size_t allowed = std::max<std::size_t>(1, name.size() / 3);
  std::size_t smallest = allowed + 1;
  std::string nearest;
  for (const std::string& candidate : known) {
    // The distance is at least the difference of the lengths: long names cost nothing.
    if (candidate.size() > name.size() + allowed || name.size() > candidate.size() + allowed) continue;
    const std::size_t distance = edit_distance(name, candidate);
    if (distance < smallest) {
      smallest = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

std::string did_you_mean(const std::string& name, const std::vector<std::string>& known) {
  const std::string nearest = nearest_name(name, known);
  return nearest.empty() ? "" : "; did you mean \"" + nearest + "\"?";
}

std::string join(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

}  // namespace mortise
