// The descriptions of all recipes: their parameters in a deck, with bounds, defaults and help (see deck/fields.hpp).
#pragma once

#include <algorithm>
#include <cmath>

#include "deck/bounds.hpp"
#include "deck/fields.hpp"
#include "mesh/recipes/axis.hpp"
#include "mesh/recipes/recipes.hpp"

namespace mortise::recipes {

inline const Bound element_count = within(1, 1e6);
inline const Bound size_ratio = within(1e-6, 1e6).because("beyond that elements are flat");

/// @param n_nodes a bound of the number of nodes from above
template <class Fields>
void limit_nodes(Fields& f, double n_nodes) {
  f.rule("D08", {"elements"}, n_nodes < 2147483648., "must give fewer than 2^31 nodes");
}

/// Number of nodes of a lattice.
template <std::size_t N>
double lattice_nodes(const std::array<int, N>& elements) {
  double n = 1;
  for (int count : elements) n *= count + 1.;
  return n;
}

/// Size and number of elements of what is a block but for one of its faces.
template <class Fields, class Kind>
void describe_box(Fields& f, Kind& o, const std::string& size_help) {
  f.optional("size", o.size, positive, "length", size_help);
  f.optional("elements", o.elements, element_count, "-", "number of elements in x, y, z");
  limit_nodes(f, lattice_nodes(o.elements));
}

template <class Fields>
void describe(Fields& f, Block& o) {
  describe_box(f, o, "edge lengths in x, y, z");
}

template <class Fields>
void describe(Fields& f, GradedBlock& o) {
  describe_box(f, o, "edge lengths in x, y, z");
  f.optional("grading", o.grading, size_ratio, "-", "size of the last element over the size of the first, in x, y, z");
}

/// Radii of a wall.
template <class Fields, class Kind>
void describe_wall(Fields& f, Kind& o, const std::string& what) {
  f.required("inner radius", o.inner_radius, positive, "length", "inner radius of the " + what);
  f.required("outer radius", o.outer_radius, positive, "length", "outer radius of the " + what);
  f.rule("D08", {"outer radius", "inner radius"}, o.outer_radius > o.inner_radius, "must be greater than \"inner radius\"",
         " = " + shortest(o.inner_radius));
}

template <class Fields>
void describe(Fields& f, HollowSphere& o) {
  describe_wall(f, o, "shell");
  f.optional("elements", o.elements, element_count, "-",
             "number of elements along an edge of the cube (a quarter of a great circle), through the wall");
  f.optional("grading", o.grading, size_ratio, "-", "size of the outermost element over that of the innermost");
  limit_nodes(f, 6 * (o.elements[0] + 1.) * lattice_nodes(o.elements));
}

template <class Fields>
void describe(Fields& f, Torus& o) {
  f.required("ring radius", o.ring_radius, positive, "length", "radius of the centre line of the tube");
  describe_wall(f, o, "tube");
  f.optional("elements", o.elements, element_count, "-", "number of elements around the ring, around the tube, through the wall");
  f.optional("grading", o.grading, size_ratio, "-", "size of the outermost element over that of the innermost");
  f.rule("D08", {"ring radius", "outer radius"}, o.ring_radius > o.outer_radius, "must be greater than \"outer radius\"",
         " = " + shortest(o.outer_radius));
  f.rule("D08", {"elements"}, o.elements[0] >= 3 && o.elements[1] >= 3, "must be at least 3 around the ring and the tube");
  limit_nodes(f, lattice_nodes(o.elements));
}

template <class Fields>
void describe(Fields& f, Cylinder& o) {
  f.required("radius", o.radius, positive, "length", "radius of the cylinder");
  f.required("height", o.height, positive, "length", "length along z");
  f.optional("elements", o.elements, element_count, "-",
             "number of elements along a side of the core (a quarter of the circumference), through the shells, along z");
  f.optional("grading", o.grading, size_ratio, "-",
             "size of the last element over that of the first, outwards through the shells, along z");
  const double core = o.elements[0] + 1.;
  limit_nodes(f, (core * core + 4 * core * (o.elements[1] + 1.)) * (o.elements[2] + 1.));
}

template <class Fields>
void describe(Fields& f, HollowCylinder& o) {
  describe_wall(f, o, "tube");
  f.required("height", o.height, positive, "length", "length along z");
  f.optional("elements", o.elements, element_count, "-", "number of elements around, through the wall, along z");
  f.optional("grading", o.grading, size_ratio, "-",
             "size of the last element over that of the first, outwards through the wall, along z");
  f.rule("D08", {"elements"}, o.elements[0] >= 3, "must be at least 3 around");
  limit_nodes(f, lattice_nodes(o.elements));
}

/// Angle [degrees] that the widest element of a sector spans.
inline double widest_element(const RingSector& o) {
  const int n = o.elements[0];
  if (first_outside(element_count, n) || !(o.grading[0] > 0)) return 0;  // reported already
  const auto degrees = graded_axis(0, o.angle, n, o.grading[0]);
  return std::max(at(degrees, 1) - at(degrees, 0), at(degrees, n) - at(degrees, n - 1));
}

template <class Fields>
void describe(Fields& f, RingSector& o) {
  describe_wall(f, o, "tube");
  f.required("height", o.height, positive, "length", "length along z");
  f.required("angle", o.angle, between(0, 360).because("the whole ring is the recipe \"hollow cylinder\""), "degrees",
             "angle of the sector");
  f.optional("elements", o.elements, element_count, "-", "number of elements around, through the wall, along z");
  f.optional("grading", o.grading, size_ratio, "-",
             "size of the last element over that of the first, around, outwards through the wall, along z");
  f.rule("D08", {"elements", "angle", "grading"}, widest_element(o) <= 120,
         "must be so many around that each spans at most 120 degrees");
  limit_nodes(f, lattice_nodes(o.elements));
}

/// Height of a circle of radius R above its lowest point at the distance d <= R from there: R - sqrt(R^2 - d^2), without
/// cancellation; 0 at no distance, whatever the radius.
inline double sagitta(double R, double d) { return d == 0 ? 0 : d * d / (R + std::sqrt((R - d) * (R + d))); }

/// How far the lower face reaches from its crown.
inline double reach(const CurvedIndenter& o) {
  const double x = (o.part == CurvedIndenter::Part::whole ? 0.5 : 1) * o.size[0],
               y = (o.part == CurvedIndenter::Part::quarter ? 1 : 0.5) * o.size[1];
  return o.shape == CurvedIndenter::Shape::sphere ? std::hypot(x, y) : x;
}

template <class Fields>
void describe(Fields& f, CurvedIndenter& o) {
  using Shape = CurvedIndenter::Shape;
  using Part = CurvedIndenter::Part;
  describe_box(f, o, "edge lengths in x, y, z; the height is that at the crown");
  f.required("radius", o.radius, positive, "length", "radius of the lower face");
  f.choice("shape", o.shape, Choices<Shape>{{"cylinder", Shape::cylinder}, {"sphere", Shape::sphere}}, Presence::optional,
           "what the lower face is a part of; the axis of the cylinder is along y");
  f.choice("part", o.part, Choices<Part>{{"whole", Part::whole}, {"half", Part::half}, {"quarter", Part::quarter}},
           Presence::optional,
           "what is meshed where the rest is its mirror image: half: from the crown on in x, whose left side is then at the "
           "crown; quarter: in y too, with the front at the crown");
  f.optional("grading", o.grading, size_ratio, "-",
             "in x and y: size of elements at the rim over that at the crown; in z: of the last over the first");
  const double rim = reach(o);
  f.rule("D08", {"radius", "size"}, o.radius >= rim, "must reach to the rim of the lower face", ", " + shortest(rim) + " off");
  f.rule("D08", {"size", "radius"}, o.radius < rim || sagitta(o.radius, rim) < o.size[2],
         "must be higher than the lower face is curved");
}

template <class Fields>
void describe(Fields& f, QuarterIndenter& o) {
  f.required("radius", o.radius, positive, "length", "radius of the lower face");
  f.required("rim radius", o.rim_radius, positive, "length", "radius of the block");
  f.required("core radius", o.core_radius, positive, "length", "from the axis to the corner of the core of squares");
  f.required("height", o.height, positive, "length", "length along the axis");
  f.optional("elements", o.elements, element_count, "-",
             "number of elements along a side of the core (an eighth of the circumference), through the shells, along z");
  f.optional("grading", o.grading, size_ratio, "-",
             "size of the last element over that of the first, outwards through the shells, along z");
  f.rule("D08", {"core radius", "rim radius"}, o.core_radius < o.rim_radius, "must be less than \"rim radius\"",
         " = " + shortest(o.rim_radius));
  f.rule("D08", {"radius", "rim radius"}, o.radius >= o.rim_radius, "must reach to the rim of the lower face",
         ", " + shortest(o.rim_radius) + " off");
  f.rule("D08", {"height", "radius", "rim radius"}, o.radius < o.rim_radius || sagitta(o.radius, o.rim_radius) < o.height,
         "must be higher than the lower face is curved");
  const double core = o.elements[0] + 1.;
  limit_nodes(f, (core * core + 2 * core * (o.elements[1] + 1.)) * (o.elements[2] + 1.));
}

template <class Fields>
void describe(Fields& f, Wedge& o) {
  describe_box(f, o, "edge lengths in x, y, z; the height is that of the left side");
  f.required("slope", o.slope, anything, "-",
             "rise of the top face over its run in x: the tangent of its angle; may be negative");
  f.optional("grading", o.grading, size_ratio, "-", "size of the last element over the size of the first, in x, y, z");
  f.rule("D08", {"slope", "size"}, o.size[2] + o.slope * o.size[0] > 0, "must leave the right side a positive height");
}

template <class Fields>
void describe(Fields& f, LBlock& o) {
  f.optional("size", o.size, positive, "length", "edge lengths in x, y, z of the box around it");
  f.optional("thickness", o.thickness, positive, "length", "of the leg in x, of the foot in z");
  f.optional("elements", o.elements, element_count, "-",
             "number of elements in x through the leg and along the rest of the foot, in y, in z through the foot and along the "
             "rest of the leg");
  f.rule("D08", {"thickness", "size"}, o.thickness[0] < o.size[0] && o.thickness[1] < o.size[2],
         "must be less than \"size\" in x and z");
  const auto& n = o.elements;
  limit_nodes(f, lattice_nodes(std::array<int, 3>{n[0] + n[1], n[2], n[3] + n[4]}));
}

template <class Fields>
void describe(Fields& f, Hexahedron& o) {
  f.optional(
      "corners", o.corners, anything, "length",
      "x, y, z of the eight corners: the lower four counter-clockwise seen from above, from left front, then the upper four");
  f.optional("elements", o.elements, element_count, "-", "number of elements along the three directions");
  f.optional("grading", o.grading, size_ratio, "-", "size of the last element over the size of the first, per direction");
  limit_nodes(f, lattice_nodes(o.elements));
}

template <class Fields>
void describe(Fields& f, Points& o) {
  f.required("coordinates", o.coordinates, anything, "length", "x, y, z of the first point, of the second, ...");
  f.rule("D17", {"coordinates"}, !o.coordinates.empty() && o.coordinates.size() % 3 == 0,
         "must hold three numbers for each point");
}

template <class Fields>
void describe(Fields& f, Line& o) {
  f.optional("from", o.from, anything, "length", "position of the start");
  f.optional("to", o.to, anything, "length", "position of the end");
  f.optional("elements", o.elements, element_count, "-", "number of bars");
  f.optional("order", o.order, within(1, 3), "-", "of their shape functions: bars with 2, 3 or 4 nodes");
  f.rule("D08", {"to", "from"}, o.from != o.to, "must differ from \"from\"");
}

}  // namespace mortise::recipes
