// Meshes made by a recipe: the shapes that need no file, and what each of them is told.
//
// Every recipe makes one block of hex8 named after its word in the deck (the graded block's is "block" too), side sets and node
// sets of the same names, and numbers counted from 1; "points" and "line" have no volume, so no side sets; the same data give the
// same mesh to the last bit. A new recipe is one struct here with its line in `Recipe`, its description in descriptions.hpp and
// one short file with its map.
#pragma once

#include <array>
#include <variant>
#include <vector>

#include "mesh/mesh.hpp"

namespace mortise {

namespace recipes {

/// A brick [0, size].
struct Block {
  static constexpr const char* name = "block";
  static constexpr const char* help =
      "a box with one corner at the origin; sides: left, right (x), front, back (y), bottom, top (z)";
  std::array<double, 3> size{1, 1, 1};
  std::array<int, 3> elements{1, 1, 1};
};

/// The brick with elements that grow along its axes.
struct GradedBlock {
  static constexpr const char* name = "graded block";
  static constexpr const char* help = "a block whose elements grow along its axes; sides and name of the element block as there";
  std::array<double, 3> size{1, 1, 1};
  std::array<int, 3> elements{1, 1, 1};
  std::array<double, 3> grading{1, 1, 1};  ///< last element size / first element size, per axis
};

/// A spherical shell about the origin, cubed: six lattices, one per face of a cube.
struct HollowSphere {
  static constexpr const char* name = "hollow sphere";
  static constexpr const char* help = "a spherical shell about the origin, meshed as a cube blown up; sides: inner, outer";
  double inner_radius = 0;
  double outer_radius = 0;
  std::array<int, 2> elements{4, 1};  ///< along an edge of the cube, through the wall
  double grading = 1;                 ///< last (outermost) element size / first, through the wall
};

/// A hollow torus about the z axis.
struct Torus {
  static constexpr const char* name = "torus";
  static constexpr const char* help =
      "a tube bent to a ring in the plane z = 0 about the origin; sides: inner, outer (of the tube)";
  double ring_radius = 0;                 ///< of the tube's centre line
  double inner_radius = 0;                ///< of the tube
  double outer_radius = 0;                ///< of the tube
  std::array<int, 3> elements{24, 8, 1};  ///< around the ring, around the tube, through the wall
  double grading = 1;                     ///< last (outermost) element size / first, through the wall
};

/// A full cylinder about the z axis, 0 <= z <= height: a core of squares within shells.
struct Cylinder {
  static constexpr const char* name = "cylinder";
  static constexpr const char* help =
      "a full cylinder about the z axis, standing on z = 0: a core of squares, whose corners are at 0.6 radius, within round "
      "shells; sides: outer, bottom, top";
  double radius = 0;
  double height = 0;
  std::array<int, 3> elements{4, 2, 4};  ///< along a side of the core, shells, along the axis
  std::array<double, 2> grading{1, 1};   ///< last / first element size, outwards through the shells, along the axis
};

/// A tube about the z axis, 0 <= z <= height.
struct HollowCylinder {
  static constexpr const char* name = "hollow cylinder";
  static constexpr const char* help = "a tube about the z axis, standing on z = 0; sides: inner, outer, bottom, top";
  double inner_radius = 0;
  double outer_radius = 0;
  double height = 0;
  std::array<int, 3> elements{16, 1, 4};  ///< around, through the wall, along the axis
  std::array<double, 2> grading{1, 1};    ///< last / first element size, through the wall, along the axis
};

/// A sector of the tube, from the plane y = 0 counter-clockwise about z.
struct RingSector {
  static constexpr const char* name = "ring sector";
  static constexpr const char* help =
      "a sector of a hollow cylinder, from the half plane y = 0, x > 0 counter-clockwise about z; sides: inner, outer, start "
      "(in that half plane), end, bottom, top";
  double inner_radius = 0;
  double outer_radius = 0;
  double height = 0;
  double angle = 0;                        ///< [degrees]
  std::array<int, 3> elements{4, 1, 4};    ///< around, through the wall, along the axis
  std::array<double, 3> grading{1, 1, 1};  ///< last / first element size, around, through the wall, along the axis
};

/// A block whose lower face is curved; its lowest point, the crown, is in the middle at z = 0.
struct CurvedIndenter {
  static constexpr const char* name = "curved indenter";
  static constexpr const char* help =
      "a block with a curved lower face, whose lowest point or line (the crown) is in the middle of the face at z = 0; sides as "
      "of a block";
  enum class Shape { cylinder, sphere };
  enum class Part { whole, half, quarter };
  std::array<double, 3> size{1, 1, 1};  ///< edge lengths; the height is that at the crown
  double radius = 0;                    ///< of the lower face
  Shape shape = Shape::cylinder;        ///< the cylinder's axis is along y
  std::array<int, 3> elements{4, 4, 4};
  std::array<double, 3> grading{1, 1, 1};  ///< x, y: element size at the rim / at the crown; z: last / first
  Part part = Part::whole;                 ///< half: the crown is at x = 0, the left side; quarter: at y = 0 (front) too
};

/// A quarter of a round block about the z axis, x, y >= 0, with a spherical lower face that touches z = 0 on the axis.
struct QuarterIndenter {
  static constexpr const char* name = "quarter indenter";
  static constexpr const char* help =
      "a quarter (x, y >= 0) of a round block about the z axis whose lower face is a sphere, lowest (the crown) at the origin: a "
      "core of squares within round shells; sides: left (x = 0), front (y = 0), bottom, top, outer";
  double radius = 0;                     ///< of the lower face
  double rim_radius = 0;                 ///< of the block
  double core_radius = 0;                ///< from the axis to the corner of the core
  double height = 0;                     ///< on the axis
  std::array<int, 3> elements{4, 2, 4};  ///< along a side of the core, shells, along the axis
  std::array<double, 2> grading{1, 1};   ///< last / first element size, outwards through the shells, along the axis
};

/// A block whose top face rises in x.
struct Wedge {
  static constexpr const char* name = "wedge";
  static constexpr const char* help =
      "a block whose top face rises along x; sides as of a block. Turned by 180 degrees about y it is a block with an inclined "
      "lower face, which fits on it";
  std::array<double, 3> size{1, 1, 1};  ///< edge lengths; the height is that of the left side
  double slope = 0;                     ///< dz/dx of the top face
  std::array<int, 3> elements{4, 4, 4};
  std::array<double, 3> grading{1, 1, 1};  ///< last / first element size, per axis
};

/// A foot along x with a leg upon its left end, as one block.
struct LBlock {
  static constexpr const char* name = "l block";
  static constexpr const char* help =
      "an L in the x-z plane: a foot along x and, upon its left end, a leg along z; sides: left, front, back, bottom, right (the "
      "end of the foot), top (the end of the leg), inner right (of the leg), inner top (of the foot)";
  std::array<double, 3> size{2, 1, 2};    ///< of the box around it
  std::array<double, 2> thickness{1, 1};  ///< of the leg in x, of the foot in z
  std::array<int, 5> elements{
      1, 1, 1, 1, 1};  ///< through the leg in x, along the rest of the foot, y, through the foot in z, along the rest of the leg
};

/// The block whose corners are given.
struct Hexahedron {
  static constexpr const char* name = "hexahedron";
  static constexpr const char* help =
      "a block with straight edges between eight corners, as Cook's membrane or a distorted patch; sides as of a block";
  std::array<double, 24> corners{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1};  ///< x, y, z of each
  std::array<int, 3> elements{1, 1, 1};
  std::array<double, 3> grading{1, 1, 1};  ///< last / first element size, per direction
};

/// Single points, one sphere element each.
struct Points {
  static constexpr const char* name = "points";
  static constexpr const char* help =
      "single points, which `masses` and `springs` make a scene of; node sets: 1, 2, ... in their order";
  std::vector<double> coordinates;  ///< x, y, z of each
};

/// A straight line of bars.
struct Line {
  static constexpr const char* name = "line";
  static constexpr const char* help = "a straight line of bars, which `strings` are made of; node sets: start, end";
  std::array<double, 3> from{0, 0, 0}, to{1, 0, 0};
  int elements = 1;
  int order = 1;  ///< of the shape functions: 1 to 3
};

/// The mesh of each recipe, made at the origin.
/// @throws MeshError M41 with the parameter at fault; M21 where data are so extreme that elements have no volume in doubles
Mesh make(const Block& o);
Mesh make(const GradedBlock& o);
Mesh make(const HollowSphere& o);
Mesh make(const Torus& o);
Mesh make(const Cylinder& o);
Mesh make(const HollowCylinder& o);
Mesh make(const RingSector& o);
Mesh make(const CurvedIndenter& o);
Mesh make(const QuarterIndenter& o);
Mesh make(const Wedge& o);
Mesh make(const LBlock& o);
Mesh make(const Hexahedron& o);
Mesh make(const Points& o);
Mesh make(const Line& o);

}  // namespace recipes

/// What a deck may ask for, in the order of the reference.
using Recipe = std::variant<recipes::Block, recipes::GradedBlock, recipes::HollowSphere, recipes::Torus, recipes::Cylinder,
                            recipes::HollowCylinder, recipes::RingSector, recipes::CurvedIndenter, recipes::QuarterIndenter,
                            recipes::Wedge, recipes::LBlock, recipes::Hexahedron, recipes::Points, recipes::Line>;

/// Whether a recipe makes hexahedra, which can be cut into other elements.
inline bool makes_solids(const Recipe& recipe) {
  return !std::holds_alternative<recipes::Points>(recipe) && !std::holds_alternative<recipes::Line>(recipe);
}

/// The mesh of a recipe. @throws MeshError as the recipes' own
inline Mesh make(const Recipe& recipe) {
  return std::visit([](const auto& kind) { return recipes::make(kind); }, recipe);
}

/// The brick of the recipe "graded block". @throws MeshError
inline Mesh graded_block(const std::array<double, 3>& size, const std::array<int, 3>& elements,
                         const std::array<double, 3>& grading) {
  return recipes::make(recipes::GradedBlock{size, elements, grading});
}

/// The brick of the recipe "block". @throws MeshError
inline Mesh block(const std::array<double, 3>& size, const std::array<int, 3>& elements) {
  return recipes::make(recipes::Block{size, elements});
}

}  // namespace mortise
