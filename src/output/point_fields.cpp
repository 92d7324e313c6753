#include "output/point_fields.hpp"

#include <stdexcept>

#include "physics/stress_and_strain.hpp"

namespace mortise {
namespace {

FieldValues scalar(double value) { return {value}; }

FieldValues symmetric(const Tensor3<double>& A) { return {A(0, 0), A(1, 1), A(2, 2), A(0, 1), A(1, 2), A(2, 0)}; }

Tensor3<double> tensor(const FieldValues& v) { return {{{v[0], v[3], v[5]}, {v[3], v[1], v[4]}, {v[5], v[4], v[2]}}}; }

FieldValues all_nine(const Tensor3<double>& A) {
  return {A(0, 0), A(0, 1), A(0, 2), A(1, 0), A(1, 1), A(1, 2), A(2, 0), A(2, 1), A(2, 2)};
}

FieldValues principal_values(const FieldValues& stress) {
  const auto values = principal_axes(tensor(stress)).values;
  return {values[0], values[1], values[2]};
}

FieldValues principal_directions(const FieldValues& stress) {
  const auto axes = principal_axes(tensor(stress)).directions;
  FieldValues values{};
  for (int k = 0; k < 9; ++k) values[k] = axes[k / 3][k % 3];
  return values;
}

}  // namespace

FieldValues values_at_point(Field field, const PointState& at) {
  switch (field) {
    case Field::von_mises:
      return scalar(von_mises(cauchy_stress(at.P, at.F)));
    case Field::cauchy_stress:
      return symmetric(cauchy_stress(at.P, at.F));
    case Field::kirchhoff_stress:
      return symmetric(kirchhoff_stress(at.P, at.F));
    case Field::first_piola_stress:
      return all_nine(at.P);
    case Field::second_piola_stress:
      return symmetric(second_piola_stress(at.P, at.F));
    case Field::principal_stresses:
    case Field::principal_directions:
      return values_of_mean(field, symmetric(cauchy_stress(at.P, at.F)));
    case Field::green_lagrange_strain:
      return symmetric(green_lagrange_strain(at.F));
    case Field::almansi_strain:
      return symmetric(almansi_strain(at.F));
    case Field::volume_ratio:
      return scalar(det(at.F));
    case Field::energy_density:
      return scalar(at.strain_energy);
    case Field::displacement:
    case Field::position:
    case Field::velocity:
    case Field::acceleration:
    case Field::reaction:
    case Field::contact_pressure:
    case Field::gap:
    case Field::status:
    case Field::tangential_traction:
    case Field::tie_traction:
      break;
  }
  throw std::logic_error("not a field of quadrature points");
}

Field averaged_field(Field field) {
  return field == Field::principal_stresses || field == Field::principal_directions ? Field::cauchy_stress : field;
}

FieldValues values_of_mean(Field field, const FieldValues& mean) {
  if (field == Field::principal_stresses) return principal_values(mean);
  if (field == Field::principal_directions) return principal_directions(mean);
  return mean;
}

}  // namespace mortise
