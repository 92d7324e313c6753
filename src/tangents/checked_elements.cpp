// The elements of a body, as the tangent check sees them.
#include <fmt/format.h>

#include <algorithm>

#include "deck/names.hpp"
#include "tangents/checked_term.hpp"

namespace mortise {
namespace {

using Laws = std::vector<std::pair<TangentKind, MaterialLaw>>;

template <class Block>
Piece piece_of(const Block& block, std::size_t e, const double* x, const std::shared_ptr<const Laws>& laws) {
  const auto all_scales = block.scales(e);
  Piece piece{block.element(e), {all_scales.begin(), all_scales.begin() + block.n_unknowns()}, 0, {}};
  const auto y = block.unknowns(e, x);
  for (std::size_t k = 0; k < y.size(); ++k) piece.magnitude = std::max(piece.magnitude, std::abs(y[k]) / piece.scale[k]);
  piece.tangent = [&block, e, x, laws](TangentKind kind, double relative_step, double* K) {
    double r[Block::n_unknowns()];
    const auto law = std::find_if(laws->begin(), laws->end(), [kind](const auto& entry) { return entry.first == kind; });
    return block.tangent(kind, relative_step, law->second, e, x, r, K);
  };
  return piece;
}

}  // namespace

CheckedTerm checked_elements(const StepProblem& problem, const BodyTerm& term, ElementType type, int most,
                             const std::function<MaterialLaw(TangentKind)>& law) {
  const Scene& scene = problem.scene();
  const Mesh& mesh = scene.mesh.mesh;
  const Body& body = term.body();
  std::vector<int> elements;
  for (int e : body.elements)
    if (element_type(mesh, e) == type) elements.push_back(e);
  const int n = static_cast<int>(elements.size()), stride = stride_for(n, most);
  std::vector<int> chosen;
  for (int k = 0; k < n; k += stride) chosen.push_back(elements[k]);

  CheckedTerm checked;
  checked.name =
      fmt::format("body \"{}\" ({}, {}, {})", body.name, topology(type).name, word_for(formulation_names, body.formulation),
                  std::visit([](const auto& m) { return std::string(m.name); }, body.material));
  checked.pieces_name = "elements";
  const auto laws = std::make_shared<Laws>();
  for (const auto& [word, kind] : tangent_names) {
    checked.ways.push_back({kind, word});
    laws->emplace_back(kind, law(kind));
  }
  checked.reference = TangentKind::complex_step;
  checked.time_unit = TangentKind::analytic;
  checked.has_kinks = false;
  checked.n_pieces = n;
  checked.n_chosen = static_cast<int>(chosen.size());
  checked.describe = [&scene](long long key) { return describe_element(scene.mesh, static_cast<int>(key)); };
  checked.pieces = [&mesh, &term, type, laws, chosen](const double* x) {
    std::vector<Piece> pieces;
    for (const auto& variant : term.blocks())
      std::visit(
          [&](const auto& block) {
            if (element_type(mesh, block.element(0)) != type) return;
            for (std::size_t e = 0; e < block.size(); ++e)
              if (std::binary_search(chosen.begin(), chosen.end(), block.element(e)))
                pieces.push_back(piece_of(block, e, x, laws));
          },
          variant);
    return pieces;
  };
  return checked;
}

}  // namespace mortise
