// The size that a netCDF classic header requires, against files that the library wrote.
#include "mesh/netcdf_header.hpp"

#include <netcdf.h>

#include "scratch.hpp"

namespace mortise {
namespace {

/// A file with a fixed variable and `n_record_variables` record variables of 3 characters, `n_records` records long.
void write_sample(const std::filesystem::path& file, int format, int n_record_variables, std::size_t n_records) {
  int id = 0, dimensions[2] = {}, variable = 0;
  ASSERT_EQ(nc_create(file.c_str(), NC_CLOBBER | format, &id), NC_NOERR);
  nc_def_dim(id, "time", NC_UNLIMITED, &dimensions[0]);
  nc_def_dim(id, "three", 3, &dimensions[1]);
  nc_put_att_text(id, NC_GLOBAL, "title", 5, "a sea");
  nc_def_var(id, "fixed", NC_DOUBLE, 1, &dimensions[1], &variable);
  for (int v = 0; v < n_record_variables; ++v)
    nc_def_var(id, ("record" + std::to_string(v)).c_str(), NC_CHAR, 2, dimensions, &variable);
  nc_put_att_text(id, variable, "unit", 1, "m");
  nc_enddef(id);
  const std::size_t start[] = {0, 0}, count[] = {n_records, 3};
  const std::string text(3 * n_records, 'x');
  for (int v = 1; v <= n_record_variables; ++v) nc_put_vara_text(id, v, start, count, text.c_str());
  ASSERT_EQ(nc_close(id), NC_NOERR);
}

TEST(NetcdfHeader, RequiresTheSizeThatTheLibraryWrites) {
  const ScratchFolder folder;
  for (int format : {0, NC_64BIT_OFFSET, NC_64BIT_DATA})
    for (int n_record_variables : {0, 1, 2})
      for (std::size_t n_records : {1U, 5U}) {
        write_sample(folder / "x.nc", format, n_record_variables, n_records);
        const NetcdfHeader header = read_netcdf_header(folder / "x.nc");
        EXPECT_EQ(header.kind, FileKind::classic);
        EXPECT_EQ(header.fault, "");
        EXPECT_LE(header.n_required, header.n_bytes);
        EXPECT_LT(header.n_bytes - header.n_required, 4U) << "only the padding of the last variable may be beyond";
      }
}

TEST(NetcdfHeader, TellsNetcdf4FromOtherFiles) {
  const ScratchFolder folder;
  int id = 0;
  ASSERT_EQ(nc_create((folder / "x.nc").c_str(), NC_CLOBBER | NC_NETCDF4, &id), NC_NOERR);
  nc_close(id);
  EXPECT_EQ(read_netcdf_header(folder / "x.nc").kind, FileKind::hdf5);
  EXPECT_EQ(read_netcdf_header(MORTISE_SOURCE_DIR "/CMakeLists.txt").kind, FileKind::other);
}

}  // namespace
}  // namespace mortise
