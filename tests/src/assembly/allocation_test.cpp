// Element loops ask the system for no memory: every allocation of this program is counted.
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "support/elements.hpp"
#include "support/materials.hpp"

namespace {

long n_allocations = 0;

void* counted(std::size_t size) {
  ++n_allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) { return counted(size); }
void* operator new[](std::size_t size) { return counted(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace mortise::test {
namespace {

template <class F>
class ElementLoops : public testing::Test {
 public:
  /// Calls `take` with a sample of every material that the formulation takes. The pointer only tells which there are.
  template <class... M, class Take>
  static void for_each_material(const std::variant<M...>*, const Take& take) {
    const auto offer = [&](const auto& material) {
      using One = std::decay_t<decltype(material)>;
      if constexpr (F::n_pressures > 0 ? is_split<One> : !is_incompressible<One>()) take(Material(material));
    };
    (offer(sample<M>()), ...);
  }
};
TYPED_TEST_SUITE(ElementLoops, Formulations);

TYPED_TEST(ElementLoops, AllocateNothing) {
  this->for_each_material(static_cast<const Material*>(nullptr), [](const Material& material) {
    for (const ModuliKind moduli : {ModuliKind::automatic, ModuliKind::analytic}) {
      Random random(4);
      const OneElement<TypeParam> one{
          TypeParam::n_pressures > 0 ? MaterialLaw::distortional(material, moduli) : MaterialLaw::whole(material, moduli),
          distorted<typename TypeParam::Element>(random, 0.1)};
      const auto x = one.deformed(random, 1);
      std::vector<double> r(x.size()), K(x.size() * x.size());
      const MaterialLaw law = one.block.law();
      for (const TangentKind kind : {TangentKind::quadrature_point, TangentKind::whole_element, TangentKind::complex_step,
                                     TangentKind::central_differences}) {
        const long before = n_allocations;
        const bool good = one.block.add_force(x.data(), r.data()) &&
                          one.block.tangent(kind, best_step(kind), law, 0, x.data(), r.data(), K.data());
        const double energy = one.block.strain_energy(x.data());
        const long allocated = n_allocations - before;
        EXPECT_TRUE(good);
        EXPECT_NE(energy, 0);
        EXPECT_EQ(allocated, 0) << "material number " << material.index();
      }
    }
  });
}

TEST(Allocations, AreCounted) {
  const long before = n_allocations;
  const std::vector<double> some(3);
  EXPECT_EQ(n_allocations, before + 1) << some.size();
}

}  // namespace
}  // namespace mortise::test
