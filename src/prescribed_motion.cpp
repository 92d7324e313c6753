#include "prescribed_motion.hpp"

#include <fmt/format.h>

#include <cmath>

#include "mesh/angles.hpp"
#include "physics/elements/quadrature.hpp"
#include "physics/rotation.hpp"

namespace mortise {
namespace {

double displacement(const motions::Displacement& motion, int axis, const Point& X, double, double t, std::string& fault) {
  return evaluate(*motion.displacement[axis], t, X, fault);
}

double displacement(const motions::Velocity& motion, int axis, const Point& X, double from, double t, std::string& fault) {
  const double half = 0.5 * (t - from);
  double moved = 0;
  if (half > 0)
    for (const auto& [at, weight] : gauss<3>())
      moved += weight * half * evaluate(*motion.velocity[axis], from + half * (1 + at), X, fault);
  return moved;
}

double displacement(const motions::Rotation& motion, int axis, const Point& X, double, double t, std::string& fault) {
  const auto [sine, cosine] = sine_cosine(evaluate(motion.degrees, t, X, fault));
  const Vec3<double> arm = Vec3<double>{X[0], X[1], X[2]} - motion.centre;
  const double moved = (turned_about(motion.axis, sine, cosine, arm) - arm)[axis];
  return motion.displacement[axis] ? moved + evaluate(*motion.displacement[axis], t, X, fault) : moved;
}

double displacement(const motions::Symmetry&, int, const Point&, double, double, std::string&) { return 0; }

}  // namespace

double prescribed_displacement(const Support& support, int axis, const Point& X, double from, double t, std::string& fault) {
  return std::visit([&](const auto& motion) { return displacement(motion, axis, X, from, t, fault); }, support.motion);
}

bool is_increment(const Support& support) { return std::holds_alternative<motions::Velocity>(support.motion); }

std::string contradiction(const Scene& scene, const PrescribedDof& first, const PrescribedDof& second, double u_first,
                          double u_second, double t) {
  if (!std::isfinite(u_first) || !std::isfinite(u_second)) return "";
  if (std::abs(u_first - u_second) <= 1e-12 * (1 + std::abs(u_first))) return "";
  return fmt::format("{}{}, component {}, is moved by {} here and by {} in \"{}\" at t = {} - one value is needed",
                     scene.supports[second.support].where_contradicting[second.axis], describe_node(scene.mesh, second.node),
                     "xyz"[second.axis], u_second, u_first, scene.supports[first.support].name, t);
}

}  // namespace mortise
