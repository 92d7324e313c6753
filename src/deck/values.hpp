// One parameter of the deck to one value of an option struct: types, and how they are shown.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "deck/numbers.hpp"
#include "deck/source.hpp"

namespace mortise {

/// The type of a parameter as a deck writes it.
inline std::string type_name(const double&) { return "double"; }
inline std::string type_name(const int&) { return "int"; }
inline std::string type_name(const bool&) { return "bool"; }
inline std::string type_name(const std::string&) { return "string"; }
template <class T>
std::string type_name(const std::vector<T>&) {
  return "Array(" + type_name(T{}) + ")";
}
template <class T, std::size_t N>
std::string type_name(const std::array<T, N>&) {
  return "Array(" + type_name(T{}) + ")";
}
template <class T>
std::string type_name(const std::optional<T>&) {
  return type_name(T{});
}

/// The number of entries a value must have, as text for the reference; empty where it is free or there is one.
template <class T>
std::string entry_count(const T&) {
  return "";
}
template <class T, std::size_t N>
std::string entry_count(const std::array<T, N>&) {
  return std::to_string(N) + " entries";
}
template <class T>
std::string entry_count(const std::optional<T>&) {
  return entry_count(T{});
}

/// A value as a deck writes it.
inline std::string show(double value) { return shortest(value); }
inline std::string show(int value) { return std::to_string(value); }
inline std::string show(bool value) { return value ? "true" : "false"; }
inline std::string show(const std::string& value) { return value; }
template <class Sequence>
std::string show_sequence(const Sequence& values) {
  std::string text;
  for (const auto& value : values) text += (text.empty() ? "" : ", ") + show(value);
  return "{" + text + "}";
}
template <class T>
std::string show(const std::vector<T>& values) {
  return values.empty() ? "" : show_sequence(values);
}
template <class T, std::size_t N>
std::string show(const std::array<T, N>& values) {
  return show_sequence(values);
}
template <class T>
std::string show(const std::optional<T>& value) {
  return value ? show(*value) : "";
}

/// True for an array without entries.
template <class T>
bool is_empty(const T&) {
  return false;
}
template <class T>
bool is_empty(const std::vector<T>& values) {
  return values.empty();
}

/// True if a value of the declared type may be read as `wanted`: the same, or integers where doubles are wanted.
inline bool is_type_allowed(const std::string& declared, const std::string& wanted) {
  return declared == wanted || (declared == "int" && wanted == "double") ||
         (declared == "Array(int)" && wanted == "Array(double)");
}

/// Reads one number that was declared as `declared`.
/// @return an empty string, or why the text is refused
template <class T>
std::string parse_declared(const std::string& text, const std::string& declared, T& value) {
  if constexpr (std::is_same_v<T, double>) {
    if (declared == "int" || declared == "Array(int)") {
      int integer = 0;
      if (const std::string reason = parse(text, integer); !reason.empty()) return reason;
      value = integer;
      return "";
    }
  }
  return parse(text, value);
}

/// Reads the value of a parameter whose type is allowed.
/// @return an empty string, or why the text is refused, with `value` unchanged
template <class T>
std::string read_value(const DeckParameter& parameter, T& value) {
  return parse_declared(parameter.value, parameter.type, value);
}
template <class T>
std::string read_value(const DeckParameter& parameter, std::vector<T>& values) {
  std::vector<std::string> entries;
  if (const std::string reason = split_array(parameter.value, entries); !reason.empty()) return reason;
  std::vector<T> found(entries.size());
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const std::string reason = parse_declared(entries[i], parameter.type, found[i]);
    if (!reason.empty()) return "entry " + std::to_string(i + 1) + ", " + in_quotes(entries[i]) + ", " + reason;
  }
  values = std::move(found);
  return "";
}
template <class T, std::size_t N>
std::string read_value(const DeckParameter& parameter, std::array<T, N>& values) {
  std::vector<T> found;
  if (const std::string reason = read_value(parameter, found); !reason.empty()) return reason;
  if (found.size() != N) return "has " + std::to_string(found.size()) + " entries, must have " + std::to_string(N);
  for (std::size_t i = 0; i < N; ++i) values[i] = found[i];
  return "";
}
template <class T>
std::string read_value(const DeckParameter& parameter, std::optional<T>& value) {
  T found{};
  const std::string reason = read_value(parameter, found);
  if (reason.empty()) value = found;
  return reason;
}

}  // namespace mortise
