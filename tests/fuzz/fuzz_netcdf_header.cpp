// libFuzzer target: the header of a mesh file.
#include <cstddef>
#include <cstdint>

#include "fuzz/entries.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t n) {
  mortise::test::feed_netcdf_header(std::string(reinterpret_cast<const char*>(bytes), n));
  return 0;
}
