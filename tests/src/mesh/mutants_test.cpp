// Damaged mesh files by the hundred: each is refused in good time or gives a mesh that passes the checks; no truncation passes.
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <climits>
#include <cstdlib>
#include <map>

#include "mesh/checks.hpp"
#include "mesh/child_process.hpp"
#include "mesh/exodus.hpp"
#include "mesh/mesh_bytes.hpp"
#include "mesh/recipes/recipes.hpp"
#include "scratch.hpp"
#include "support/random.hpp"
#include "support/text.hpp"

namespace mortise {
namespace {

/// A file cut to `length`, and a word or bit of it replaced.
struct Mutant {
  std::string kind;
  std::size_t length;
  std::size_t at = 0;
  std::string bytes = "";

  std::string of(const std::string& file) const { return file.substr(0, length).replace(at, bytes.size(), bytes); }
  std::string what() const { return fmt::format("{} at byte {}, length {}", kind, at, length); }
};

/// Truncations of every class of length, among them by one byte; 180 flipped bits; 180 overwritten words. Long: ten times as
/// many.
std::vector<Mutant> mutants_of(const std::string& file, unsigned seed) {
  test::Random random(seed);
  const int n_each = std::getenv("MORTISE_LONG") != nullptr ? 1800 : 180;
  const auto any = [&](std::size_t n) { return static_cast<std::size_t>(random.in(0, static_cast<double>(n))); };
  std::vector<Mutant> all;
  const auto cut = [&](std::size_t n) { all.push_back({"truncation", n}); };
  for (std::size_t n = 0; n < 64; ++n) cut(n);
  for (std::size_t n = 1; n <= 64; ++n) cut(file.size() - n);
  for (std::size_t n = 64; n < file.size(); n *= 2) cut(n);
  for (int i = 0; i < 3 * n_each / 2; ++i) cut(any(file.size()));

  for (int i = 0; i < n_each; ++i) {
    const std::size_t at = any(file.size());
    all.push_back({"bit flip", file.size(), at, std::string(1, static_cast<char>(file[at] ^ 1 << any(8)))});
  }
  for (int i = 0; i < n_each; ++i) {
    const std::uint32_t words[] = {0, 0xFFFFFFFF, INT_MAX, 1, static_cast<std::uint32_t>(any(UINT_MAX))};
    std::string word;  // the most significant byte first, as netCDF classic stores it
    for (int shift : {24, 16, 8, 0}) word += static_cast<char>(words[i % 5] >> shift);
    all.push_back({"4 bytes", file.size(), 4 * any(file.size() / 4), word});
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
  int crashed = 0;  ///< of the refused: the library ended by a signal
  int ended = 0;    ///< of the refused: the library needed too much time or memory
  int changed = 0, unchanged = 0;
  double slowest = 0;  ///< [s]
};

/// Reads all mutants of the file of `original`, and prints what became of them.
/// @param magic the file must begin with it
void expect_mutants_refused_or_sound(const Mesh& original, const std::string& magic, unsigned seed) {
  const ScratchFolder folder;
  // Written in a child: a library that was never used here makes the forks to come cheaper.
  const auto write = [&] { return write_exodus(original, folder / "whole.e", "two hexes"), test::text_of(folder / "whole.e"); };
  const std::string file = run_in_child(write, {10, 60, std::uint64_t{1} << 32}).bytes;
  ASSERT_EQ(file.substr(0, magic.size()), magic);
  const auto content = [](Mesh mesh) { return mesh.source.clear(), bytes_of(mesh); };
  const std::string whole = content(read_exodus(folder / "whole.e"));

  std::map<std::string, Counts> table;
  const std::vector<Mutant> mutants = mutants_of(file, seed);
  EXPECT_GE(mutants.size(), 750U);
  for (const Mutant& mutant : mutants) {
    folder.write("mutant.e", mutant.of(file));
    Counts& counts = table[mutant.kind];
    const double begin = processor_seconds();
    try {
      const Mesh mesh = read_exodus(folder / "mutant.e");
      EXPECT_NO_THROW(check_mesh(mesh)) << mutant.what();
      EXPECT_NE(mutant.kind, "truncation") << mutant.what() << " is accepted";
      ++(content(mesh) == whole ? counts.unchanged : counts.changed);
    } catch (const MeshError& error) {
      ++counts.refused;
      const std::string text = error.what();
      counts.crashed += text.find("the mesh library fails on it (signal") != std::string::npos;
      counts.ended += text.find("the mesh library fails on it (more than") != std::string::npos;
      EXPECT_EQ(text.find("no answer"), std::string::npos) << mutant.what();
    }
    const double seconds = processor_seconds() - begin;
    counts.slowest = std::max(counts.slowest, seconds);
    EXPECT_LE(seconds, 2.0) << mutant.what();
  }

  fmt::print("{} bytes     mutants  refused, by a crash, by a limit  accepted: changed, unchanged  slowest\n", file.size());
  for (const auto& [kind, n] : table) {
    fmt::print("{:<15} {:>7} {:>8} {:>11} {:>11} {:>18} {:>10} {:>6.2f} s\n", kind, n.refused + n.changed + n.unchanged,
               n.refused, n.crashed, n.ended, n.changed, n.unchanged, n.slowest);
    const std::string key = kind == "4 bytes" ? "overwritten" : kind == "bit flip" ? "flipped" : "truncated";
    for (const auto& [what, count] : {std::pair<const char*, int>{"refused", n.refused},
                                      {"crashed", n.crashed},
                                      {"ended", n.ended},
                                      {"changed", n.changed},
                                      {"unchanged", n.unchanged}})
      testing::Test::RecordProperty(key + "_" + what, count);
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
