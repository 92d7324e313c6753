// What the fuzzers feed with bytes; the ordinary tests run the same functions on the kept inputs.
#pragma once

#include <sstream>
#include <stdexcept>
#include <string>

#include "deck/deck.hpp"
#include "errors.hpp"
#include "mesh/netcdf_header.hpp"

namespace mortise::test {

/// Reads a text as a deck with all checks that need no mesh. A refusal must be a UserError with words; anything else is a
/// finding.
/// @return whether the deck is accepted
inline bool feed_deck(const std::string& text) {
  try {
    const Deck deck = Deck::from_text("deck.xml", text);
    // Later errors point into the text: that must work for every entry of a deck that was accepted.
    for (const auto& entry : deck.options().meshes) deck.error("M00", {"meshes", entry.first, "file"}, "words");
    return true;
  } catch (const UserError& error) {
    if (std::string(error.what()).empty()) throw std::logic_error("a deck is refused without a word");
    return false;
  }
}

/// Reads bytes as the header of a mesh file.
/// @return whether the header is sound
inline bool feed_netcdf_header(const std::string& bytes) {
  std::istringstream in(bytes);
  const NetcdfHeader header = parse_netcdf_header(in, bytes.size());
  return header.kind != FileKind::other && header.fault.empty();
}

}  // namespace mortise::test
