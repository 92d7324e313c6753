// Compiles and evaluates formulas with muParser.
#include "deck/formula.hpp"

#include <muParser.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "errors.hpp"

namespace mortise {

namespace {

constexpr double pi = 3.14159265358979323846;

bool is_name_character(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// muParser would assign to t, x, y or z in "t = 1", and take the last value of "0,5*t".
void refuse_assignment(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '=') continue;
    const bool is_comparison_end = i > 0 && std::string("=<>!").find(text[i - 1]) != std::string::npos;
    const bool is_comparison_start = i + 1 < text.size() && text[i + 1] == '=';
    if (!is_comparison_end && !is_comparison_start) {
      throw std::invalid_argument("assignment \"=\" at position " + std::to_string(i + 1) + "; to compare, write ==");
    }
  }
}

}  // namespace

double table_value(const TableOptions& table, double argument) {
  if (std::isnan(argument)) return argument;
  const std::vector<double>& arguments = table.arguments;
  const auto above = std::upper_bound(arguments.begin(), arguments.end(), argument);
  if (above == arguments.begin()) return table.values.front();
  if (above == arguments.end()) return table.values.back();
  const auto k = static_cast<std::size_t>(above - arguments.begin());
  const double weight = (argument - arguments[k - 1]) / (arguments[k] - arguments[k - 1]);
  return (1 - weight) * table.values[k - 1] + weight * table.values[k];
}

std::vector<std::string> names_in_formula(const std::string& text) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    while (end < text.size() && is_name_character(text[end])) ++end;
    // A number such as 2e3 is a run of name characters too, but begins with a digit.
    if (end > i && std::isdigit(static_cast<unsigned char>(text[i])) == 0) names.push_back(text.substr(i, end - i));
    i = std::max(end, i + 1);
  }
  return names;
}

namespace {

/// What a formula in these variables may use, tables apart.
std::vector<std::string> names_beside(std::vector<std::string> variables) {
  mu::Parser parser;
  variables.emplace_back("pi");
  for (const auto& function : parser.GetFunDef()) variables.push_back(function.first);
  for (const auto& constant : parser.GetConst()) variables.push_back(constant.first);
  return variables;
}

}  // namespace

std::vector<std::string> formula_names() { return names_beside({"t", "x", "y", "z"}); }

struct Formula::Compiled {
  std::string text;
  std::vector<TableOptions> tables;  // muParser keeps pointers to these: not changed after compilation
  std::array<double, 4> point{};     // values of the variables: muParser reads them here
  mu::Parser parser;

  static double look_up(void* table, double argument) { return table_value(*static_cast<const TableOptions*>(table), argument); }
};

Formula::Formula(const std::string& text, const Named<TableOptions>& tables, const std::vector<std::string>& variables)
    : compiled_(std::make_shared<Compiled>()) {
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) throw std::invalid_argument("the formula is empty");
  if (text.find('"') != std::string::npos) throw std::invalid_argument("a formula has no strings");
  refuse_assignment(text);
  compiled_->text = text;
  std::vector<std::string> known = names_beside(variables);
  mu::Parser& parser = compiled_->parser;
  try {
    for (std::size_t i = 0; i < variables.size(); ++i) parser.DefineVar(variables[i], &compiled_->point.at(i));
    parser.DefineConst("pi", pi);
    for (const auto& table : tables) compiled_->tables.push_back(table.second);
    for (std::size_t i = 0; i < tables.size(); ++i) {
      parser.DefineFunUserData(tables[i].first, &Compiled::look_up, static_cast<void*>(&compiled_->tables[i]));
      known.push_back(tables[i].first);
    }
    parser.SetExpr(text);
    parser.Eval();  // compiles; the value at the origin may well be infinite
    if (parser.GetNumResults() != 1) {
      throw std::invalid_argument("a comma outside a function's arguments (the decimal sign is a point)");
    }
  } catch (const mu::ParserError& error) {
    const bool is_name = error.GetCode() == mu::ecUNASSIGNABLE_TOKEN;
    const std::vector<std::string> unknown = is_name ? names_in_formula(error.GetToken()) : std::vector<std::string>{};
    throw std::invalid_argument(error.GetMsg() + (unknown.empty() ? "" : did_you_mean(unknown.front(), known)));
  }
}

double Formula::operator()(double t, const std::array<double, 3>& X) const { return at({t, X[0], X[1], X[2]}); }

double Formula::at(const std::array<double, 4>& values) const {
  compiled_->point = values;
  try {
    return compiled_->parser.Eval();
  } catch (const mu::ParserError&) {  // a domain error, where muParser was built to throw them
    return std::numeric_limits<double>::quiet_NaN();
  }
}

const std::string& Formula::text() const { return compiled_->text; }

}  // namespace mortise
