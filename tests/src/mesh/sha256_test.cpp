// SHA-256 against the examples of its standard (FIPS 180-2, appendix B).
#include "sha256.hpp"

#include "scratch.hpp"

namespace mortise {
namespace {

constexpr const char* of_abc = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
constexpr const char* of_a_million_a = "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0";

TEST(Sha256, OfTextsIsThatOfTheStandard) {
  EXPECT_EQ(sha256("abc"), of_abc);
  EXPECT_EQ(sha256(std::string(1'000'000, 'a')), of_a_million_a);
}

TEST(Sha256, OfFilesIsThatOfTheirBytes) {
  const ScratchFolder folder;
  EXPECT_EQ(sha256_of_file(folder.write("abc", "abc")), of_abc);
  EXPECT_EQ(sha256_of_file(folder.write("empty", "")), sha256(""));
  EXPECT_EQ(sha256_of_file(folder.write("large", std::string(1'000'000, 'a') + std::string(2'000'000, '\0'))),
            sha256(std::string(1'000'000, 'a') + std::string(2'000'000, '\0')));
}

TEST(Sha256, OfWhatCannotBeReadIsAFileError) {
  const ScratchFolder folder;
  for (const auto& file : {folder / "absent", folder / ""}) EXPECT_THROW(sha256_of_file(file), FileError) << file;
}

}  // namespace
}  // namespace mortise
