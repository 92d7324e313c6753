#include "setup.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "assembly/rigid_modes.hpp"
#include "assembly/vectors.hpp"
#include "errors.hpp"

namespace mortise {
namespace {

std::vector<int> contact_elements(const Scene& scene) {
  std::vector<int> elements;
  const auto append = [&](const OppositeSurfaces& pair) {
    elements.insert(elements.end(), pair.secondary_elements.begin(), pair.secondary_elements.end());
  };
  std::for_each(scene.pairs.begin(), scene.pairs.end(), append);
  std::for_each(scene.ties.begin(), scene.ties.end(), append);
  return elements;
}

Partition partition_of(const Scene& scene, const Comm& comm) {
  const int n = n_elements(scene.mesh.mesh);
  if (comm.getSize() > n)
    throw UserError(ExitCode::resources, fmt::format("error[R02] {} ranks, but {} element{} - at most {} rank{} can be used",
                                                     comm.getSize(), n, n == 1 ? "" : "s", n, n == 1 ? "" : "s"));
  return make_partition(scene.mesh.mesh, comm.getSize(), contact_elements(scene));
}

}  // namespace

Setup::Setup(Deck d, const RCP<const Comm>& comm)
    : deck(std::move(d)),
      scene(make_scene(deck, warnings)),
      partition(partition_of(scene, *comm)),
      problem(scene, partition, comm) {}

State Setup::first_state() {
  State state = problem.initial_state();
  if (const std::string fault = problem.begin_step(state, 0); !fault.empty()) throw DeckError(fault);
  for (const MortarTerm* term : problem.pairs()) {
    int n_held = 0;
    for (std::size_t k = 0; k < term->pair().secondary_nodes.size(); ++k) n_held += term->is_held(k);
    if (n_held > 0)
      warnings.push_back(
          fmt::format("contact > {}: supports hold {} secondary nodes along their normals, beside free ones or on "
                      "both sides: they have no pressure",
                      term->pair().name, n_held));
  }
  if (problem.stage().scheme.has_inertia()) return state;
  std::vector<char> closed(scene.n_multipliers, 0);
  std::vector<Vec3<double>> normals;
  const Evaluation at = problem.evaluate(*state.x);
  if (scene.n_multipliers > 0) closed = at.closed;
  const auto x = problem.to_overlap(*state.x);
  for (const auto& contact : problem.contacts())
    for (const auto& n : contact->normals(data(*x))) normals.push_back(n);
  std::vector<std::string> messages;
  for (const auto& body : free_bodies(scene, closed, normals, state.time))
    messages.push_back(
        deck.error("D22", {"bodies", body.body},
                   fmt::format("{} free rigid {} in statics: {} - add supports, or let contact be closed at the "
                               "start",
                               body.modes.size(), body.modes.size() == 1 ? "mode" : "modes", fmt::join(body.modes, ", "))));
  if (!messages.empty()) throw DeckError(messages);
  return state;
}

}  // namespace mortise
