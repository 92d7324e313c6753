// The fields that elements have at their quadrature points, as functions of the state there.
#pragma once

#include <array>

#include "deck/field_table.hpp"
#include "physics/formulations/formulation.hpp"

namespace mortise {

/// The components of a field, as many as its shape has, in the order of its variables.
using FieldValues = std::array<double, 9>;

/// @throws std::logic_error if the field is not one of quadrature points
FieldValues values_at_point(Field field, const PointState& state);

/// The field whose mean over points is taken for the nodes: itself, but the Cauchy stress for what has no meaningful mean.
Field averaged_field(Field field);

/// The field at a node from the mean of its `averaged_field`.
FieldValues values_of_mean(Field field, const FieldValues& mean);

}  // namespace mortise
