// NAFEMS contact patch test CGS1: two bricks pressed on each other, as published by another code (MOOSE).
#include <gtest/gtest.h>

#include <iostream>

#include "support/program.hpp"

namespace mortise::test {
namespace {

const std::string mesh_file = std::string(MORTISE_SOURCE_DIR) + "/../shared/peers/nafems_cgs1_brick1.e";

// The bricks lie on each other along y; sides: 1 bottom, 3 and 4 the interface, 5 top, 2 x = 0, 6 z = 0. A traction on the
// reference area.
std::string deck(double traction) {
  const auto probe = [](const std::string& name, const std::string& quantity, const std::string& place) {
    return "<ParameterList name=\"" + name + "\"><Parameter name=\"quantity\" type=\"string\" value=\"" + quantity +
           "\"/><Parameter name=\"mesh\" type=\"string\" value=\"bricks\"/>" + place + "</ParameterList>\n";
  };
  const auto support = [](const std::string& name, const std::string& side, const std::string& axis) {
    return "<ParameterList name=\"" + name + "\"><Parameter name=\"set\" type=\"string\" value=\"bricks/" + side +
           "\"/><Parameter name=\"" + axis + "\" type=\"string\" value=\"0\"/></ParameterList>\n";
  };
  const auto body = [](const std::string& name, const std::string& block) {
    return "<ParameterList name=\"" + name +
           "\"><Parameter name=\"mesh\" type=\"string\" value=\"bricks\"/><Parameter name=\"blocks\" type=\"Array(string)\" "
           "value=\"{" +
           block + "}\"/><Parameter name=\"material\" type=\"string\" value=\"steel\"/></ParameterList>\n";
  };
  std::string probes;
  for (int node = 1; node <= 16; ++node)
    probes += probe("p" + std::to_string(node), "contact_pressure",
                    "<Parameter name=\"node\" type=\"int\" value=\"" + std::to_string(node) + "\"/>");
  const std::string interface = "<Parameter name=\"nearest\" type=\"Array(double)\" value=\"{1, 0.5, 1}\"/>";
  probes += probe("uy", "displacement_y", interface) + probe("ux", "displacement_x", interface);
  return "<ParameterList name=\"nafems cgs1\">\n<ParameterList name=\"meshes\"><ParameterList name=\"bricks\"><Parameter "
         "name=\"file\" type=\"string\" value=\"" +
         mesh_file +
         "\"/></ParameterList></ParameterList>\n"
         "<ParameterList name=\"materials\"><ParameterList name=\"steel\"><Parameter name=\"model\" type=\"string\" "
         "value=\"neo-hookean\"/>"
         "<Parameter name=\"youngs modulus\" type=\"double\" value=\"1e6\"/><Parameter name=\"poissons ratio\" type=\"double\" "
         "value=\"0.3\"/>"
         "</ParameterList></ParameterList>\n"
         "<ParameterList name=\"bodies\">" +
         body("lower", "1") + body("upper", "2") + "</ParameterList>\n" + "<ParameterList name=\"supports\">" +
         support("bottom", "1", "y") + support("left", "2", "x") + support("back", "6", "z") + "</ParameterList>\n" +
         "<ParameterList name=\"loads\"><ParameterList name=\"top\"><Parameter name=\"type\" type=\"string\" value=\"traction\"/>"
         "<Parameter name=\"set\" type=\"string\" value=\"bricks/5\"/><Parameter name=\"y\" type=\"string\" value=\"-" +
         std::to_string(traction) + "*t\"/></ParameterList></ParameterList>\n" +
         "<ParameterList name=\"contact\"><ParameterList name=\"interface\"><Parameter name=\"secondary\" type=\"string\" "
         "value=\"bricks/4\"/>"
         "<Parameter name=\"primary\" type=\"string\" value=\"bricks/3\"/></ParameterList></ParameterList>\n" +
         "<ParameterList name=\"probes\">" + probes + "</ParameterList>\n" +
         "<ParameterList name=\"time\"><Parameter name=\"end\" type=\"double\" value=\"1\"/><Parameter name=\"step\" "
         "type=\"double\" value=\"1\"/></ParameterList>\n</ParameterList>\n";
}

struct Published {
  double pressure = 109.89, reaction = 109.897245726, u_y = -5.4942e-5, u_x = 3.29675e-5;
};

class Nafems : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(mesh_file)) GTEST_SKIP() << "no published case: " << mesh_file << " is absent";
  }
  // Relative differences are held against `tolerance`.
  void compare(double traction, double tolerance) {
    const ScratchFolder folder;
    folder.write("deck.xml", deck(traction));
    const auto run = run_mortise(folder, "run deck.xml -o out --quiet");
    ASSERT_EQ(run.code, 0) << run.err;
    const auto table = read_history(folder / "out" / "history.csv");
    const auto last = [&](const std::string& column) { return table[column].back(); };
    const Published published;
    int n_pressures = 0;
    double pressure = 0;
    for (int node = 1; node <= 16; ++node) {
      const double p = last("contact_pressure.p" + std::to_string(node));
      if (p == 0) continue;
      ++n_pressures;
      pressure = std::max(pressure, std::abs(p / published.pressure - 1));
    }
    EXPECT_EQ(n_pressures, 4);
    const double reaction = std::abs(last("reaction_y.bottom") / published.reaction - 1),
                 u_y = std::abs(last("displacement_y.uy") / published.u_y - 1),
                 u_x = std::abs(last("displacement_x.ux") / published.u_x - 1);
    EXPECT_LE(pressure, tolerance);
    EXPECT_LE(reaction, tolerance);
    EXPECT_LE(u_y, tolerance) << last("displacement_y.uy");
    EXPECT_LE(u_x, tolerance) << last("displacement_x.ux");
    std::cout << "traction " << traction << ": relative differences of pressure " << pressure << ", reaction " << reaction
              << ", u_y " << u_y << ", u_x " << u_x << '\n';
  }
};

TEST_F(Nafems, Cgs1WithDeadLoad) { compare(109.89, 1e-4); }

// The published run holds the load per deformed area: as a dead load that is the published reaction over the reference area.
TEST_F(Nafems, Cgs1WithTheLoadOfTheDeformedArea) { compare(109.897245726, 1e-4); }

}  // namespace
}  // namespace mortise::test
