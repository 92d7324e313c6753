// Texts to numbers and back, the same in every locale.
#include "deck/numbers.hpp"

#include <charconv>
#include <cmath>

namespace mortise {

namespace {

/// A number as std::from_chars wants it: it takes no plus sign.
std::string number_text(const std::string& text) {
  std::string number = trimmed(text);
  if (number.size() > 1 && number[0] == '+' && number[1] != '-' && number[1] != '+') number.erase(0, 1);
  return number;
}

template <class Number>
std::string parse_number(const std::string& text, Number& value, const std::string& kind, const std::string& range) {
  const std::string number = number_text(text);
  if (number.empty()) return "is empty, not " + kind;
  Number parsed{};
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), parsed);
  const bool is_whole = end == number.data() + number.size();
  if (error == std::errc::result_out_of_range && is_whole) return range;
  if (error != std::errc() || !is_whole) return "is not " + kind;
  value = parsed;
  return "";
}

}  // namespace

std::string trimmed(const std::string& text) {
  const char* blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string parse(const std::string& text, double& value) {
  double parsed = 0;
  const std::string reason = parse_number(text, parsed, "a number", "is too large or too small for a double");
  if (!reason.empty()) {
    const bool has_comma = reason == "is not a number" && text.find(',') != std::string::npos;
    return reason + (has_comma ? " (the decimal sign is a point)" : "");
  }
  if (!std::isfinite(parsed)) return "is not a finite number";
  value = parsed;
  return "";
}

std::string parse(const std::string& text, int& value) {
  return parse_number(text, value, "an integer", "is out of the range of integers, -2147483648 to 2147483647");
}

std::string parse(const std::string& text, bool& value) {
  const std::string word = trimmed(text);
  if (word != "true" && word != "false") return "is neither true nor false";
  value = word == "true";
  return "";
}

std::string parse(const std::string& text, std::string& value) {
  value = text;
  return "";
}

std::string split_array(const std::string& text, std::vector<std::string>& entries) {
  const std::string array = trimmed(text);
  if (array.size() < 2 || array.front() != '{' || array.back() != '}') return "is not an array; write {a, b}";
  const std::string inside = array.substr(1, array.size() - 2);
  if (inside.find_first_of("{}") != std::string::npos) return "has braces inside an array; write {a, b}";
  std::vector<std::string> found;
  if (!trimmed(inside).empty()) {
    std::size_t start = 0;
    for (std::size_t comma = inside.find(','); comma != std::string::npos; comma = inside.find(',', start)) {
      found.push_back(trimmed(inside.substr(start, comma - start)));
      start = comma + 1;
    }
    found.push_back(trimmed(inside.substr(start)));
  }
  for (const std::string& entry : found) {
    if (entry.empty()) return "has an empty entry";
  }
  entries = std::move(found);
  return "";
}

std::string shortest(double value) {
  char digits[32];
  if (value == std::trunc(value) && std::abs(value) < 1e9) {  // 1000000 rather than 1e+06
    const auto [end, error] = std::to_chars(digits, digits + sizeof digits, static_cast<int>(value));
    return error == std::errc() ? std::string(digits, end) : "?";
  }
  const auto [end, error] = std::to_chars(digits, digits + sizeof digits, value);
  return error == std::errc() ? std::string(digits, end) : "?";
}

}  // namespace mortise
