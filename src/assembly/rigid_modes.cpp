#include "assembly/rigid_modes.hpp"

#include <fmt/format.h>

#include <Teuchos_LAPACK.hpp>
#include <algorithm>
#include <cmath>
#include <map>

#include "errors.hpp"

namespace mortise {
namespace {

constexpr const char* mode_names[6] = {"translation x", "translation y", "translation z",
                                       "rotation x",    "rotation y",    "rotation z"};

struct Frame {
  Point centre{};
  double length = 0;  // rotations are measured by the displacement at this distance
};

Frame frame_of(const Scene& scene, const Body& body) {
  const auto& X = scene.mesh.mesh.coordinates;
  Frame frame;
  for (int n : body.nodes)
    for (int i = 0; i < 3; ++i) frame.centre[i] += X[n][i] / body.nodes.size();
  for (int n : body.nodes)
    for (int i = 0; i < 3; ++i) frame.length = std::max(frame.length, std::abs(X[n][i] - frame.centre[i]));
  return frame;
}

// Displacement along d at X, for each of the six modes of a body.
std::array<double, 6> motion(const Frame& frame, const Point& X, const Vec3<double>& d) {
  const Vec3<double> r{(X[0] - frame.centre[0]) / frame.length, (X[1] - frame.centre[1]) / frame.length,
                       (X[2] - frame.centre[2]) / frame.length};
  const Vec3<double> moment = cross(r, d);
  return {d[0], d[1], d[2], moment[0], moment[1], moment[2]};
}

int body_of(const Scene& scene, int node) {
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    if (std::binary_search(scene.bodies[b].nodes.begin(), scene.bodies[b].nodes.end(), node)) return static_cast<int>(b);
  return -1;
}

// Brings a basis (rows) to reduced echelon form, so that single modes stand alone where they can.
void reduce(std::vector<std::vector<double>>& basis) {
  std::size_t row = 0;
  for (std::size_t c = 0; row < basis.size() && c < basis[0].size(); ++c) {
    std::size_t pivot = row;
    for (std::size_t r = row; r < basis.size(); ++r)
      if (std::abs(basis[r][c]) > std::abs(basis[pivot][c])) pivot = r;
    if (std::abs(basis[pivot][c]) < 1e-6) continue;
    std::swap(basis[row], basis[pivot]);
    const double scale = basis[row][c];
    for (double& v : basis[row]) v /= scale;
    for (std::size_t r = 0; r < basis.size(); ++r) {
      if (r == row) continue;
      const double factor = basis[r][c];
      for (std::size_t k = 0; k < basis[r].size(); ++k) basis[r][k] -= factor * basis[row][k];
    }
    ++row;
  }
}

}  // namespace

std::vector<FreeBody> free_bodies(const Scene& scene, const std::vector<char>& closed, const std::vector<Vec3<double>>& normals,
                                  double from) {
  if (scene.bodies.empty()) return {};
  const int n = 6 * static_cast<int>(scene.bodies.size());
  std::vector<Frame> frames;
  for (const auto& body : scene.bodies) frames.push_back(frame_of(scene, body));
  std::vector<double> normal_matrix(static_cast<std::size_t>(n) * n, 0.0), row(n);
  const auto add_row = [&] {
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) normal_matrix[static_cast<std::size_t>(i) * n + j] += row[i] * row[j];
    std::fill(row.begin(), row.end(), 0.0);
  };
  const auto add_motion = [&](int body, const Point& X, const Vec3<double>& d, double sign) {
    if (body < 0) return;
    const auto m = motion(frames[body], X, d);
    for (int k = 0; k < 6; ++k) row[6 * body + k] += sign * m[k];
  };
  const auto& X = scene.mesh.mesh.coordinates;
  const auto hold = [&](int node, int axis) {
    Vec3<double> d{};
    d[axis] = 1;
    add_motion(body_of(scene, node), X[node], d, 1);
    add_row();
  };
  for (const auto& p : scene.prescribed)
    if (scene.supports[p.support].activity.acts_after(from)) hold(p.node, p.axis);
  for (const auto& spring : scene.springs)
    for (int node : spring.nodes)
      for (int axis = 0; axis < 3; ++axis)
        if (spring.stiffness[axis] > 0 && spring.activity.acts_after(from)) hold(node, axis);
  for (const auto& spring : scene.node_springs) {
    if (!spring.activity.acts_after(from)) continue;
    const Point& far = spring.far_end(scene.mesh.mesh);
    Vec3<double> d{far[0] - X[spring.from][0], far[1] - X[spring.from][1], far[2] - X[spring.from][2]};
    d = (1 / norm(d)) * d;
    add_motion(body_of(scene, spring.from), X[spring.from], d, 1);
    if (spring.to) add_motion(body_of(scene, *spring.to), far, d, -1);
    add_row();
  }
  for (const auto& body : scene.bodies)
    for (int node : body.nodes)
      for (int axis = 0; axis < 3 && body.rayleigh.mass > 0; ++axis) hold(node, axis);
  // Bodies that share a node move together there.
  std::map<int, int> first_body;
  for (int b = 0; b < static_cast<int>(scene.bodies.size()); ++b)
    for (int node : scene.bodies[b].nodes) {
      const auto [at, is_new] = first_body.insert({node, b});
      for (int axis = 0; axis < 3 && !is_new; ++axis) {
        Vec3<double> d{};
        d[axis] = 1;
        add_motion(at->second, X[node], d, 1);
        add_motion(b, X[node], d, -1);
        add_row();
      }
    }
  for (const auto& pair : scene.pairs) {
    const int primary = body_of(scene, pair.primary.facets[0][0]);
    for (std::size_t k = 0; k < pair.secondary_nodes.size(); ++k) {
      if (!closed[pair.first_multiplier + k]) continue;
      const int node = pair.secondary_nodes[k];
      add_motion(body_of(scene, node), X[node], normals[pair.first_multiplier + k], 1);
      add_motion(primary, X[node], normals[pair.first_multiplier + k], -1);
      add_row();
    }
  }
  for (const auto& tie : scene.ties)
    for (std::size_t k = 0; k < tie.secondary_nodes.size() && tie.activity.acts_after(from); ++k)
      for (int axis = 0; axis < 3 && tie.is_tied[k]; ++axis) {
        Vec3<double> d{};
        d[axis] = 1;
        const Point& at = X[tie.secondary_nodes[k]];
        add_motion(body_of(scene, tie.secondary_nodes[k]), at, d, 1);
        add_motion(body_of(scene, tie.primary.facets[0][0]), at, d, -1);
        add_row();
      }
  for (const auto& obstacle : scene.obstacles)
    for (std::size_t k = 0; k < obstacle.secondary_nodes.size(); ++k) {
      const std::size_t multiplier = obstacle.first_multiplier + k;
      if (!obstacle.activity.acts_after(from) || !(closed[multiplier] || obstacle.is_two_sided)) continue;
      const int node = obstacle.secondary_nodes[k];
      add_motion(body_of(scene, node), X[node], normals[multiplier], 1);
      add_row();
    }

  std::vector<double> eigenvalues(n), work(64 * static_cast<std::size_t>(n));
  int info = 0;
  Teuchos::LAPACK<int, double>().SYEV('V', 'U', n, normal_matrix.data(), n, eigenvalues.data(), work.data(),
                                      static_cast<int>(work.size()), &info);
  std::vector<std::vector<double>> basis;
  for (int k = 0; k < n; ++k)
    if (eigenvalues[k] <= 1e-10 * std::max(1.0, eigenvalues[n - 1]))
      basis.emplace_back(&normal_matrix[static_cast<std::size_t>(k) * n], &normal_matrix[static_cast<std::size_t>(k) * n] + n);
  if (basis.empty()) return {};
  reduce(basis);

  std::vector<FreeBody> found;
  for (const auto& mode : basis) {
    const int largest = static_cast<int>(
        std::max_element(mode.begin(), mode.end(), [](double a, double b) { return std::abs(a) < std::abs(b); }) - mode.begin());
    const std::string& name = scene.bodies[largest / 6].name;
    std::vector<std::string> parts;
    for (int k = 0; k < n; ++k) {
      if (std::abs(mode[k]) < 1e-6) continue;
      const std::string motion_name =
          std::abs(mode[k] - 1) < 1e-6 ? mode_names[k % 6] : fmt::format("{:.3g} {}", mode[k], mode_names[k % 6]);
      parts.push_back(k / 6 == largest / 6 ? motion_name : fmt::format("{} of \"{}\"", motion_name, scene.bodies[k / 6].name));
    }
    auto at = std::find_if(found.begin(), found.end(), [&](const FreeBody& b) { return b.body == name; });
    if (at == found.end()) at = found.insert(found.end(), FreeBody{name, {}});
    at->modes.push_back(fmt::format("{}", fmt::join(parts, " with ")));
  }
  return found;
}

}  // namespace mortise
