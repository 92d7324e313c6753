// What the header of a netCDF classic file promises, so that a truncated file is refused before the library reads zeros from it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace mortise {

enum class FileKind { classic, hdf5, other };

struct NetcdfHeader {
  FileKind kind = FileKind::other;
  std::string fault;             ///< what is wrong with a classic header; empty if it reads well
  std::uint64_t n_bytes = 0;     ///< size of the file
  std::uint64_t n_required = 0;  ///< least size by the header, classic files only: the end of the last variable
};

/// Looks at the first bytes of a file and, for netCDF classic (CDF-1, 64-bit offset, 64-bit data), at its whole header.
/// Counts are compared with the bytes that are left before anything is allocated, so that a damaged header costs nothing.
/// @throws FileError if the file cannot be read
NetcdfHeader read_netcdf_header(const std::filesystem::path& file);

}  // namespace mortise
