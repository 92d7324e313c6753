#include "assembly/material_law.hpp"

#include <stdexcept>

#include "assembly/stress_and_moduli.hpp"

namespace mortise {
namespace {

struct Whole {
  template <class M>
  static const M& of(const M& material) {
    return material;
  }
};

struct Distortional {
  template <class M>
  static decltype(auto) of(const M& material) {
    return material.distortional();
  }
};

}  // namespace

template <class Part, class M>
void MaterialLaw::call(const M& material, ModuliKind kind) {
  self_ = &material;
  strain_energy_ = [](const void* self, const Tensor3<double>& F) {
    return Part::of(*static_cast<const M*>(self)).strain_energy(F);
  };
  first_piola_ = [](const void* self, const Tensor3<double>& F) { return Part::of(*static_cast<const M*>(self)).first_piola(F); };
  if (kind == ModuliKind::analytic) {
    moduli_ = [](const void* self, const Tensor3<double>& F, Tensor3<double>& P, double A[9][9]) {
      Part::of(*static_cast<const M*>(self)).moduli(F, P, A);
    };
  } else {
    moduli_ = [](const void* self, const Tensor3<double>& F, Tensor3<double>& P, double A[9][9]) {
      stress_and_moduli(Part::of(*static_cast<const M*>(self)), F, P, A);
    };
  }
}

MaterialLaw MaterialLaw::whole(const Material& material, ModuliKind kind) {
  MaterialLaw law;
  law.material_ = &material;
  std::visit([&](const auto& m) { law.call<Whole>(m, kind); }, material);
  return law;
}

MaterialLaw MaterialLaw::distortional(const Material& material, ModuliKind kind) {
  MaterialLaw law;
  law.material_ = &material;
  law.is_distortional_ = true;
  std::visit(
      [&](const auto& m) {
        if constexpr (is_split<std::decay_t<decltype(m)>>) {
          law.call<Distortional>(m, kind);
          law.volumetric_compliance_ = m.volumetric_compliance();
        } else {
          throw std::logic_error("a mixed element of a material that is not split");
        }
      },
      material);
  return law;
}

}  // namespace mortise
