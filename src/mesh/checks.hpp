// What makes a mesh unusable: the checks that every mesh passes, and the codes of their messages.
//
// All lines read `source: error[M12] what - what is allowed`, exit code 3 (MeshError). Codes:
//
//   the file          M01 not an Exodus file               M02 not three-dimensional        M03 no nodes or no elements
//                     M04 truncated or damaged             M05 a part cannot be read        M06 too large for 32-bit counting
//                     M07 its sha256 is not the deck's      M08 no results in it
//   elements, nodes   M12 element type not supported       M13 node out of range            M14 a node twice in one element
//                     M16 coordinate not finite            M17 node without element         M18 coordinate too large
//                     M21 Jacobian not positive
//   numbers, names    M24 node number twice or < 1         M25 element number twice or < 1  M26 id or name twice
//                     M27 negative id                      M28 name not UTF-8, or with control characters
//   sets              M31 empty set                        M32 element of a side out of range
//                     M33 side not in 1..6                 M34 node of a set out of range   M35 side twice in one set
//   contact           M51 surfaces are inside each other at the start                       M52 side with elements on both sides
//                     M53 edge of more than two facets     M54 neighbours face opposite ways
//   recipes, places   M41 recipe unknown or its data bad   M42 rotation or origin bad       M43 neither file nor recipe, or both
//
// Files that cannot be opened or written are FileErrors (exit code 5): I01 cannot be read, I02 cannot be written.
#pragma once

#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace mortise {

/// The errors found in one mesh, gathered so that the user sees them together.
class MeshErrors {
 public:
  explicit MeshErrors(std::string source) : source_(std::move(source)) {}
  /// Notes `source: error[code] text`.
  void add(const std::string& code, const std::string& text);
  bool empty() const { return messages_.empty(); }
  /// @throws MeshError with all of them, if there is any
  void throw_if_any() const;

 private:
  std::string source_;
  std::vector<std::string> messages_;
};

/// Checks connectivity, coordinates, numbers, names, sets and the sign of the Jacobian at the 2x2x2 Gauss points (codes above,
/// M03 and M13 to M35). Indices may be anything: they are checked before they are used. Precondition: as many numbers as nodes
/// and elements.
/// @throws MeshError with one line per kind of error and block or set, each with its count and its first offender by the user's
/// number
void check_mesh(const Mesh& mesh);

/// `block 2 "shaft"`, or `block 2` where it has no name.
std::string describe(const Block& block);
std::string describe(const SideSet& set);
std::string describe(const NodeSet& set);

}  // namespace mortise
