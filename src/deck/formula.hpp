// Formulas of the deck in t, x, y, z (reference position) or other variables, compiled once by muParser.
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
  /// @param variables at most four names
  /// @throws std::invalid_argument with muParser's reason and the position in the text
  Formula(const std::string& text, const Named<TableOptions>& tables,
          const std::vector<std::string>& variables = {"t", "x", "y", "z"});

  /// Value at time `t` and reference position `X`; NaN or infinity is returned as such, for the caller to refuse.
  double operator()(double t, const std::array<double, 3>& X) const;

  /// Value where its variables have these values, in their order; the rest is of no account. As above.
  double at(const std::array<double, 4>& values) const;

  const std::string& text() const;

 private:
  struct Compiled;
  std::shared_ptr<Compiled> compiled_;
};

/// The table's piecewise linear function; constant outside its arguments. NaN gives NaN.
double table_value(const TableOptions& table, double argument);

/// Every name that stands in a formula: variables, constants, functions, tables.
std::vector<std::string> names_in_formula(const std::string& text);

/// Constants and functions that every formula may use, and the variables t, x, y, z.
std::vector<std::string> formula_names();

}  // namespace mortise
