#include "assembly/dead_loads.hpp"

#include "assembly/bar_geometry.hpp"
#include "assembly/formulations.hpp"
#include "physics/body_force.hpp"
#include "physics/surface_load.hpp"

namespace mortise {

DeadLoads::DeadLoads(const Scene& scene, const Partition& partition, const DofSpace& dofs) : scene_(scene), dofs_(dofs) {
  for (const Load& load : scene.loads) {
    if (load.follows()) continue;
    Part part{load, {}, {}};
    if (const auto* traction = std::get_if<forces::SideTraction>(&load.what))
      part.sides = owned_sides(scene.mesh.mesh, traction->sides, partition, dofs);
    if (const auto* nodal = std::get_if<forces::NodalForce>(&load.what))
      for (int node : nodal->nodes)
        if (dofs.owned(node)) part.nodes.push_back(node);
    parts_.push_back(std::move(part));
  }
  if (!parts_.empty())
    for (int rank : partition.element_rank) is_mine_.push_back(rank == dofs.comm()->getRank());
}

void DeadLoads::add(double step_end, double t, double* f, std::string& fault) const {
  for (const Part& part : parts_)
    if (part.load.activity.acts_at(step_end)) std::visit([&](const auto& what) { add(part, what, t, f, fault); }, part.load.what);
}

void DeadLoads::add(const Part& part, const forces::SideTraction& load, double t, double* f, std::string& fault) const {
  for (const LocalSide& side : part.sides)
    with_side(static_cast<int>(side.nodes.size()), [&](auto kind) {
      using Kind = decltype(kind);
      const auto X = reference_positions<Kind>(scene_.mesh.mesh, side);
      AtSidePoints<Kind, Vec3<double>> traction;
      for (std::size_t g = 0; g < traction.size(); ++g)
        traction[g] = evaluate(load.traction, t, point_of_side<Kind>(X, Kind::rule[g].xi), fault);
      double force[3 * Kind::n_nodes] = {};
      add_traction_force<Kind>(X, traction, force);
      scatter(side.local, force, f);
    });
}

void DeadLoads::add(const Part&, const forces::Acceleration& load, double t, double* f, std::string& fault) const {
  for (int s : load.strings) add_weight(scene_.strings[s], load.acceleration, t, f, fault);
  for (int m : load.masses) add_weight(scene_.masses[m], load.acceleration, t, f, fault);
  const Mesh& mesh = scene_.mesh.mesh;
  for (int b : load.bodies)
    for (int e : scene_.bodies[b].elements) {
      if (!is_mine_[e]) continue;
      with_element(element_type(mesh, e), [&](auto element) {
        using Element = decltype(element);
        const ElementNodeList nodes = element_nodes(mesh, e);
        ElementNodes<Element> X;
        std::vector<int> local;
        for (std::size_t a = 0; a < X.size(); ++a) {
          X[a] = mesh.coordinates[nodes[a]];
          local.push_back(dofs_.local(nodes[a]));
        }
        double force[3 * Element::n_nodes] = {};
        add_body_force<Element>(
            X, *scene_.bodies[b].density,
            [&](const Point& at) {
              const Vec3<double> a = evaluate(load.acceleration, t, at, fault);
              return std::array<double, 3>{a[0], a[1], a[2]};
            },
            force);
        scatter(local, force, f);
      });
    }
}

void DeadLoads::add_weight(const String& string, const PlacedVector& acceleration, double t, double* f,
                           std::string& fault) const {
  const Mesh& mesh = scene_.mesh.mesh;
  for (int e : string.elements) {
    if (!is_mine_[e]) continue;
    const ElementNodeList nodes = element_nodes(mesh, e);
    for (const PointOfBar& at : points_of_bar(mesh, nodes, static_cast<int>(nodes.size()))) {
      Point X{0, 0, 0};
      for (std::size_t a = 0; a < nodes.size(); ++a)
        for (int i = 0; i < 3; ++i) X[i] += at.N[a] * mesh.coordinates[nodes[a]][i];
      const Vec3<double> acting = evaluate(acceleration, t, X, fault);
      for (std::size_t a = 0; a < nodes.size(); ++a)
        for (int i = 0; i < 3; ++i) f[dofs_.local(nodes[a]) + i] += *string.line_density * at.length * at.N[a] * acting[i];
    }
  }
}

void DeadLoads::add_weight(const PointMasses& masses, const PlacedVector& acceleration, double t, double* f,
                           std::string& fault) const {
  for (int node : masses.nodes) {
    if (!dofs_.owned(node)) continue;
    const Vec3<double> a = evaluate(acceleration, t, scene_.mesh.mesh.coordinates[node], fault);
    for (int i = 0; i < 3; ++i) f[dofs_.local(node) + i] += masses.mass * a[i];
  }
}

void DeadLoads::add(const Part& part, const forces::NodalForce& load, double t, double* f, std::string& fault) const {
  for (int node : part.nodes) {
    const Vec3<double> force = evaluate(load.force, t, scene_.mesh.mesh.coordinates[node], fault);
    for (int i = 0; i < 3; ++i) f[dofs_.local(node) + i] += force[i];
  }
}

}  // namespace mortise
