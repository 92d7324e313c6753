// The end of an HDF5 file by its superblock.
#include "mesh/hdf5_superblock.hpp"

#include <fmt/format.h>

namespace mortise {

std::uint64_t hdf5_end_of_file(ByteReader& in) {
  if (in.bytes(8) != "\x89HDF\r\n\x1a\n") throw HeaderFault("the HDF5 signature is damaged");
  const std::uint64_t version = in.little_endian(1);
  if (version > 3) throw HeaderFault(fmt::format("HDF5 superblock version {} - 0 to 3 are known", version));

  const bool is_old = version < 2;
  if (is_old) in.skip(4);  // versions of the free space, the root group, a reserved byte, the shared header messages
  const std::uint64_t offset_size = in.little_endian(1), length_size = in.little_endian(1);
  for (std::uint64_t size : {offset_size, length_size})
    if (size != 2 && size != 4 && size != 8) throw HeaderFault(fmt::format("HDF5 addresses of {} bytes - 2, 4 or 8", size));
  in.skip(is_old ? 1 + 2 + 2 + 4 : 1);  // reserved, leaf and internal node sizes, flags; or flags alone
  if (version == 1) in.skip(4);         // node size of indexed storage

  if (in.little_endian(offset_size) != 0) throw HeaderFault("the HDF5 base address is not 0");
  in.skip(offset_size);  // free space index, or superblock extension
  return in.little_endian(offset_size);
}

}  // namespace mortise
