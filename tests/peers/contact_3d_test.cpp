// Cases of another code (4C) with its published results, as ../shared/peers tells them: contact, penalty, friction, tying.
#include <gtest/gtest.h>

#include <iostream>

#include "support/program.hpp"

namespace mortise::test {
namespace {

const std::string peers = std::string(MORTISE_SOURCE_DIR) + "/../shared/peers/";

std::string held(const std::string& name, const std::string& set, const std::string& x, const std::string& y,
                 const std::string& z) {
  return list(name, word("set", set) + word("x", x) + word("y", y) + word("z", z));
}

/// Probes <quantity><axis> of a node, e.g. displacement_x.u1x.
std::string probes_of(const std::string& quantity, const std::string& name, int node) {
  std::string probes;
  for (const char* axis : {"x", "y", "z"})
    probes += list(name + axis, word("quantity", quantity + "_" + axis) + word("mesh", "m") +
                                    deck_parameter("node", "int", std::to_string(node)));
  return probes;
}

class Contact3D : public testing::Test {
 protected:
  Table run(const std::string& mesh, const std::string& lists) {
    if (!std::filesystem::exists(peers + mesh)) return {};
    const ScratchFolder folder;
    folder.write("deck.xml", list("peer", list("meshes", list("m", word("file", peers + mesh))) + lists));
    const auto finished = run_mortise(folder, "run deck.xml -o out --quiet");
    EXPECT_EQ(finished.code, 0) << finished.err << finished.out;
    return read_history(folder / "out" / "history.csv");
  }
};

/// Two blocks, 210 and 2100, nu 0.3: the upper one is pressed down by 1, then drawn by 0.2 along x and y. The published run is a
/// dynamic one of nearly no mass (7.8e-6) and damping (1e-5); without both its digits are met to 1e-4.
std::string pressed_blocks(const std::string& options) {
  const auto solid = [](const std::string& E) {
    return word("model", "neo-hookean power-law") + number("youngs modulus", E) + number("poissons ratio", "0.3");
  };
  const auto body = [](const std::string& block, const std::string& material) {
    return word("mesh", "m") + deck_parameter("blocks", "Array(string)", "{" + block + "}") + word("material", material);
  };
  std::string supports;
  for (const char* line : {"2001", "2002", "2003", "2004"}) supports += held(line, "m/" + std::string(line), "0", "0", "0");
  const std::string sideways = "2*min(max(t-0.5,0),0.1)";
  supports += held("top", "m/12", sideways, sideways, "-2*min(t,0.5)");
  return list("materials", list("soft", solid("210")) + list("stiff", solid("2100"))) +
         list("bodies", list("first", body("1", "soft")) + list("second", body("2", "stiff"))) + list("supports", supports) +
         list("contact", list("pair", word("secondary", "m/7") + word("primary", "m/6") + options)) +
         list("probes", probes_of("displacement", "u", 67)) + list("time", number("end", "0.6") + number("step", "0.02"));
}

struct PressedBlocks {
  std::string name, options;
  double u[3];
};
void PrintTo(const PressedBlocks& c, std::ostream* out) { *out << c.name; }

class PressedBlocksOf4C : public Contact3D, public testing::WithParamInterface<PressedBlocks> {};

TEST_P(PressedBlocksOf4C, EndWhereThePublishedOnesDo) {
  const Table table = run("contact3D_lin_stdlagr.e", pressed_blocks(GetParam().options));
  if (table.columns.empty()) GTEST_SKIP() << "no published case: " << peers << " is absent";
  double furthest = 0;
  for (int i = 0; i < 3; ++i) {
    const std::string axis(1, "xyz"[i]);
    const double miss = std::abs(table["displacement_" + axis + ".u" + axis].back() - GetParam().u[i]);
    EXPECT_LE(miss, 1e-4 * std::abs(GetParam().u[2])) << axis;
    furthest = std::max(furthest, miss);
  }
  std::cout << GetParam().name << ": greatest difference of a displacement of node 67 " << furthest << '\n';
}

const std::string by_penalty = word("enforcement", "penalty") + number("normal penalty", "2e4"),
                  interpolated = word("contact force", "interpolated normal");
constexpr double with_multipliers[3] = {0.20156621293794036, 0.1970457472251713, -0.9765664152011952},
                 with_penalty[3] = {0.201234341466561, 0.196582650883949, -0.975888237952954};

INSTANTIATE_TEST_SUITE_P(
    Readings, PressedBlocksOf4C,
    testing::Values(
        PressedBlocks{"thesis", "", {with_multipliers[0], with_multipliers[1], with_multipliers[2]}},
        PressedBlocks{"interpolated_normal", interpolated, {with_multipliers[0], with_multipliers[1], with_multipliers[2]}},
        PressedBlocks{"penalty", by_penalty, {with_penalty[0], with_penalty[1], with_penalty[2]}},
        PressedBlocks{
            "penalty_interpolated_normal", by_penalty + interpolated, {with_penalty[0], with_penalty[1], with_penalty[2]}}),
    [](const auto& info) { return info.param.name; });

/// Mesh tying, E = 1000, nu = 0, pulled at by -1: the exact state is uniform.
TEST_F(Contact3D, TiedMeshesPassThePatchTest) {
  std::string supports = held("6", "m/1006", "0", "0", "0");
  supports += list("7", word("set", "m/1007") + word("x", "0") + word("z", "0"));
  supports += list("8", word("set", "m/1008") + word("y", "0") + word("z", "0"));
  supports += list("9", word("set", "m/1009") + word("z", "0"));
  std::string loads = list("top", word("type", "traction") + word("set", "m/1") + word("z", "-1"));
  // What the upper block leaves uncovered of the lower one's top is pressed on by nodal forces.
  const char* forces[] = {"-1", "-2", "-2.91015625", "-3.68359375", "-0.24609375"};
  for (int k = 0; k < 5; ++k)
    loads += list("point " + std::to_string(k + 1),
                  word("type", "point force") + word("set", "m/" + std::to_string(1001 + k)) + word("z", forces[k]));
  const Table table = run(
      "meshtying3D_patch_lin_duallagr.e",
      list("materials",
           list("a", word("model", "neo-hookean power-law") + number("youngs modulus", "1000") + number("poissons ratio", "0"))) +
          list("bodies", list("all", word("mesh", "m") + word("material", "a"))) + list("supports", supports) +
          list("loads", loads) + list("ties", list("glue", word("secondary", "m/2") + word("primary", "m/3"))) +
          list("probes", probes_of("displacement", "a", 8) + probes_of("displacement", "b", 157)) +
          list("time", number("end", "1") + number("step", "1")));
  if (table.columns.empty()) GTEST_SKIP() << "no published case: " << peers << " is absent";
  for (const char* node : {"a", "b"}) {
    EXPECT_NEAR(table["displacement_z." + std::string(node) + "z"].back(), -3.99800000050019e-3, 1e-8);
    for (const char* axis : {"x", "y"})
      EXPECT_NEAR(table["displacement_" + std::string(axis) + "." + node + axis].back(), 0, 1e-8);
  }
}

/// A block pressed on a slab by 10 and pushed by up to 0.6, Coulomb's friction 0.1, both penalties 1e5, Newmark 1/4 and 1/2. The
/// block has just begun to slide.
TEST_F(Contact3D, BlockSlidesAsThePublishedOneDoes) {
  const Table table =
      run("contact3D_slidingblock_penalty.e",
          list("materials", list("a", word("model", "saint venant-kirchhoff") + number("youngs modulus", "1e6") +
                                          number("poissons ratio", "0") + number("density", "1"))) +
              list("bodies", list("all", word("mesh", "m") + word("material", "a"))) +
              list("supports", held("4", "m/4", "0", "0", "0") + held("6", "m/6", "0", "0", "0")) +
              list("loads", list("push", word("type", "traction") + word("set", "m/1") + word("x", "max(t-1,0)")) +
                                list("press", word("type", "traction") + word("set", "m/3") + word("z", "-10*min(t,1)"))) +
              list("contact", list("pair", word("secondary", "m/5") + word("primary", "m/4") + word("enforcement", "penalty") +
                                               number("normal penalty", "1e5") + number("friction coefficient", "0.1") +
                                               number("tangential penalty", "1e5"))) +
              list("probes", probes_of("displacement", "u", 247) + probes_of("velocity", "v", 247)) +
              list("time", word("scheme", "newmark") + number("end", "2.2") + number("step", "0.1")));
  if (table.columns.empty()) GTEST_SKIP() << "no published case: " << peers << " is absent";
  const double u_x = table["displacement_x.ux"].back(), u_z = table["displacement_z.uz"].back(),
               v_x = table["velocity_x.vx"].back();
  EXPECT_NEAR(u_x, 1.770304e-3, 0.005 * 1.770304e-3);  // the tangential slip of the published code is measured otherwise
  EXPECT_NEAR(u_z, -2.000811e-4, 1e-6);
  EXPECT_NEAR(v_x, 2.062833e-2, 0.005 * 2.062833e-2);
  EXPECT_LE(std::abs(table["displacement_y.uy"].back()), 1e-12);
  std::cout << "sliding block: relative differences of u_x " << u_x / 1.770304e-3 - 1 << ", v_x " << v_x / 2.062833e-2 - 1
            << ", difference of u_z " << u_z + 2.000811e-4 << '\n';
}

}  // namespace
}  // namespace mortise::test
