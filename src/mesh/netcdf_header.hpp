// What the header of a netCDF file promises, so that a damaged file is refused before the library reads zeros from it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <istream>
#include <string>

namespace mortise {

enum class FileKind { classic, hdf5, other };

struct NetcdfHeader {
  FileKind kind = FileKind::other;
  std::string fault;             ///< what is wrong with the header; empty if it reads well
  std::uint64_t n_bytes = 0;     ///< size of the file
  std::uint64_t n_required = 0;  ///< size by the header: the library leaves no file shorter or longer when it closes it
};

/// Looks at the first bytes of a file. For netCDF classic (CDF-1, 64-bit offset, 64-bit data) it reads the whole header:
/// dimensions, names, attributes, variables, and where the data of each variable lie; they must be behind the header and apart.
/// For netCDF-4 it reads the superblock of HDF5. `n_required` includes the padding of the last variable, because the netCDF
/// library writes it: so no truncation, not even by one byte, passes for a whole file. Counts are compared with the bytes that
/// are left before anything is allocated, so that a damaged header costs nothing.
/// @param in at the beginning of the file  @param n_bytes size of the file
NetcdfHeader parse_netcdf_header(std::istream& in, std::uint64_t n_bytes);

/// The same of a file.
/// @throws FileError if the file cannot be read
NetcdfHeader read_netcdf_header(const std::filesystem::path& file);

}  // namespace mortise
