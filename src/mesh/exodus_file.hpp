// An open Exodus file that closes itself, and the geometry that every file of ours begins with.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace mortise {

/// Owns the id of an open Exodus file. Making one silences the library: it neither prints nor aborts.
class ExodusFile {
 public:
  explicit ExodusFile(int id = -1) : id_(id) {}
  ~ExodusFile();
  ExodusFile(ExodusFile&& other) noexcept : id_(other.release()) {}
  ExodusFile& operator=(ExodusFile&&) = delete;

  int id() const { return id_; }
  /// Gives the id away: the caller closes the file.
  int release() {
    const int id = id_;
    id_ = -1;
    return id;
  }
  /// Closes now, and says whether everything reached the disk.
  bool close();

 private:
  int id_;
};

/// What went wrong in the last call of the library: `No such file or directory`, `id not found`.
std::string exodus_reason();

enum class ExodusAccess { read, write };

/// Opens an existing file, with 64-bit integers in all calls; the id is negative if that failed. About files that netCDF cannot
/// open the library prints to stderr whatever its options say: to be called where nobody sees that.
ExodusFile open_exodus(const std::filesystem::path& file, ExodusAccess access = ExodusAccess::read);

/// Creates a file and writes the mesh into it: nodes, blocks, sets, names, number maps, title, QA record.
/// Format: classic 64-bit offset; netCDF-4 with 64-bit integers where a number or id does not fit into 32 bits.
/// The same mesh gives the same bytes: the QA record carries no date.
/// @param variables names of variables that will follow: they share the length limit of the names of the mesh
/// @throws FileError
ExodusFile create_exodus(const std::filesystem::path& file, const Mesh& mesh, const std::string& title,
                         const std::vector<std::string>& variables = {});

/// @throws FileError `file: error[I02] cannot be written: what: reason` if an Exodus call returned an error
void require_written(int status, const std::filesystem::path& file, const std::string& what);

}  // namespace mortise
