// Texts to numbers and back, the same in every locale.
#pragma once

#include <string>
#include <vector>

namespace mortise {

/// `text` without the blanks at its ends.
std::string trimmed(const std::string& text);

/// Each of these reads the whole of `text` (blanks around it are allowed) into `value`.
/// @return an empty string, or why the text is refused ("is not a number"), with `value` unchanged
std::string parse(const std::string& text, double& value);  ///< finite decimal numbers only: no hexadecimal, inf, nan
std::string parse(const std::string& text, int& value);     ///< decimal, in the range of int
std::string parse(const std::string& text, bool& value);    ///< true or false
std::string parse(const std::string& text, std::string& value);

/// Splits `{a, b}` into its entries, without the blanks around them; `{}` has none.
/// @return as `parse`
std::string split_array(const std::string& text, std::vector<std::string>& entries);

/// The shortest text that reads back as `value`.
std::string shortest(double value);

}  // namespace mortise
