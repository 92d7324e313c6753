// A solid of every material, and deformations to try it with.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "physics/materials/materials.hpp"
#include "support/random.hpp"

namespace mortise::test {

inline const Moduli moduli{2250, 0.3};  // those of the references

/// A solid of a material, of about the stiffness of `moduli`.
template <class M>
M sample() {
  return M::from(moduli);
}
inline const OgdenDistortional ogden_terms{{{630, 1.3}, {12, 5}, {-100, -2}}};
template <>
inline MooneyRivlin sample() {
  return {300, 120, 500};
}
template <>
inline Ogden sample() {
  return {ogden_terms, 1875, 9};
}
template <>
inline MooneyRivlinIsochoric sample() {
  return {{300, 120}, 1875};
}
template <>
inline NeoHookeanIncompressible sample() {
  return {{moduli.shear_modulus()}};
}
template <>
inline MooneyRivlinIncompressible sample() {
  return {{300, 120}};
}
template <>
inline OgdenIncompressible sample() {
  return {ogden_terms};
}

template <class Variant>
struct TypesOf;
template <class... M>
struct TypesOf<std::variant<M...>> {
  using Type = ::testing::Types<M...>;
};
/// All that `Material` holds.
using Materials = TypesOf<Material>::Type;

inline Tensor3<double> tensor(const std::vector<double>& entries) {
  Tensor3<double> F;
  for (int k = 0; k < 9; ++k) F(k / 3, k % 3) = entries[k];
  return F;
}

inline std::vector<double> entries(const Tensor3<double>& F) { return {&F.a[0][0], &F.a[0][0] + 9}; }

inline double largest(const std::vector<double>& x) {
  double size = 0;
  for (double entry : x) size = std::max(size, std::abs(entry));
  return size;
}

/// A[3 i + J][3 k + L] by hand, row by row.
template <class M>
std::vector<double> moduli_by_hand(const M& material, const Tensor3<double>& F) {
  Tensor3<double> P;
  double A[9][9];
  material.moduli(F, P, A);
  return {&A[0][0], &A[0][0] + 81};
}

/// Deformation gradients with 0.3 < J < 3: a random stretch, turned.
inline std::vector<Tensor3<double>> some_deformations() {
  Random random(2);
  std::vector<Tensor3<double>> all;
  while (all.size() < 20) {
    Tensor3<double> F = identity<double>();
    for (int k = 0; k < 9; ++k) F(k / 3, k % 3) += random.in(-0.4, 0.4);
    if (det(F) > 0.3 && det(F) < 3) all.push_back(random.rotation() * F);
  }
  return all;
}

/// Deformation gradients whose principal stretches lie nearer and nearer to each other, at last together.
inline std::vector<Tensor3<double>> nearly_equal_stretches() {
  Random random(7);
  std::vector<Tensor3<double>> all;
  for (double gap = 0.1; gap > 1e-17; gap *= 0.1)
    for (double other : {1.0, 1 + 2 * gap, 0.7})
      all.push_back(random.rotation() * Tensor3<double>{{{1.2, 0, 0}, {0, 1.2 * (1 + gap), 0}, {0, 0, 1.2 * other}}} *
                    random.rotation());
  return all;
}

}  // namespace mortise::test
