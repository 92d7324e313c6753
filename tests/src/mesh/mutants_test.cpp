// Damaged mesh files by the hundred: each is refused in good time or gives a mesh that passes the checks; no truncation passes.
#include <sys/resource.h>

#include <algorithm>
#include <climits>
#include <iostream>
#include <map>

#include "mesh/checks.hpp"
#include "mesh/exodus.hpp"
#include "mesh/mesh_bytes.hpp"
#include "mesh/recipes/recipes.hpp"
#include "scratch.hpp"
#include "support/random.hpp"
#include "support/text.hpp"

namespace mortise {
namespace {

struct Mutant {
  std::string kind, bytes, what;
};

/// 100 and more truncations of every class of length, among them by one byte; 400 flipped bits; 400 overwritten words.
std::vector<Mutant> mutants_of(const std::string& file, std::uint64_t seed) {
  test::Random random(seed);
  const auto any = [&](std::size_t n) { return std::min(n - 1, static_cast<std::size_t>(random.in(0, static_cast<double>(n)))); };
  std::vector<Mutant> all;
  const auto cut = [&](std::size_t n) { all.push_back({"truncation", file.substr(0, n), "to " + std::to_string(n)}); };
  for (std::size_t n = 0; n < 40; ++n) cut(n);
  for (std::size_t n = 1; n <= 40; ++n) cut(file.size() - n);
  for (std::size_t n = 64; n < file.size(); n *= 2) cut(n);
  for (int i = 0; i < 100; ++i) cut(any(file.size()));

  for (int i = 0; i < 400; ++i) {
    const std::size_t at = any(file.size()), bit = any(8);
    all.push_back({"bit flip", file, "bit " + std::to_string(bit) + " of byte " + std::to_string(at)});
    all.back().bytes[at] = static_cast<char>(all.back().bytes[at] ^ 1 << bit);
  }
  for (int i = 0; i < 400; ++i) {
    const std::uint32_t words[] = {0, 0xFFFFFFFF, INT_MAX, 1, static_cast<std::uint32_t>(any(UINT_MAX))};
    const std::uint32_t word = words[i % 5];
    const std::size_t at = any(file.size() / 4) * 4;
    all.push_back({"4 bytes", file, "bytes from " + std::to_string(at) + " by " + std::to_string(word)});
    for (std::size_t k = 0; k < 4 && at + k < file.size(); ++k)  // the most significant first, as netCDF classic stores it
      all.back().bytes[at + k] = static_cast<char>(word >> (24 - 8 * k));
  }
  return all;
}

/// Processor time of this process and its children [s].
double processor_seconds() {
  double sum = 0;
  for (int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage used{};
    getrusage(who, &used);
    for (const timeval& time : {used.ru_utime, used.ru_stime})
      sum += static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  }
  return sum;
}

struct Counts {
  int refused = 0;
  int library_failed = 0;  ///< of the refused: the child crashed, hung, or took too much memory
  int changed = 0, unchanged = 0;
  double slowest = 0;
};

/// Reads all mutants of `original` and prints what became of them.
void expect_mutants_refused_or_sound(const Mesh& original, const std::string& magic, std::uint64_t seed) {
  const ScratchFolder folder;
  write_exodus(original, folder / "whole.e", "two hexes");
  const std::string file = test::text_of(folder / "whole.e");
  ASSERT_EQ(file.substr(0, magic.size()), magic);
  const auto sets_of = [](Mesh mesh) { return mesh.source.clear(), bytes_of(mesh); };
  const std::string whole = sets_of(read_exodus(folder / "whole.e"));

  std::map<std::string, Counts> table;
  const std::vector<Mutant> mutants = mutants_of(file, seed);
  EXPECT_GE(mutants.size(), 750U);
  for (const Mutant& mutant : mutants) {
    folder.write("mutant.e", mutant.bytes);
    Counts& counts = table[mutant.kind];
    const double begin = processor_seconds();
    try {
      const Mesh mesh = read_exodus(folder / "mutant.e");
      EXPECT_NO_THROW(check_mesh(mesh)) << mutant.kind << ' ' << mutant.what;
      EXPECT_NE(mutant.kind, "truncation") << mutant.what << " of " << file.size() << " bytes is accepted";
      ++(sets_of(mesh) == whole ? counts.unchanged : counts.changed);
    } catch (const MeshError& error) {
      ++counts.refused;
      if (std::string(error.what()).find("the mesh library fails") != std::string::npos) {
        ++counts.library_failed;
        std::cout << mutant.kind << ' ' << mutant.what << ": "
                  << std::string(error.what()).substr(error.what() == nullptr ? 0 : 0) << '\n';
      }
    }
    const double seconds = processor_seconds() - begin;
    counts.slowest = std::max(counts.slowest, seconds);
    EXPECT_LE(seconds, 2.0) << mutant.kind << ' ' << mutant.what;
  }
  std::cout << file.size()
            << " bytes\nkind        mutants  refused (library failed)  accepted: changed  unchanged  slowest [s]\n";
  for (const auto& [kind, n] : table) {
    std::printf("%-11s %7d %8d %16d %18d %10d %12.3f\n", kind.c_str(), n.refused + n.changed + n.unchanged, n.refused,
                n.library_failed, n.changed, n.unchanged, n.slowest);
    testing::Test::RecordProperty(kind == "4 bytes"    ? "four_bytes_refused"
                                  : kind == "bit flip" ? "bit_flip_refused"
                                                       : kind + "_refused",
                                  n.refused);
  }
}

Mesh two_hexes() { return block({2, 1, 1}, {2, 1, 1}); }

TEST(Mutants, OfAClassicFileAreRefusedOrSound) { expect_mutants_refused_or_sound(two_hexes(), std::string("CDF\2"), 1); }

TEST(Mutants, OfANetcdf4FileAreRefusedOrSound) {
  Mesh mesh = two_hexes();
  mesh.node_numbers[3] = 5'000'000'000;  // needs 64 bits, and so netCDF-4
  expect_mutants_refused_or_sound(mesh, "\x89HDF", 2);
}

}  // namespace
}  // namespace mortise
