// What a deck says about rigid obstacles and rods, and how contact closes in a step.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>

#include "deck/activity.hpp"
#include "deck/bounds.hpp"
#include "deck/fields.hpp"

namespace mortise {

/// What a closed node fulfils at the end of a step.
enum class Closing {
  position,        ///< gap = 0
  modified,        ///< gap as at the start of the step, once it would fall below 0 (thesis eqs. 5.95, 5.98)
  persistent,      ///< the same, for nodes that touched at the start of the step only
  velocity_update  ///< gap = 0; then velocities jump by what gives back the work of the contact (Laursen & Love 2002)
};

/// Whether closing counts from the gap at the start of the step.
constexpr bool counts_from_start(Closing closing) { return closing == Closing::modified || closing == Closing::persistent; }

template <class Fields>
void describe(Fields& f, Closing& o) {
  f.choice(
      "closing", o,
      Choices<Closing>{{"position", Closing::position},
                       {"modified", Closing::modified},
                       {"persistent", Closing::persistent},
                       {"velocity update", Closing::velocity_update}},
      Presence::optional,
      "what contact asks for at the end of a step. position: no gap; takes energy when a node closes. modified: the gap as it "
      "was at the start of the step, as soon as it would be negative; takes no energy, and stops short. persistent: velocities "
      "that do not close, for nodes that touched at the start; takes no energy, and lets a node in by one step of its "
      "velocity. velocity update: no gap; then velocities jump along the contact force so that contact has taken no energy; of "
      "first order, for comparison");
}

namespace obstacles {

struct Plane {
  static constexpr const char* name = "plane";
  static constexpr const char* help = "everything behind a plane";
  std::array<double, 3> point{0, 0, 0};
  std::array<double, 3> normal{0, 0, 1};
};

struct Sphere {
  static constexpr const char* name = "sphere";
  static constexpr const char* help = "a ball; with a small radius a point";
  std::array<double, 3> centre{0, 0, 0};
  double radius = 0;
};

template <class Fields>
void describe(Fields& f, Plane& o) {
  f.optional("point", o.point, anything, "length", "of the plane");
  f.optional("normal", o.normal, anything, "-", "towards where nodes may be; of any length");
  f.rule("D08", {"normal"}, o.normal != std::array<double, 3>{0, 0, 0}, "must not be zero");
}

template <class Fields>
void describe(Fields& f, Sphere& o) {
  f.optional("centre", o.centre, anything, "length", "of the ball");
  f.required("radius", o.radius, positive, "length", "of the ball");
}

}  // namespace obstacles

using ObstacleKind = std::variant<obstacles::Plane, obstacles::Sphere>;

/// One entry of `obstacles`.
struct ObstacleOptions {
  std::string set;
  std::optional<ObstacleKind> kind;  ///< always set once the deck has been read
  Closing closing = Closing::position;
  Activity activity;
};

template <class Fields>
void describe(Fields& f, ObstacleOptions& o) {
  f.required("set", o.set, anything, "", "mesh name / side set or node set (name or number): the nodes that it keeps out");
  f.kind("type", o.kind, Presence::required, "its shape");
  describe(f, o.closing);
  describe(f, o.activity);
}

/// One entry of `rods`: a node at a fixed distance from a point.
struct RodOptions {
  std::string mesh;
  std::optional<int> node;                       ///< the user's number
  std::optional<std::array<double, 3>> nearest;  ///< reference position
  std::array<double, 3> anchor{0, 0, 0};
  std::optional<double> length;  ///< default: the distance at the start
  Activity activity;
};

template <class Fields>
void describe(Fields& f, RodOptions& o) {
  f.required("mesh", o.mesh, anything, "", "name of an entry of `meshes`");
  f.optional("node", o.node, at_least(1), "-", "the node's own number in the mesh");
  f.optional("nearest", o.nearest, anything, "length", "the node nearest to this reference position, as placed");
  f.exactly_one_of({"node", "nearest"});
  f.optional("anchor", o.anchor, anything, "length", "where the rod turns");
  f.optional("length", o.length, positive, "length", "of the rod; default: the distance in the reference position");
  describe(f, o.activity);
}

}  // namespace mortise
