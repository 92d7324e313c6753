// libFuzzer target: the text of a deck.
#include <cstddef>
#include <cstdint>

#include "fuzz/entries.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t n) {
  mortise::test::feed_deck(std::string(reinterpret_cast<const char*>(bytes), n));
  return 0;
}
