// A scene set up from a deck, as `mortise run` does it, for tests on any communicator.
#pragma once

#include <Teuchos_DefaultMpiComm.hpp>
#include <Tpetra_Core.hpp>
#include <functional>
#include <string>
#include <vector>

#include "solve/newton.hpp"
#include "support/random.hpp"
#include "support/scratch_folder.hpp"
#include "support/text.hpp"

namespace mortise::test {

inline RCP<const Comm> world() { return Tpetra::getDefaultComm(); }

/// Each rank for itself.
inline RCP<const Comm> alone() { return Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_SELF)); }

inline Scene scene_of(const std::string& deck_text, const std::function<void(Scene&)>& change = {}) {
  const ScratchFolder folder;
  std::vector<std::string> warnings;
  Scene scene = make_scene(Deck::read(folder.write("deck.xml", deck_text)), warnings);
  if (change) change(scene);
  return scene;
}

inline std::vector<int> contact_elements(const Scene& scene) {
  std::vector<int> elements;
  for (const auto& pair : scene.pairs)
    elements.insert(elements.end(), pair.secondary_elements.begin(), pair.secondary_elements.end());
  return elements;
}

/// Scene, equations and the state at time 0.
struct TestScene {
  Scene scene;
  Partition partition;
  StepProblem problem;
  State state;

  explicit TestScene(const std::string& deck_text, const RCP<const Comm>& comm = world(),
                     const std::function<void(Scene&)>& change = {})
      : scene(scene_of(deck_text, change)),
        partition(make_partition(scene.mesh.mesh, comm->getSize(), contact_elements(scene))),
        problem(scene, partition, comm),
        state(problem.initial_state()) {
    problem.begin_step(state, 0);
  }

  std::size_t n_positions() const { return 3 * scene.mesh.mesh.coordinates.size(); }
  std::size_t n_unknowns() const { return static_cast<std::size_t>(problem.dofs().n_unknowns()); }
  std::vector<double> gather(const Vector& v) const { return problem.gather(v); }

  RCP<Vector> scatter(const std::vector<double>& all) const { return problem.scatter(all); }

  /// A matrix of the problem's unknowns, row-major, on every rank. Collective.
  std::vector<double> dense(const Matrix& K) const {
    const std::size_t n = n_unknowns();
    std::vector<double> J(n * n), unit(n, 0.0);
    Vector product(problem.dofs().owned_map());
    for (std::size_t c = 0; c < n; ++c) {
      unit[c] = 1;
      K.apply(*scatter(unit), product);
      unit[c] = 0;
      const auto column = gather(product);
      for (std::size_t r = 0; r < n; ++r) J[r * n + c] = column[r];
    }
    return J;
  }

  /// Reference positions moved by up to `size` and pressures in [low, high): the same on any number of ranks.
  std::vector<double> random_state(Random& random, double size, double low, double high) const {
    std::vector<double> x(n_unknowns());
    for (std::size_t k = 0; k < n_positions(); ++k) x[k] = scene.mesh.mesh.coordinates[k / 3][k % 3] + random.in(-size, size);
    for (std::size_t k = n_positions(); k < x.size(); ++k) x[k] = random.in(low, high);
    return x;
  }

  struct Run {
    bool converged = true;
    std::string cause;
    int iterations = 0;
    Evaluation at;
  };

  /// Solves step after step; the state is then that of the last time.
  Run march(const std::vector<double>& times) {
    Newton newton(problem, scene.solver);
    Run run;
    for (double t : times) {
      auto step = newton.solve(state, t);
      run.iterations += step.iterations;
      run.converged = step.converged;
      run.cause = step.cause;
      if (!step.converged) return run;
      state = step.state;
      run.at = step.evaluation;
    }
    return run;
  }
};

/// Greatest difference of entries [from, to) over the greatest entry.
inline double relative_difference(const std::vector<double>& a, const std::vector<double>& b, std::size_t from, std::size_t to) {
  double difference = 0, greatest = 1e-300;
  for (std::size_t k = from; k < to; ++k) {
    difference = std::max(difference, std::abs(a[k] - b[k]));
    greatest = std::max(greatest, std::abs(b[k]));
  }
  return difference / greatest;
}

}  // namespace mortise::test
