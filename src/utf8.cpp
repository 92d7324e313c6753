// Whether text is UTF-8, and how text that may be anything is shown.
#include "utf8.hpp"

namespace mortise {

std::size_t first_bad_byte(const std::string& text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = static_cast<unsigned char>(text[i]);
    std::size_t following = 0;
    if (byte >= 0xF0 && byte < 0xF5) {
      following = 3;
    } else if (byte >= 0xE0 && byte < 0xF0) {
      following = 2;
    } else if (byte >= 0xC2 && byte < 0xE0) {
      following = 1;
    } else if (byte == 0 || byte >= 0x80) {
      return i;
    }
    for (std::size_t k = 1; k <= following; ++k) {
      if (i + k >= text.size() || (static_cast<unsigned char>(text[i + k]) & 0xC0u) != 0x80u) return i;
    }
    i += following + 1;
  }
  return std::string::npos;
}

std::string printable(std::string text) {
  for (std::size_t bad = first_bad_byte(text); bad != std::string::npos; bad = first_bad_byte(text)) text[bad] = '?';
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 32 || c == 127) c = '?';
  return text;
}

}  // namespace mortise
