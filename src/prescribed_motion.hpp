// Where supports put the components that they prescribe.
#pragma once

#include <string>

#include "scene.hpp"

namespace mortise {

/// Displacement from the reference position [m] that a support gives to `axis` of a node at time `t`. A velocity support gives
/// what its node has moved by since time `from` (0 if that is `t`): the caller knows where it was.
/// @param fault gets the message about a formula without a finite value, if it is empty
double prescribed_displacement(const Support& support, int axis, const Point& X, double from, double t, std::string& fault);

/// Whether what the support gives is an increment over the step.
bool is_increment(const Support& support);

/// The message about two supports that act at time `t` and put one component at different places, or an empty text.
/// Values that are not finite are no contradiction: they have a message of their own.
/// @param u_first, u_second the displacements that they give
std::string contradiction(const Scene& scene, const PrescribedDof& first, const PrescribedDof& second, double u_first,
                          double u_second, double t);

}  // namespace mortise
