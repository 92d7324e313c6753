#include "make_obstacles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mesh/combine.hpp"
#include "physics/traction.hpp"

namespace mortise {
namespace {

ObstacleShape shape(const obstacles::Plane& o) {
  const Vec3<double> n = vec3(o.normal);
  return shapes::Plane{vec3(o.point), (1 / norm(n)) * n};
}
ObstacleShape shape(const obstacles::Sphere& o) { return shapes::Sphere{vec3(o.centre), o.radius}; }

class ObstacleMaker {
 public:
  ObstacleMaker(const DeckNames& names, Scene& scene) : names_(names), scene_(scene) {}

  void make() {
    const DeckOptions& options = names_.deck().options();
    for (const auto& [name, o] : options.obstacles) {
      Obstacle obstacle = entry("obstacles", name, o.activity);
      obstacle.secondary_nodes = names_.nodes_of(o.set, {"obstacles", name, "set"});
      obstacle.shape = std::visit([](const auto& kind) { return shape(kind); }, *o.kind);
      obstacle.closing = o.closing;
      find_areas(obstacle, o.set);
      add(std::move(obstacle), {"obstacles", name, "set"});
    }
    for (const auto& [name, o] : options.rods) {
      const auto node = names_.node_of(o.mesh, o.node, o.nearest, {"rods", name});
      if (!node) continue;
      Obstacle rod = entry("rods", name, o.activity);
      rod.secondary_nodes = {*node};
      rod.tributary_area = {scene_.size * scene_.size};
      rod.is_two_sided = true;
      const Point& X = scene_.mesh.mesh.coordinates[*node];
      const Vec3<double> anchor = vec3(o.anchor), arm = vec3(X) - anchor;
      rod.shape = shapes::Sphere{anchor, o.length.value_or(norm(arm))};
      if (norm(arm) > 0) {
        add(std::move(rod), {"rods", name});
      } else {
        names_.error("D20", {"rods", name}, "has its node where it is anchored - a rod has a length");
      }
    }
  }

 private:
  Obstacle entry(const std::string& list, const std::string& name, const Activity& activity) const {
    Obstacle obstacle;
    obstacle.name = name;
    obstacle.activity = activity;
    obstacle.size = scene_.size;
    obstacle.where_penetrating = names_.deck().error("M51", {list, name}, "");
    return obstacle;
  }

  void add(Obstacle obstacle, const DeckPath& place) {
    for (const ContactNodes* other : scene_.contacts())
      for (int node : obstacle.secondary_nodes)
        if (std::binary_search(other->secondary_nodes.begin(), other->secondary_nodes.end(), node)) {
          names_.error("D19", place,
                       fmt::format("{} has a contact pressure of \"{}\" already - a node has one",
                                   describe_node(scene_.mesh, node), other->name));
          return;
        }
    for (const Body& body : scene_.bodies)
      for (int node : obstacle.secondary_nodes)
        if (std::binary_search(body.nodes.begin(), body.nodes.end(), node))
          obstacle.youngs_modulus = std::max(obstacle.youngs_modulus, body.youngs_modulus);
    obstacle.first_multiplier = scene_.n_multipliers;
    scene_.n_multipliers += static_cast<int>(obstacle.secondary_nodes.size());
    scene_.obstacles.push_back(std::move(obstacle));
  }

  /// How much of a surface each node stands for: an equal share of every side; without sides the square of the element size.
  void find_areas(Obstacle& obstacle, const std::string& set) const {
    const auto& nodes = obstacle.secondary_nodes;
    const SideSet* sides = find_side_set(scene_.mesh, set);
    obstacle.tributary_area.assign(nodes.size(), sides ? 0 : scene_.size * scene_.size);
    if (!sides) return;
    const Mesh& mesh = scene_.mesh.mesh;
    for (const Side& side : sides->sides) {
      const auto of_side = side_nodes(mesh, side);
      with_side(static_cast<int>(of_side.size()), [&](auto kind) {
        using Kind = decltype(kind);
        std::array<Point, Kind::n_nodes> X;
        for (std::size_t a = 0; a < X.size(); ++a) X[a] = mesh.coordinates[of_side[a]];
        double area = 0;
        for (double weight : side_weights<Kind>(X)) area += weight;
        for (int node : of_side)
          obstacle.tributary_area[std::lower_bound(nodes.begin(), nodes.end(), node) - nodes.begin()] += area / Kind::n_nodes;
      });
    }
  }

  const DeckNames& names_;
  Scene& scene_;
};

}  // namespace

void make_obstacles(const DeckNames& names, Scene& scene) { ObstacleMaker(names, scene).make(); }

}  // namespace mortise
