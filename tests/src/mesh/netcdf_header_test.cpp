// The size that a netCDF classic header requires, against files that the library wrote.
#include "mesh/netcdf_header.hpp"

#include <netcdf.h>

#include <sstream>

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

/// A header written byte by byte, as the specification of the format has it.
class Bytes {
 public:
  Bytes& raw(const std::string& text) { return bytes_ += text, *this; }
  Bytes& big(std::uint64_t n, int size = 4) {
    for (int i = size - 1; i >= 0; --i) bytes_ += static_cast<char>(n >> 8 * i);
    return *this;
  }
  Bytes& little(std::uint64_t n, int size) {
    for (int i = 0; i < size; ++i) bytes_ += static_cast<char>(n >> 8 * i);
    return *this;
  }
  Bytes& name(const std::string& text) { return big(text.size()).raw(text).raw(std::string((4 - text.size() % 4) % 4, '\0')); }
  Bytes& zeros(std::size_t n) { return raw(std::string(n, '\0')); }
  NetcdfHeader parsed() const {
    std::istringstream in(bytes_);
    return parse_netcdf_header(in, bytes_.size());
  }

 private:
  std::string bytes_;
};

/// What the variable `v` of a one-dimensional sample says about itself.
struct Said {
  std::uint64_t dimension = 0, type = 6, size = 24, begin = 80;
  std::string name = "v";
};

/// Classic file with the dimension "n" of 3 and one variable of 3 doubles behind its 80 bytes of header.
Bytes sample(const Said& said) {
  Bytes file;
  file.raw(std::string("CDF\1", 4)).big(0);
  file.big(10).big(1).name("n").big(3).big(0).big(0);
  file.big(11).big(1).name(said.name).big(1).big(said.dimension).big(0).big(0);
  return file.big(said.type).big(said.size).big(said.begin).zeros(24);
}

TEST(NetcdfHeader, OfASoundFileWrittenByteByByteHasNoFault) {
  const NetcdfHeader header = sample({}).parsed();
  EXPECT_EQ(header.kind, FileKind::classic);
  EXPECT_EQ(header.fault, "");
  EXPECT_EQ(header.n_required, header.n_bytes);
}

TEST(NetcdfHeader, IsRefusedWhereItContradictsItself) {
  const auto fault = [](const Said& said) { return sample(said).parsed().fault; };
  expect_words(fault({1, 6, 24, 80, "v"}), {"\"v\"", "dimension 1 of 1"});
  expect_words(fault({0, 7, 24, 80, "v"}), {"unknown type 7"});
  expect_words(fault({0, 5, 24, 80, "v"}), {"12 bytes by its dimensions", "24"});
  expect_words(fault({0, 6, 24, 76, "v"}), {"begins at 76", "ends at 80"});
  expect_words(fault({0, 6, 24, 80, ""}), {"a name of 0 bytes"});
  expect_words(fault({0, 6, 24, 80, "a/b"}), {"slash"});
  expect_words(fault({0, 6, 24, 80, "a\nb"}), {"control character"});
  expect_words(fault({0, 6, 24, 80, std::string(257, 'v')}), {"a name of 257 bytes - 1 to 256"});
  const Said beyond{0, 6, 24, 84, "v"};
  EXPECT_EQ(fault(beyond), "");  // a gap is allowed, but then the file is too short
  EXPECT_EQ(sample(beyond).parsed().n_required, sample(beyond).parsed().n_bytes + 4);
}

TEST(NetcdfHeader, MayNotPutTwoVariablesInOnePlaceNorLeaveTheRecordsOpen) {
  const auto two = [](std::uint64_t second_begin) {
    Bytes file;
    file.raw(std::string("CDF\2", 4)).big(0).big(10).big(1).name("n").big(4).big(0).big(0).big(11).big(2);
    for (const auto& [name, begin] : {std::pair<const char*, std::uint64_t>{"a", 128}, {"b", second_begin}})
      file.name(name).big(1).big(0).big(0).big(0).big(4).big(16).big(begin, 8);
    return file.zeros(48).parsed();
  };
  EXPECT_EQ(two(144).fault, "");
  expect_words(two(140).fault, {"\"b\" begins at 140", "ends at 144"});
  Bytes open;
  open.raw(std::string("CDF\1", 4)).big(0xFFFFFFFF).zeros(24);
  expect_words(open.parsed().fault, {"records is left open"});
}

TEST(NetcdfHeader, WithGreatNumbersCostsNothing) {
  Bytes file;
  file.raw(std::string("CDF\5", 4)).big(0xFFFFFFFFFFFFFFFE, 8).big(10).big(0x7FFFFFFFFFFFFFFF, 8);
  expect_words(file.parsed().fault, {"do not fit"});
  Bytes variable;
  variable.raw(std::string("CDF\1", 4)).big(0).big(10).big(1).name("n").big(0x7FFFFFFF).big(0).big(0);
  variable.big(11).big(1).name("v").big(3).big(0).big(0).big(0).big(0).big(0).big(6).big(0xFFFFFFFF).big(100);
  EXPECT_EQ(variable.parsed().fault, "");
  EXPECT_GT(variable.parsed().n_required, std::uint64_t{1} << 60);
}

TEST(Hdf5Superblock, OfEachVersionTellsTheEndOfTheFile) {
  const auto superblock = [](int version, int offset_size, std::uint64_t base) {
    Bytes file;
    file.raw("\x89HDF\r\n\x1a\n").little(static_cast<std::uint64_t>(version), 1);
    if (version < 2) file.zeros(4);
    file.little(static_cast<std::uint64_t>(offset_size), 1).little(8, 1);
    file.zeros(version < 2 ? 9 : 1);
    if (version == 1) file.zeros(4);
    return file.little(base, offset_size).little(7777, offset_size).little(5000, offset_size).zeros(40).parsed();
  };
  for (int version : {0, 1, 2, 3})
    for (int offset_size : {2, 4, 8}) {
      EXPECT_EQ(superblock(version, offset_size, 0).fault, "");
      EXPECT_EQ(superblock(version, offset_size, 0).n_required, 5000U);
    }
  expect_words(superblock(4, 8, 0).fault, {"version 4"});
  expect_words(superblock(2, 3, 0).fault, {"addresses of 3 bytes"});
  expect_words(superblock(2, 8, 512).fault, {"base address"});
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
        EXPECT_EQ(header.n_required, header.n_bytes);
      }
}

TEST(NetcdfHeader, TellsNetcdf4FromOtherFiles) {
  const ScratchFolder folder;
  int id = 0;
  ASSERT_EQ(nc_create((folder / "x.nc").c_str(), NC_CLOBBER | NC_NETCDF4, &id), NC_NOERR);
  nc_close(id);
  const NetcdfHeader header = read_netcdf_header(folder / "x.nc");
  EXPECT_EQ(header.kind, FileKind::hdf5);
  EXPECT_EQ(header.fault, "");
  EXPECT_EQ(header.n_required, header.n_bytes);
  EXPECT_EQ(read_netcdf_header(MORTISE_SOURCE_DIR "/CMakeLists.txt").kind, FileKind::other);
}

}  // namespace
}  // namespace mortise
