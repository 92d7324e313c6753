// A material as element loops call it: chosen once per block of elements, so that loops are compiled once for all materials.
#pragma once

#include <type_traits>

#include "physics/materials/materials.hpp"

namespace mortise {

/// How dP/dF is found at a quadrature point.
enum class ModuliKind { automatic, analytic };

/// The law that formulations ask for (physics/formulations/formulation.hpp): one material, or its distortional part alone.
class MaterialLaw {
 public:
  /// @param material is not copied: it must outlive the law
  static MaterialLaw whole(const Material& material, ModuliKind kind);

  /// W_iso of a material that is split into distortion and volume, for the mixed formulation.
  /// @throws std::logic_error if the material is not split
  static MaterialLaw distortional(const Material& material, ModuliKind kind);

  /// [J/m^3]
  double strain_energy(const Tensor3<double>& F) const { return strain_energy_(self_, F); }

  /// P = dW/dF [Pa]; needs det F > 0. Scalars other than double are for cross-checks: they pay a visit per call.
  template <class T>
  Tensor3<T> first_piola(const Tensor3<T>& F) const {
    if constexpr (std::is_same_v<T, double>) {
      return first_piola_(self_, F);
    } else {
      return std::visit(
          [&](const auto& m) -> Tensor3<T> {
            if constexpr (is_split<std::decay_t<decltype(m)>>)
              if (is_distortional_) return m.distortional().first_piola(F);
            return m.first_piola(F);
          },
          *material_);
    }
  }

  /// P [Pa] and A[3 i + J][3 k + L] = dP_iJ/dF_kL [Pa].
  void moduli(const Tensor3<double>& F, Tensor3<double>& P, double A[9][9]) const { moduli_(self_, F, P, A); }

  /// 1/kappa [1/Pa] of the volumetric part, 0 if the volume cannot change; for distortional laws only.
  double volumetric_compliance() const { return volumetric_compliance_; }

 private:
  MaterialLaw() = default;
  template <class Part, class M>
  void call(const M& material, ModuliKind kind);

  const Material* material_ = nullptr;
  const void* self_ = nullptr;
  bool is_distortional_ = false;
  double volumetric_compliance_ = 0;
  double (*strain_energy_)(const void*, const Tensor3<double>&) = nullptr;
  Tensor3<double> (*first_piola_)(const void*, const Tensor3<double>&) = nullptr;
  void (*moduli_)(const void*, const Tensor3<double>&, Tensor3<double>&, double[9][9]) = nullptr;
};

}  // namespace mortise
