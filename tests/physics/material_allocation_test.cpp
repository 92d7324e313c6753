// Moduli of materials and of steps are computed without asking for memory: this program counts what it asks for.
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "physics/algorithmic_stress.hpp"
#include "support/materials.hpp"

namespace {
long n_allocations = 0;
}

// Not inlined: the compiler would take the pair apart and warn of a mismatch.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++n_allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace mortise::test {
namespace {

template <class M>
class ModuliOfEveryMaterial : public ::testing::Test {};
TYPED_TEST_SUITE(ModuliOfEveryMaterial, Materials);

TYPED_TEST(ModuliOfEveryMaterial, NeedNoMemory) {
  const TypeParam material = sample<TypeParam>();
  const auto deformations = some_deformations();
  Tensor3<double> P;
  double A[9][9], sum = 0;
  const long before = n_allocations;
  for (const auto& F : deformations) {
    material.moduli(F, P, A);
    sum += A[0][0] + material.first_piola(F)(1, 1) + material.strain_energy(F);
    if constexpr (is_split<TypeParam>) sum += material.distortional().strain_energy(F);
    for (double share : {1e-9, 1e-3, 1e-1}) {
      const auto F_1 = scaled(1 + share, F);
      algorithmic_moduli(material, F, F_1, P, A);
      sum += A[0][0] + algorithmic_first_piola(material, F, F_1)(1, 1);
    }
  }
  EXPECT_EQ(n_allocations - before, 0);
  EXPECT_GT(sum, 0);
  const std::vector<double> some(9);
  EXPECT_NE(some.data(), nullptr);
  EXPECT_GT(n_allocations, before);  // it does count
}

}  // namespace
}  // namespace mortise::test
