// The fields of results by name: one table, from which decks, probes, results and the reference take their words.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace mortise {

enum class Field {
  displacement,
  von_mises,
  cauchy_stress,
  contact_pressure,
  gap,
  status,
  reaction,
  position,
  velocity,
  acceleration,
  kirchhoff_stress,
  first_piola_stress,
  second_piola_stress,
  principal_stresses,
  principal_directions,
  green_lagrange_strain,
  almansi_strain,
  volume_ratio,
  energy_density,
  tangential_traction,
  tie_traction
};

/// Where a field has values of its own.
enum class FieldPlace {
  node,
  secondary_node,  ///< of contact or ties; 0 at all others
  point            ///< of the elements' quadrature; at nodes there are means
};

/// What a scene must have for a field to be there.
enum class FieldNeed { nothing, inertia, supports, contact, ties };

/// Components of a field, and with them the ends of its variables' names (`suffixes`).
enum class FieldShape { scalar, vector, symmetric_tensor, tensor, three_values, three_vectors };

struct FieldEntry {
  Field field;
  const char* name;      ///< in decks
  const char* variable;  ///< in files, without the ends of components
  FieldShape shape;
  FieldPlace place;
  FieldNeed need;
  const char* unit;  ///< in words, as in descriptions (fields.hpp)
  const char* help;  ///< what it is; empty where the name says so
};

inline constexpr std::array<FieldEntry, 21> field_table{{
    {Field::displacement, "displacement", "displacement", FieldShape::vector, FieldPlace::node, FieldNeed::nothing, "length", ""},
    {Field::von_mises, "von mises", "von_mises", FieldShape::scalar, FieldPlace::point, FieldNeed::nothing, "force/length^2",
     "of the Cauchy stress"},
    {Field::cauchy_stress, "cauchy stress", "stress", FieldShape::symmetric_tensor, FieldPlace::point, FieldNeed::nothing,
     "force/length^2", "sigma = P F^T / J"},
    {Field::contact_pressure, "contact pressure", "contact_pressure", FieldShape::scalar, FieldPlace::secondary_node,
     FieldNeed::contact, "force/length^2", "positive in compression"},
    {Field::gap, "gap", "gap", FieldShape::scalar, FieldPlace::secondary_node, FieldNeed::contact, "length",
     "mean over the node's part of the overlap, negative: penetration"},
    {Field::status, "status", "status", FieldShape::scalar, FieldPlace::secondary_node, FieldNeed::contact, "-",
     "2 closed and sticking, 1 closed, 0 open"},
    {Field::tangential_traction, "tangential traction", "tangential_traction", FieldShape::vector, FieldPlace::secondary_node,
     FieldNeed::contact, "force/length^2", "of friction on the secondary surface"},
    {Field::tie_traction, "tie traction", "tie_traction", FieldShape::vector, FieldPlace::secondary_node, FieldNeed::ties,
     "force/length^2", "per reference area, on the secondary surface"},
    {Field::reaction, "reaction", "reaction", FieldShape::vector, FieldPlace::node, FieldNeed::supports, "force",
     "of supports on the body, in the components that they hold"},
    {Field::position, "position", "position", FieldShape::vector, FieldPlace::node, FieldNeed::nothing, "length", "current"},
    {Field::velocity, "velocity", "velocity", FieldShape::vector, FieldPlace::node, FieldNeed::inertia, "length/time", ""},
    {Field::acceleration, "acceleration", "acceleration", FieldShape::vector, FieldPlace::node, FieldNeed::inertia,
     "length/time^2", ""},
    {Field::kirchhoff_stress, "kirchhoff stress", "kirchhoff_stress", FieldShape::symmetric_tensor, FieldPlace::point,
     FieldNeed::nothing, "force/length^2", "P F^T"},
    {Field::first_piola_stress, "first piola stress", "first_piola_stress", FieldShape::tensor, FieldPlace::point,
     FieldNeed::nothing, "force/length^2", "P = dW/dF, rows current, columns reference"},
    {Field::second_piola_stress, "second piola stress", "second_piola_stress", FieldShape::symmetric_tensor, FieldPlace::point,
     FieldNeed::nothing, "force/length^2", "F^-1 P"},
    {Field::principal_stresses, "principal stresses", "principal_stress", FieldShape::three_values, FieldPlace::point,
     FieldNeed::nothing, "force/length^2", "of the Cauchy stress, the greatest first; at nodes of its mean"},
    {Field::principal_directions, "principal directions", "principal_direction", FieldShape::three_vectors, FieldPlace::point,
     FieldNeed::nothing, "-",
     "unit vectors of the principal stresses in their order, the first component that is not 0 positive; at nodes of the mean "
     "Cauchy stress"},
    {Field::green_lagrange_strain, "green-lagrange strain", "green_lagrange_strain", FieldShape::symmetric_tensor,
     FieldPlace::point, FieldNeed::nothing, "-", "(F^T F - I) / 2"},
    {Field::almansi_strain, "almansi strain", "almansi_strain", FieldShape::symmetric_tensor, FieldPlace::point,
     FieldNeed::nothing, "-", "(I - F^-T F^-1) / 2"},
    {Field::volume_ratio, "volume ratio", "volume_ratio", FieldShape::scalar, FieldPlace::point, FieldNeed::nothing, "-",
     "J = det F"},
    {Field::energy_density, "energy density", "energy_density", FieldShape::scalar, FieldPlace::point, FieldNeed::nothing,
     "force/length^2", "strain energy per reference volume"},
}};

/// The entry of a field.
const FieldEntry& entry_of(Field field);

/// The field that a deck means. @throws std::logic_error for a name that the deck reader should not have let through
Field field_named(const std::string& name);

/// Ends of the names of a field's variables, one per component; ParaView joins _x _y _z and _xx _yy _zz _xy _yz _zx.
std::vector<std::string> suffixes(FieldShape shape);

/// The nodal variables of a field of the deck, e.g. "displacement" -> displacement_x, _y, _z.
/// @throws std::logic_error as `field_named`
std::vector<std::string> variables_of_field(const std::string& name);

/// A component of a field, as a nodal variable.
struct FieldComponent {
  Field field;
  std::size_t component;
};

/// What a nodal variable is. @throws std::logic_error for a name that the deck reader should not have let through
FieldComponent component_named(const std::string& variable);

/// Names in decks: of all fields, or of those at quadrature points.
std::vector<std::string> all_field_names();
std::vector<std::string> point_field_names();

/// Names of all nodal variables.
std::vector<std::string> all_nodal_variables();

/// All fields with units and meaning, for the reference.
std::string help_on_fields();

}  // namespace mortise
