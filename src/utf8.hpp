// Whether text is UTF-8, and how text that may be anything is shown.
#pragma once

#include <string>

namespace mortise {

/// Offset of the first byte that is not UTF-8 (nor is there a NUL in UTF-8 text), or npos.
std::size_t first_bad_byte(const std::string& text);

/// `text` fit for a line of a message: what is neither UTF-8 nor printable becomes `?`.
std::string printable(std::string text);

}  // namespace mortise
