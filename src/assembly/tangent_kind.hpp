// The ways to differentiate an element.
#pragma once

namespace mortise {

enum class TangentKind {
  quadrature_point,  ///< AD of the stress at each quadrature point
  whole_element,     ///< AD of the element's residual
  analytic,          ///< moduli derived by hand, per material
  complex_step,
  central_differences,
  forward_differences,
  backward_differences
};

}  // namespace mortise
