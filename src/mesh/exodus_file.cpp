// Opening, closing and the reasons of failures of the Exodus library.
#include "mesh/exodus_file.hpp"

#include <exodusII.h>
#include <fmt/format.h>
#include <netcdf.h>

#include "errors.hpp"

namespace mortise {

ExodusFile::~ExodusFile() { close(); }

bool ExodusFile::close() {
  if (id_ < 0) return true;
  return ex_close(release()) >= 0;
}

std::string exodus_reason() {
  switch (exerrval) {
    case EX_MEMFAIL:
      return "out of memory";
    case EX_BADFILEMODE:
      return "bad file mode";
    case EX_BADFILEID:
      return "bad file id";
    case EX_WRONGFILETYPE:
      return "wrong file type";
    case EX_LOOKUPFAIL:
      return "id not found";
    case EX_BADPARAM:
      return "bad parameter";
    default:
      return nc_strerror(exerrval);  // netCDF's own codes are negative, those of the system positive
  }
}

ExodusFile open_exodus(const std::filesystem::path& file, ExodusAccess access) {
  ex_opts(EX_DEFAULT);
  int memory_word = sizeof(double), file_word = 0;
  float version = 0;
  const int mode = access == ExodusAccess::write ? EX_WRITE : EX_READ;
  return ExodusFile(ex_open(file.c_str(), mode | EX_ALL_INT64_API, &memory_word, &file_word, &version));
}

void require_written(int status, const std::filesystem::path& file, const std::string& what) {
  if (status < 0) throw FileError(fmt::format("{}: error[I02] cannot be written: {}: {}", file.string(), what, exodus_reason()));
}

}  // namespace mortise
