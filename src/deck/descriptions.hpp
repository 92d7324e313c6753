// The descriptions of all lists of a deck: names, types, units, bounds, defaults and help, each said once (see fields.hpp).
#pragma once

#include <algorithm>
#include <functional>

#include "deck/bounds.hpp"
#include "deck/field_table.hpp"
#include "deck/fields.hpp"
#include "deck/load_descriptions.hpp"
#include "deck/material_descriptions.hpp"
#include "deck/names.hpp"
#include "deck/options.hpp"
#include "deck/support_descriptions.hpp"
#include "mesh/recipes/descriptions.hpp"

namespace mortise {

inline bool is_strictly_ascending(const std::vector<double>& values) {
  return std::adjacent_find(values.begin(), values.end(), std::greater_equal<double>()) == values.end();
}

inline bool is_sha256(const std::string& text) {
  return text.size() == 64 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

/// What makes a mesh from a recipe, and where a mesh is placed.
template <class Fields>
void describe_recipe(Fields& f, MeshOptions& o, Presence recipe) {
  f.kind("recipe", o.recipe, recipe,
         "a shape that is meshed, with hexahedra but for points and line; it makes one element block, named after the recipe (a "
         "graded block too is a "
         "block)");
  Choices<ElementType> types;
  for (ElementType type : element_types) types.emplace_back(topology(type).name, type);
  f.choice("element type", o.element_type, types, Presence::optional,
           "of a recipe's elements: each hexahedron as one hex8, hex20 or hex27, two wedge6, or six tet4 or tet10; nodes between "
           "corners are in the middle of straight edges");
  f.only_with({"element type"}, "recipe", !o.recipe || makes_solids(*o.recipe), "a \"recipe\" of hexahedra");
  f.optional("origin", o.origin, anything, "length", "where the mesh's own origin is placed");
  f.optional("rotation", o.rotation, anything, "-, degrees", "axis x, y, z and angle; the mesh is turned before it is placed");
  f.rule("D08", {"rotation"}, o.rotation[0] != 0 || o.rotation[1] != 0 || o.rotation[2] != 0,
         "must have an axis that is not zero");
}

template <class Fields>
void describe(Fields& f, MeshOptions& o) {
  f.optional("file", o.file, anything, "", "Exodus file with the mesh; the path is relative to the deck");
  f.optional("sha256", o.sha256, anything, "", "SHA-256 of the file, as sha256sum prints it; a file with another one is refused");
  f.only_with({"sha256"}, "file", o.file.has_value(), "\"file\"");
  f.rule("D08", {"sha256"}, !o.sha256 || is_sha256(*o.sha256), "must have 64 hexadecimal digits, in lower case");
  describe_recipe(f, o, Presence::optional);
  f.only_with({"element type"}, "recipe", o.recipe.has_value(), "\"recipe\"");
  f.exactly_one_of({"file", "recipe"});
}

template <class Fields>
void describe(Fields& f, BodyOptions& o) {
  f.required("mesh", o.mesh, anything, "", "name of an entry of `meshes`");
  f.optional("blocks", o.blocks, anything, "", "element blocks of the mesh, by name or number; default: all of them");
  f.required("material", o.material, anything, "", "name of an entry of `materials`");
  f.choice(
      "formulation", o.formulation, formulation_names, Presence::optional,
      "standard: displacements alone; locks where the volume can hardly change, unless elements are quadratic. f-bar (hex8): "
      "the change of volume is the element's mean. enhanced strain (hex8): nine strains of its own per element, good in "
      "bending too. mixed (hex8 with a constant, hex27 with a linear pressure): for materials that are split into distortion "
      "and volume, up to exact incompressibility; needs the direct solver");
  f.choice(
      "kinematics", o.kinematics,
      Choices<Kinematics>{{"three-dimensional", Kinematics::three_dimensional}, {"plane strain", Kinematics::plane_strain}},
      Presence::optional,
      "plane strain: no node of the body moves in z, as if a support \"plane strain of <body>\" held it; what the deck's own "
      "supports give in z must be 0 too, and the forces there are theirs. The forces that hold z pull at one face and push "
      "at the other: their sum, reaction_z of that support, is 0 unless loads or other supports act in z");
  f.choice("tangent", o.tangent, tangent_names, Presence::optional,
           "how elements are differentiated: AD of the stress at each quadrature point, moduli derived by hand, AD or complex "
           "step of the element's force as a whole (slower, the same numbers), or differences (slower and inexact)");
  f.choice("mass", o.mass, mass_names, Presence::optional,
           "consistent: by a rule that is exact for straight edges; consistent 2x2x2: by the rule of the stiffness, for hex8 the "
           "thesis' 2 x 2 x 2 points (not for tetrahedra, whose rule has too few); lumped: diagonal, positive for every element; "
           "lumped off "
           "contact: the same, with nothing at nodes that have contact pressures (what they had goes to the other nodes of their "
           "elements), so that no mass has to be stopped when they touch. "
           "Has a meaning in dynamics and with \"rayleigh mass\"");
  describe(f, o.rayleigh);
  f.rule("D19", {"rayleigh stiffness", "formulation"}, o.rayleigh.stiffness == 0 || o.formulation != FormulationKind::mixed,
         "needs a \"formulation\" other than \"mixed\", whose stiffness at rest is not one of positions alone");
}

template <class Fields>
void describe(Fields& f, TableOptions& o) {
  f.required("arguments", o.arguments, anything, "", "where the function is given");
  f.required("values", o.values, anything, "", "its values there; straight lines between them, constant outside");
  f.rule("D17", {"arguments"}, o.arguments.size() >= 2, "must have at least 2 entries");
  f.rule("D17", {"arguments"}, is_strictly_ascending(o.arguments), "must be strictly ascending");
  f.rule("D17", {"values", "arguments"}, o.values.size() == o.arguments.size(), "must have as many entries as \"arguments\"");
}

template <class Fields>
void describe(Fields& f, ContactOptions& o) {
  f.required(
      "secondary", o.secondary, anything, "",
      "mesh name / side set that carries the multipliers (the thesis' slave or non-mortar side); best the finer one, and one "
      "that the other side covers: at partly covered nodes the contact law yields, which costs force");
  f.required("primary", o.primary, anything, "", "mesh name / side set on the other side (master, mortar)");
  f.choice("method", o.method, Choices<ContactMethod>{{"mortar", ContactMethod::mortar}}, Presence::optional,
           "mortar: segment-to-segment, contact conditions in the mean over the overlap: gap >= 0, pressure >= 0, one of them 0; "
           "where "
           "a node is partly covered a closed gap yields by 1e-6 (h/E of both sides) (whole area / covered area - 1)^2 pressure; "
           "pairs of facets count less and less from 70 to 80 degrees of turning away from each other, and from 0.8 to 1 facet "
           "of distance");
  f.choice("contact force", o.force,
           Choices<ContactForce>{{"thesis", ContactForce::thesis}, {"interpolated normal", ContactForce::interpolated_normal}},
           Presence::optional,
           "thesis: the variation of the weighted gap with the mortar weights held and the normal varied (eq. 4.123); "
           "conserves both momenta. interpolated normal: pressures act along the nodal normals, gaps count along the normal "
           "interpolated between them, as other codes have it; conserves linear momentum");
  f.choice("mortar integrals", o.has_frozen_integrals, Choices<bool>{{"current", false}, {"start of step", true}},
           Presence::optional,
           "where segments, D and M are found. current: where the surfaces are, with the complete tangent. start of step: where "
           "they were, frozen over the step (Remark 11); cheaper, and first order in the sliding of a step");
  f.optional("quadrature degree", o.quadrature_degree,
             within(3, 8).because("products of two bilinear shape functions have degree 4; 3 is the 4-point rule of the thesis, "
                                  "not exact even on squares"),
             "-", "polynomial degree integrated exactly on each triangle of a segment");
  f.choice("enforcement", o.enforcement,
           Choices<Enforcement>{{"multipliers", Enforcement::multipliers},
                                {"penalty", Enforcement::penalty},
                                {"augmented lagrangian", Enforcement::augmented_lagrangian}},
           Presence::optional,
           "multipliers: no penetration. penalty: pressure = \"normal penalty\" x penetration. augmented lagrangian: the same, "
           "begun again from the pressures found until no node is deeper than \"largest penetration\"");
  f.optional("normal penalty", o.normal_penalty, positive, "force/length^3", "pressure per penetration");
  f.optional("largest penetration", o.largest_penetration, positive, "length",
             "of closed nodes in an accepted step, in the mean over the overlap; default: 1e-6 of the facet size");
  f.only_with({"normal penalty"}, "enforcement", o.enforcement != Enforcement::multipliers,
              "\"enforcement\" = \"penalty\" or \"augmented lagrangian\"");
  f.rule("D07", {"enforcement"}, o.enforcement == Enforcement::multipliers || o.normal_penalty.has_value(),
         "needs \"normal penalty\"");
  f.only_with({"largest penetration"}, "enforcement", o.enforcement == Enforcement::augmented_lagrangian,
              "\"enforcement\" = \"augmented lagrangian\"");
  f.choice("complementarity", o.function,
           Choices<Complementarity>{{"minimum", Complementarity::minimum},
                                    {"fischer burmeister", Complementarity::fischer_burmeister}},
           Presence::optional,
           "which equation joins gap and pressure. minimum: the active set, settled within each iteration. fischer burmeister: "
           "a smooth function with the same roots, for comparison");
  describe(f, o.closing);
  describe(f, o.friction);
  f.rule("D19", {"complementarity", o.friction.law()}, o.function == Complementarity::minimum || !o.friction.acts(),
         "cannot be \"fischer burmeister\" with friction, which asks for the active set");
  describe(f, o.activity);
}

template <class Fields>
void describe(Fields& f, TieOptions& o) {
  f.required("secondary", o.secondary, anything, "",
             "mesh name / side set that carries the tractions; best the finer one. At its nodes that a support holds beside free "
             "ones of the same surface the support alone acts");
  f.required("primary", o.primary, anything, "", "mesh name / side set on the other side");
  f.choice(
      "form", o.form,
      Choices<TieForm>{
          {"automatic", TieForm::automatic}, {"frame invariant", TieForm::frame_invariant}, {"plain", TieForm::plain}},
      Presence::optional,
      "what stays as it was in the reference configuration, in the mean over the overlap. plain: the gap in space (eq. 4.97); "
      "linear, does no work, and keeps both momenta where the surfaces fit; where they do not it holds the gap against "
      "turning. frame invariant: the gap seen from each secondary facet, which may turn (eq. 4.98); keeps both momenta. "
      "automatic: plain where the surfaces fit, else frame invariant");
  f.optional("quadrature degree", o.quadrature_degree,
             within(3, 8).because("products of two bilinear shape functions have degree 4; 3 is the thesis' 4-point rule"), "-",
             "polynomial degree integrated exactly on each triangle of a segment");
  f.optional("largest gap", o.largest_gap, positive, "length",
             "surfaces further apart, in the mean over a pair of facets, are not tied; default: a quarter of the greater edge of "
             "both sides' facets");
  describe(f, o.activity);
}

template <class Fields>
void describe(Fields& f, TimeOptions& o) {
  f.kind("scheme", o.scheme, Presence::optional,
         "how a step follows from the one before; dynamics needs the density of each body");
  f.required("end", o.end, positive, "time", "time at which the run ends; it begins at 0");
  f.required("step", o.step, positive, "time", "first step");
  f.optional("largest step", o.largest_step, positive, "time", "steps grow up to this; default: `step`");
  f.optional("smallest step", o.smallest_step, positive, "time",
             "a run that needs shorter steps gives up; default: `step` / 1024");
  f.optional("growth", o.growth, at_least(1), "-", "factor on the step after an easy one");
  f.optional("easy iterations", o.easy_iterations, at_least(1), "-", "a step with at most so many Newton iterations is easy");
  const bool has_inertia = scheme_of(o.scheme).has_inertia();
  f.choice(
      "first guess", o.first_guess,
      Choices<FirstGuess>{{"old state", FirstGuess::old_state}, {"motion", FirstGuess::motion}, {"linear", FirstGuess::linear}},
      Presence::optional,
      "where Newton's method starts in a step: where the last one ended, moved on by velocity and acceleration, or (linear) "
      "where the equations linearised at the old state end, which saves an iteration for a solve");
  f.optional(
      "error tolerance", o.error_tolerance, positive, "length",
      "steps are sized so that dt^2 |a_n+1 - a_n| / 12, about the error in position that a second-order scheme makes in one "
      "step of a smooth motion, stays below this at every node; a step with more is repeated");
  f.optional("touch step", o.touch_step, positive, "time",
             "a longer step in which nodes touch where none did is repeated with this length");
  f.only_with({"first guess", "error tolerance"}, "scheme", has_inertia, "a \"scheme\" that has inertia");
  f.optional("stops", o.stops, positive, "time", "times that a step must hit; the end is hit in any case");
  f.rule("D08", {"step", "end"}, o.step <= o.end, "must be at most \"end\"", " = " + shortest(o.end));
  f.rule("D08", {"largest step", "step"}, o.largest_step.value_or(o.step) >= o.step, "must be at least \"step\"",
         " = " + shortest(o.step));
  f.rule("D08", {"smallest step", "step"}, o.smallest_step.value_or(o.step) <= o.step, "must be at most \"step\"",
         " = " + shortest(o.step));
  f.rule("D17", {"stops"}, is_strictly_ascending(o.stops), "must be strictly ascending");
  f.rule("D08", {"stops", "end"}, std::all_of(o.stops.begin(), o.stops.end(), [&](double stop) { return stop <= o.end; }),
         "must be at most \"end\"", " = " + shortest(o.end));
}

template <class Fields>
void describe(Fields& f, StageOptions& o) {
  describe(f, static_cast<TimeOptions&>(o));
  f.optional(
      "without", o.without, anything, "",
      "entries of `supports`, `springs`, `loads`, `contact`, `ties`, `obstacles` and `rods` that do not act in this stage, each "
      "written list/name, as loads/gravity; all others do");
}

template <class Fields>
void describe(Fields& f, SolverOptions& o) {
  const Choices<LinearSolverKind> kinds{
      {"auto", LinearSolverKind::automatic}, {"direct", LinearSolverKind::direct}, {"iterative", LinearSolverKind::iterative}};
  const Bound relative = within(1e-15, 0.1).because("a relative residual below 1e-15 is round-off");
  f.choice("linear", o.linear, kinds, Presence::optional,
           "direct: MUMPS; iterative: GMRES with incomplete factors; auto: direct up to 150000 unknowns");
  f.optional("tolerance", o.tolerance, relative, "-", "of the residual, relative to the greatest force at work");
  f.optional("newton iterations", o.largest_iterations, at_least(1), "-", "most Newton iterations before a step is cut");
  f.optional("further iterations", o.further_iterations, at_least(0), "-",
             "Newton iterations after convergence; comparisons between numbers of ranks use 1");
  f.optional("linear tolerance", o.linear_tolerance, relative, "-", "GMRES: relative residual");
  f.optional("linear iterations", o.linear_iterations, at_least(1), "-", "GMRES: most iterations");
  f.optional("fill level", o.fill_level, within(0, 10), "-", "GMRES: level of fill of the incomplete factors of the bodies");
  f.only_with({"linear tolerance", "linear iterations", "fill level"}, "linear", o.linear != LinearSolverKind::direct,
              "\"linear\" = \"iterative\" or \"auto\"");
}

template <class Fields>
void describe(Fields& f, OutputOptions& o) {
  f.words(
      "fields", o.fields, all_field_names(),
      "values at the nodes, written to results.e as nodal variables. What elements have at their quadrature points is averaged "
      "over the points of all elements at a node, weighted with volume and the node's shape function (its positive part). "
      "Tensors in the axes x, y, z. " +
          help_on_fields());
  f.words(
      "element fields", o.element_fields, point_field_names(),
      "values at the quadrature points, written to results.e as element variables <name>_<component>_<point>, points numbered "
      "from 1 as in the element's rule; what they are: see \"fields\"");
  f.optional("every", o.every, at_least(1), "-", "a frame is written every so many steps, and at every stop");
  f.optional("times", o.times, at_least(0), "time",
             "frames are written at the first steps that end at or after these times too; steps do not change for them");
}

template <class Fields>
void describe(Fields& f, CheckpointOptions& o) {
  f.optional("every", o.every, at_least(0), "-",
             "checkpoints are written after every so many steps, 0: not in between; always where the run begins and stops");
  f.optional("seconds", o.seconds, at_least(0), "s", "and no sooner than so many seconds of the clock after the last one");
}

template <class Fields>
void describe(Fields& f, ProbeOptions& o) {
  Choices<std::string> quantities;
  for (const std::string& variable : all_nodal_variables()) quantities.emplace_back(variable, variable);
  f.choice("quantity", o.quantity, quantities, Presence::required,
           "a component of one of the \"fields\" of `output`; its column is <quantity>.<probe>");
  f.required("mesh", o.mesh, anything, "", "name of an entry of `meshes`");
  f.optional("node", o.node, at_least(1), "-", "the node's own number in the mesh");
  f.optional("nearest", o.nearest, anything, "length", "the node nearest to this reference position, as placed");
  f.exactly_one_of({"node", "nearest"});
}

template <class Fields>
void describe(Fields& f, ExpectedOptions& o) {
  f.required("quantity", o.quantity, anything, "",
             "column of history.csv; contact_force_x|y|z.<pair> and reaction_x|y|z.<support> are compared by magnitude");
  f.optional("at time", o.at_time, positive, "time", "compare the value at this time, which must be a stop or the end");
  f.optional("mean from", o.mean_from, at_least(0), "time", "compare the time-weighted mean from then to the end");
  f.required("value", o.value, anything, "of the quantity", "what the run must give");
  f.required("tolerance", o.tolerance, positive, "of the quantity", "greatest difference allowed, absolute");
  f.optional("source", o.source, anything, "", "where the value comes from");
  f.exactly_one_of({"at time", "mean from"});
}

template <class Fields>
void describe(Fields& f, UnitOptions& o) {
  f.optional("length", o.length, anything, "", "label of the unit of length, e.g. mm");
  f.optional("force", o.force, anything, "", "label of the unit of force, e.g. N");
  f.optional("time", o.time, anything, "", "label of the unit of time, e.g. s");
}

template <class Fields>
void describe(Fields& f, DeckOptions& o) {
  f.optional("title", o.title, anything, "", "one line for the log and the results");
  f.list("units", o.units, Presence::optional, "labels only: numbers are never converted, decks use any consistent units");
  f.named("meshes", o.meshes, Presence::required, "meshes from Exodus files or recipes, and where they are placed");
  f.named("materials", o.materials, Presence::filled_if_present, "materials; each must be used by a body");
  f.named("bodies", o.bodies, Presence::filled_if_present, "a body: blocks of a mesh, and their material");
  f.named("masses", o.masses, Presence::filled_if_present, "point masses: the same mass on each node of a set");
  f.named("strings", o.strings, Presence::filled_if_present, "strings without bending stiffness, of bars");
  f.rule("D07", {"bodies", "masses", "strings"}, !o.bodies.empty() || !o.masses.empty() || !o.strings.empty(),
         "is missing: something must move - bodies, masses or strings");
  f.rule("D07", {"materials"}, o.bodies.empty() || !o.materials.empty(), "is missing: bodies are made of materials");
  f.named("tables", o.tables, Presence::optional, "piecewise linear functions, called in formulas by their names");
  f.named("supports", o.supports, Presence::optional, "prescribed motions");
  f.named("springs", o.springs, Presence::optional, "springs to the ground, and between points");
  f.named("loads", o.loads, Presence::optional, "forces on surfaces, bodies and nodes");
  f.named("contact", o.contact, Presence::optional, "pairs of surfaces that may touch; without friction unless they say so");
  f.named("ties", o.ties, Presence::optional,
          "pairs of surfaces that stay together as they lie at first, whatever their meshes (mesh tying)");
  f.named("obstacles", o.obstacles, Presence::optional,
          "rigid things that nodes may not enter; a node's pressure is its force over its share of the sides of the set, "
          "or, with a node set, over the square of the smallest element size");
  f.named("rods", o.rods, Presence::optional, "rigid rods without mass from a point in space to a node");
  f.named("initial conditions", o.initial_conditions, Presence::optional,
          "how bodies, masses and strings move at the start, each named as its entry there; without it they are at rest");
  f.list("time", o.time, Presence::optional, "how the run goes from time 0 to its end");
  f.named("stages", o.stages, Presence::filled_if_present,
          "in place of `time`: parts of the run, one after the other, each with a scheme and steps of its own. Its \"end\" is a "
          "time of the run, the next stage begins there with the state that it left. Velocities of `initial conditions` begin "
          "with a stage that has inertia where none had before; a stage without inertia stops all motion");
  f.exactly_one_of({"time", "stages"});
  f.list("solver", o.solver, Presence::optional, "Newton's method and the linear solver");
  f.list("output", o.output, Presence::optional, "what is written to results.e");
  f.list("checkpoints", o.checkpoints, Presence::optional, "how often the run is kept, for `mortise restart` to go on from");
  f.named("probes", o.probes, Presence::optional, "nodal quantities followed in history.csv");
  f.named("expected", o.expected, Presence::filled_if_present, "values the run must meet; one missed gives exit code 7");
}

}  // namespace mortise
