// Small things the mesh tests share: the words of an error, and geometry of sides.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "errors.hpp"
#include "mesh/mesh.hpp"
#include "support/scratch_folder.hpp"

namespace mortise {

/// The text of the MeshError that `action` throws; any other outcome fails the test.
template <class Action>
std::string mesh_error_of(Action action) {
  try {
    action();
  } catch (const MeshError& error) {
    EXPECT_EQ(error.code(), ExitCode::mesh);
    return error.what();
  } catch (const std::exception& error) {
    ADD_FAILURE() << "not a MeshError: " << error.what();
    return "";
  }
  ADD_FAILURE() << "no error";
  return "";
}

inline void expect_words(const std::string& text, const std::vector<std::string>& words) {
  for (const std::string& word : words) EXPECT_NE(text.find(word), std::string::npos) << "\"" << word << "\" is not in: " << text;
}

/// Half the cross product of the diagonals: area times the right-hand normal of a flat side.
inline Point area_vector(const Mesh& mesh, Side side) {
  const std::vector<int> nodes = side_nodes(mesh, side);
  const auto x = [&](std::size_t i) { return mesh.coordinates[static_cast<std::size_t>(nodes[i])]; };
  Point d{}, e{};
  for (std::size_t i = 0; i < 3; ++i) {
    d[i] = x(2)[i] - x(0)[i];
    e[i] = x(3)[i] - x(1)[i];
  }
  return {0.5 * (d[1] * e[2] - d[2] * e[1]), 0.5 * (d[2] * e[0] - d[0] * e[2]), 0.5 * (d[0] * e[1] - d[1] * e[0])};
}

inline Point centre(const Mesh& mesh, Side side) {
  Point c{};
  for (int a : side_nodes(mesh, side))
    for (std::size_t i = 0; i < 3; ++i) c[i] += 0.25 * mesh.coordinates[static_cast<std::size_t>(a)][i];
  return c;
}

/// Volume of an element with flat sides by Gauss' theorem: V = 1/3 sum over sides of x . A.
inline double volume(const Mesh& mesh, int element) {
  double v = 0;
  for (int face = 0; face < 6; ++face) {
    const Point A = area_vector(mesh, {element, face}), c = centre(mesh, {element, face});
    v += (A[0] * c[0] + A[1] * c[1] + A[2] * c[2]) / 3;
  }
  return v;
}

}  // namespace mortise
