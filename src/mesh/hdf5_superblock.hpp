// The end of an HDF5 file by its superblock, so that a truncated netCDF-4 file is refused before the library sees it.
#pragma once

#include <cstdint>

#include "mesh/byte_reader.hpp"

namespace mortise {

/// The size of the file by its superblock, versions 0 to 3 (format description: "HDF5 File Format Specification", section II.A).
/// @param in at the beginning of the file
/// @throws HeaderFault
std::uint64_t hdf5_end_of_file(ByteReader& in);

}  // namespace mortise
