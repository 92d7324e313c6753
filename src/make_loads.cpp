#include "make_loads.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "deck/names.hpp"
#include "physics/traction.hpp"
#include "prescribed_motion.hpp"

namespace mortise {
namespace {

/// Area vector [m^2] of all sides together, and their area.
std::pair<Vec3<double>, double> area_of(const Mesh& mesh, const std::vector<Side>& sides) {
  Vec3<double> vector{0, 0, 0};
  double area = 0;
  for (const Side& side : sides) {
    const auto nodes = side_nodes(mesh, side);
    with_side(static_cast<int>(nodes.size()), [&](auto kind) {
      using Kind = decltype(kind);
      std::array<Point, Kind::n_nodes> X;
      for (std::size_t a = 0; a < X.size(); ++a) X[a] = mesh.coordinates[nodes[a]];
      for (const auto& point : Kind::rule) {
        const auto [along, across] = side_tangents<Kind>(X, point.xi);
        const Vec3<double> normal = cross(along, across);
        vector = vector + point.weight * normal;
        area += point.weight * norm(normal);
      }
    });
  }
  return {vector, area};
}

/// The axis that a flat side set is normal to; an error, and 0, if there is none.
int normal_axis(const DeckNames& names, const Scene& scene, const std::string& set, const DeckPath& path) {
  const SideSet* sides = names.sides_of(set, path);
  if (!sides) return 0;
  const auto& X = scene.mesh.mesh.coordinates;
  const auto nodes = names.nodes_of(set, path);
  const auto [vector, area] = area_of(scene.mesh.mesh, sides->sides);
  const Vec3<double> normal = (1 / area) * vector;  // shorter than 1 where sides look in different directions
  double off = 0;
  for (int n : nodes) {
    const Vec3<double> arm{X[n][0] - X[nodes[0]][0], X[n][1] - X[nodes[0]][1], X[n][2] - X[nodes[0]][2]};
    off = std::max(off, std::abs(dot(arm, normal)));
  }
  if (norm(normal) < 0.999 || off > 1e-9 * std::sqrt(area)) {
    names.error("D20", path, "is not flat - a symmetry plane is needed; other sides take a support of type \"displacement\"");
    return 0;
  }
  for (int axis = 0; axis < 3; ++axis)
    if (1 - std::abs(normal[axis]) < 1e-12) return axis;
  const auto rounded = [&](int i) { return std::round(1e6 * normal[i]) / 1e6 + 0.0; };  // no negative zero
  names.error("D20", path,
              fmt::format("is normal to ({}, {}, {}) - a symmetry plane must be normal to x, y or z: turn the mesh by its "
                          "\"rotation\"",
                          rounded(0), rounded(1), rounded(2)));
  return 0;
}

class MotionMaker {
 public:
  MotionMaker(const DeckNames& names, const Scene& scene, const std::string& name, const std::string& set)
      : names_(names), scene_(scene), entry_{"supports", name}, set_(set) {}

  Motion operator()(const supports::Displacement& o) const {
    return motions::Displacement{names_.formulas(o.displacement, entry_)};
  }
  Motion operator()(const supports::Velocity& o) const { return motions::Velocity{names_.formulas(o.velocity, entry_)}; }
  Motion operator()(const supports::Rotation& o) const {
    const Vec3<double> axis{o.axis[0], o.axis[1], o.axis[2]};
    return motions::Rotation{(1 / norm(axis)) * axis,
                             {o.point[0], o.point[1], o.point[2]},
                             names_.formula(*o.angle, {entry_[0], entry_[1], "angle"}),
                             names_.formulas(o.displacement, entry_)};
  }
  Motion operator()(const supports::Symmetry&) const {
    return motions::Symmetry{normal_axis(names_, scene_, set_, {entry_[0], entry_[1], "set"})};
  }

 private:
  const DeckNames& names_;
  const Scene& scene_;
  const DeckPath entry_;
  const std::string& set_;
};

/// The supports of bodies in plane strain: each holds z of all nodes of its body, always. They come after those of the deck, to
/// which the reactions of nodes that both hold belong.
void hold_plane_bodies(const DeckNames& names, Scene& scene) {
  for (const Body& body : scene.bodies) {
    if (body.kinematics != Kinematics::plane_strain) continue;
    Support support{plane_strain_support(body.name), "plane strain", motions::Symmetry{2}, {}, {}};
    support.where_contradicting.fill(names.deck().error("D21", {"bodies", body.name, "kinematics"}, ""));
    for (int node : body.nodes) scene.prescribed.push_back({node, 2, static_cast<int>(scene.supports.size())});
    scene.supports.push_back(std::move(support));
  }
}

class SpringMaker {
 public:
  SpringMaker(const DeckNames& names, Scene& scene, const std::string& name, const Activity& activity)
      : names_(names), scene_(scene), name_(name), activity_(activity) {}

  void operator()(const springs::Nodes& o) const { scene_.springs.push_back(to_the_ground(o)); }
  void operator()(const springs::Bedding& o) const {
    Spring spring = to_the_ground(o);
    if (!spring.nodes.empty())
      if (const SideSet* sides = names_.sides_of(o.set, path("set"))) spring.sides = sides->sides;
    scene_.springs.push_back(std::move(spring));
  }
  void operator()(const springs::Between& o) const {
    NodeSpring spring{name_, activity_, one_node(o.from, "from"), {}, o.anchor.value_or(Point{}), 0, o.stiffness, o.law, {}};
    if (o.to) spring.to = one_node(*o.to, "to");
    if (spring.from < 0 || spring.to == -1) return;
    const Mesh& mesh = scene_.mesh.mesh;
    const Point &X = mesh.coordinates[spring.from], &Y = spring.far_end(mesh);
    const double distance = std::hypot(Y[0] - X[0], Y[1] - X[1], Y[2] - X[2]);
    if (distance == 0)
      names_.error("D19", {"springs", name_}, "its ends are in one place: a spring without length has no direction");
    spring.rest_length = o.rest_length.value_or(distance);
    if (o.formulation == SpringFormulation::augmented) spring.augmented = scene_.n_augmented_springs++;
    scene_.node_springs.push_back(spring);
  }

 private:
  DeckPath path(const std::string& parameter) const { return {"springs", name_, parameter}; }

  Spring to_the_ground(const springs::Stiffness& o) const {
    Spring spring{name_, activity_, {}, names_.nodes_of(o.set, path("set")), {}};
    for (int i = 0; i < 3; ++i) spring.stiffness[i] = o.stiffness[i].value_or(0);
    return spring;
  }

  /// The node of a set that holds one; an error, and -1, otherwise.
  int one_node(const std::string& set, const std::string& parameter) const {
    const auto nodes = names_.nodes_of(set, path(parameter));
    if (nodes.size() == 1) return nodes[0];
    if (!nodes.empty()) names_.error("D19", path(parameter), fmt::format("has {} nodes - must have one", nodes.size()));
    return -1;
  }

  const DeckNames& names_;
  Scene& scene_;
  const std::string name_;
  const Activity activity_;
};

class LoadMaker {
 public:
  LoadMaker(const DeckNames& names, const Scene& scene, const std::string& name)
      : names_(names), scene_(scene), entry_{"loads", name} {}

  using What = decltype(Load::what);
  What operator()(const loads::Traction& o) const { return traction(o, false); }
  What operator()(const loads::CauchyTraction& o) const { return traction(o, true); }
  What operator()(const loads::Pressure& o) const {
    return forces::SidePressure{sides(o.set), names_.formula(*o.pressure, {entry_[0], entry_[1], "pressure"})};
  }
  What operator()(const loads::BodyForce& o) const {
    forces::Acceleration force{{}, {}, {}, names_.formulas(o.acceleration, entry_)};
    for (std::size_t b = 0; b < scene_.bodies.size(); ++b)
      if (!o.body || scene_.bodies[b].name == *o.body) force.bodies.push_back(static_cast<int>(b));
    for (std::size_t m = 0; m < scene_.masses.size(); ++m)
      if (!o.body || scene_.masses[m].name == *o.body) force.masses.push_back(static_cast<int>(m));
    for (std::size_t s = 0; s < scene_.strings.size(); ++s)
      if (!o.body || scene_.strings[s].name == *o.body) force.strings.push_back(static_cast<int>(s));
    return force;
  }
  What operator()(const loads::PointForce& o) const {
    forces::NodalForce force{{}, names_.formulas(o.force, entry_)};
    if (o.set) {
      force.nodes = names_.nodes_of(*o.set, {entry_[0], entry_[1], "set"});
    } else if (const auto node = names_.node_of(*o.mesh, o.node, o.nearest, entry_)) {
      force.nodes = {*node};
    }
    return force;
  }

 private:
  What traction(const loads::OnSides& o, bool over_current_area) const {
    return forces::SideTraction{sides(o.set), names_.formulas(o.traction, entry_), over_current_area};
  }
  std::vector<Side> sides(const std::string& set) const {
    const SideSet* found = names_.sides_of(set, {entry_[0], entry_[1], "set"});
    return found ? found->sides : std::vector<Side>{};
  }

  const DeckNames& names_;
  const Scene& scene_;
  const DeckPath entry_;
};

void insert_ascending(std::vector<double>& values, double value) {
  const auto at = std::lower_bound(values.begin(), values.end(), value);
  if (at == values.end() || *at != value) values.insert(at, value);
}

}  // namespace

void make_supports(const DeckNames& names, Scene& scene) {
  for (const auto& [name, o] : names.deck().options().supports) {
    Support support{name, name_of_kind(o.kind), std::visit(MotionMaker(names, scene, name, o.set), o.kind), o.activity, {}};
    for (int i = 0; i < 3; ++i)
      support.where_contradicting[i] = names.deck().error("D21", {"supports", name, std::string(1, "xyz"[i])}, "");
    for (int node : names.nodes_of(o.set, {"supports", name, "set"}))
      for (int i = 0; i < 3; ++i)
        if (support.holds(i)) scene.prescribed.push_back({node, i, static_cast<int>(scene.supports.size())});
    scene.supports.push_back(std::move(support));
  }
  hold_plane_bodies(names, scene);
  std::sort(scene.prescribed.begin(), scene.prescribed.end(), [](const PrescribedDof& a, const PrescribedDof& b) {
    return std::tie(a.node, a.axis, a.support) < std::tie(b.node, b.axis, b.support);
  });
}

void make_springs(const DeckNames& names, Scene& scene) {
  for (const auto& [name, o] : names.deck().options().springs) std::visit(SpringMaker(names, scene, name, o.activity), *o.kind);
}

void make_loads(const DeckNames& names, Scene& scene) {
  for (const auto& [name, o] : names.deck().options().loads)
    scene.loads.push_back({name, name_of_kind(*o.kind), std::visit(LoadMaker(names, scene, name), *o.kind), o.activity});
}

void add_stops(Scene& scene) {
  const auto add = [&](const std::optional<double>& time) {
    if (!time) return;
    for (Stage& stage : scene.stages)
      if (*time > stage.begin && *time < stage.time.end) insert_ascending(stage.time.stops, *time);
  };
  const auto add_all = [&](const auto& entries) {
    for (const auto& entry : entries) {
      add(entry.activity.start);
      add(entry.activity.end);
    }
  };
  add_all(scene.supports);
  add_all(scene.springs);
  add_all(scene.node_springs);
  add_all(scene.loads);
  add_all(scene.pairs);
  add_all(scene.obstacles);
}

void check_motions(const DeckNames& names, const Scene& scene) {
  std::vector<double> times{0.0};
  for (const Stage& stage : scene.stages) {
    times.push_back(stage.time.end);
    times.insert(times.end(), stage.time.stops.begin(), stage.time.stops.end());
  }
  std::set<std::pair<int, int>> told;  // pairs of supports: the first node is enough
  for (std::size_t k = 0; k < scene.prescribed.size(); ++k) {
    for (std::size_t l = k + 1; l < scene.prescribed.size(); ++l) {
      const PrescribedDof &first = scene.prescribed[k], &second = scene.prescribed[l];
      if (first.node != second.node || first.axis != second.axis) break;
      const Support &a = scene.supports[first.support], &b = scene.supports[second.support];
      if (is_increment(a) || is_increment(b) || told.count({first.support, second.support})) continue;
      for (double t : times) {
        if (!a.activity.acts_at(t) || !b.activity.acts_at(t)) continue;
        std::string fault;
        const Point& X = scene.mesh.mesh.coordinates[first.node];
        const std::string message = contradiction(scene, first, second, prescribed_displacement(a, first.axis, X, t, t, fault),
                                                  prescribed_displacement(b, first.axis, X, t, t, fault), t);
        if (message.empty()) continue;
        names.tell(message);
        told.insert({first.support, second.support});
        break;
      }
    }
  }
}

}  // namespace mortise
