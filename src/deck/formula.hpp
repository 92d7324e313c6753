// Formulas of the deck in t, x, y, z (reference position), compiled once by muParser.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "deck/options.hpp"

namespace mortise {

/// A compiled formula. Copies share the compiled code; not for use from several threads.
class Formula {
 public:
  /// Compiles `text`; `tables` may be called as functions of one argument.
  /// @throws std::invalid_argument with muParser's reason and the position in the text
  Formula(const std::string& text, const Named<TableOptions>& tables);

  /// Value at time `t` and reference position `X`; NaN or infinity is returned as such, for the caller to refuse.
  double operator()(double t, const std::array<double, 3>& X) const;

  const std::string& text() const;

 private:
  struct Compiled;
  std::shared_ptr<Compiled> compiled_;
};

/// The table's piecewise linear function; constant outside its arguments. NaN gives NaN.
double table_value(const TableOptions& table, double argument);

/// Every name that stands in a formula: variables, constants, functions, tables.
std::vector<std::string> names_in_formula(const std::string& text);

/// Variables, constants and functions that every formula may use.
std::vector<std::string> formula_names();

}  // namespace mortise
