// Which rigid motions of the bodies nothing holds: in statics they make the tangent singular.
#pragma once

#include <string>
#include <vector>

#include "scene.hpp"

namespace mortise {

/// A body that can move as a rigid one, and how, in words.
struct FreeBody {
  std::string body;
  std::vector<std::string> modes;  ///< e.g. "translation z", "rotation y"
};

/// Free rigid motions of all bodies together in a step that begins at time `from`, held by supports and springs that act then, by
/// closed contact (relative motion along the normal), and by damping that grows with the mass.
/// The null space of the 6 n_bodies x 6 n_bodies matrix R^T R, R the constraints on rigid motions about each body's centre.
/// @param closed per multiplier: the node is in contact  @param normals per multiplier: unit normal of the secondary node
std::vector<FreeBody> free_bodies(const Scene& scene, const std::vector<char>& closed, const std::vector<Vec3<double>>& normals,
                                  double from);

}  // namespace mortise
