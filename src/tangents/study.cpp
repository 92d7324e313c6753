#include "tangents/study.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>

#include "assembly/element_tangent.hpp"

namespace mortise {
namespace {

/// f in the shape of a formulation with one unknown, so that the element's code differentiates it.
struct ModelProblem {
  struct Element {
    static constexpr int n_nodes = 0;
  };
  static constexpr int n_pressures = 1, n_local = 0;

  template <class T>
  static bool add_residual(const ModelProblem&, const ModelProblem&, const T* y, T* r) {
    using std::sin;
    r[0] += sin(y[0]) + y[0] * y[0] * y[0] * y[0];
    return true;
  }
  static bool add_tangent(const ModelProblem&, const ModelProblem&, const double* y, double* r, double* K) {
    K[0] += std::cos(y[0]) + 4 * y[0] * y[0] * y[0];
    return add_residual(ModelProblem{}, ModelProblem{}, y, r);
  }
};

double derivative(TangentKind kind, double step) {
  const double x = 2, scale = 1;
  double r = 0, K = 0;
  element_tangent<ModelProblem>(kind, step, ModelProblem{}, ModelProblem{}, &x, &scale, &r, &K);
  return K;
}

constexpr std::array kinds{TangentKind::forward_differences, TangentKind::backward_differences, TangentKind::central_differences,
                           TangentKind::complex_step, TangentKind::whole_element};

}  // namespace

std::vector<StudyPoint> difference_study() {
  const double exact = derivative(TangentKind::analytic, 0);
  std::vector<StudyPoint> study;
  const auto add = [&](TangentKind kind, double exponent) {
    const double h = std::pow(10, exponent);
    study.push_back({kind, h, std::abs(derivative(kind, h) - exact) / std::abs(exact)});
  };
  for (int quarter = 0; quarter >= -64; --quarter)
    for (TangentKind kind : kinds) add(kind, quarter / 4.0);
  for (int exponent = -20; exponent >= -300; exponent -= 10) add(TangentKind::complex_step, exponent);
  return study;
}

std::string csv(const std::vector<StudyPoint>& study) {
  std::map<double, std::array<std::string, kinds.size()>, std::greater<>> rows;
  for (const StudyPoint& point : study)
    for (std::size_t k = 0; k < kinds.size(); ++k)
      if (kinds[k] == point.kind) rows[point.step][k] = fmt::format("{:.6e}", point.error);
  std::string text = "step,forward_differences,backward_differences,central_differences,complex_step,automatic\n";
  for (const auto& [step, cells] : rows) text += fmt::format("{:.6e},{}\n", step, fmt::join(cells, ","));
  return text;
}

}  // namespace mortise
