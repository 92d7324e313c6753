// The error of numerical derivatives over the step size: the study of thesis Fig. D.1.
#pragma once

#include <string>
#include <vector>

#include "assembly/tangent_kind.hpp"

namespace mortise {

/// Relative error |D - f'| / |f'| of f(x) = sin x + x^4 (thesis eq. D.6, D.7) at x = 2 with a step h.
struct StudyPoint {
  TangentKind kind;
  double step;
  double error;
};

/// Forward, backward, central differences and AD (which has no step) for h = 1 ... 1e-16, the complex step to 1e-300; four steps
/// per decade to 1e-16, then one per ten decades. Found by the code that differentiates elements.
std::vector<StudyPoint> difference_study();

/// Columns step, forward_differences, backward_differences, central_differences, complex_step, automatic; empty where a way was
/// not tried.
std::string csv(const std::vector<StudyPoint>& study);

}  // namespace mortise
