// The inputs kept for the fuzzers, found and written ones, go through the same functions without a fuzzer.
#include "fuzz/entries.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "support/text.hpp"

namespace mortise::test {
namespace {

std::vector<std::filesystem::path> kept(const std::string& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(MORTISE_SOURCE_DIR "/tests/fuzz/corpus/" + folder))
    files.push_back(entry.path());
  return files;
}

/// Names of the inputs that are accepted.
template <class Feed>
std::string accepted(const std::string& folder, Feed feed) {
  std::vector<std::string> names;
  for (const auto& file : kept(folder)) {
    SCOPED_TRACE(file);
    EXPECT_NO_THROW(if (feed(text_of(file))) names.push_back(file.filename()));
  }
  std::sort(names.begin(), names.end());
  return join(names);
}

TEST(FuzzCorpus, OfDecksGivesOptionsOrWords) { EXPECT_EQ(accepted("deck", feed_deck), "every_list.xml"); }

TEST(FuzzCorpus, OfMeshHeadersGivesASizeOrAFault) {
  EXPECT_EQ(accepted("netcdf_header", feed_netcdf_header),
            "cdf1.nc, cdf2.nc, cdf5.nc, hdf5_0.nc, hdf5_1.nc, hdf5_2.nc, hdf5_3.nc, no_variable.nc");
}

TEST(FuzzCorpus, OfSoundHeadersRequiresTheSizeOfItsFiles) {
  for (const auto& file : kept("netcdf_header")) {
    const NetcdfHeader header = read_netcdf_header(file);
    EXPECT_EQ(header.fault.empty(), header.n_required == header.n_bytes) << file;
  }
}

}  // namespace
}  // namespace mortise::test
