#include "tangents/tangent_check.hpp"

#include <fmt/format.h>

#include <Teuchos_Time.hpp>
#include <algorithm>
#include <cmath>
#include <limits>

#include "assembly/vectors.hpp"

namespace mortise {
namespace {

using Entries = std::vector<double>;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// The tangent of a piece in one way, entries multiplied with the scales. Empty: inadmissible.
Entries scaled_tangent(const Piece& piece, TangentKind kind, double relative_step) {
  const std::size_t n = piece.scale.size();
  Entries K(n * n);
  if (!piece.tangent(kind, relative_step, K.data())) return {};
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t l = 0; l < n; ++l) K[k * n + l] *= piece.scale[k] * piece.scale[l];
  return K;
}

/// Infinite where there is no tangent, or an entry is not a number.
double greatest_difference(const Entries& A, const Entries& B) {
  if (A.empty() || B.empty()) return infinity;
  double greatest = 0;
  for (std::size_t k = 0; k < A.size(); ++k) {
    const double difference = std::abs(A[k] - B[k]);
    if (!(difference <= greatest)) greatest = std::isfinite(difference) ? difference : infinity;
  }
  return greatest;
}

double greatest_entry(const Entries& A) { return greatest_difference(A, Entries(A.size(), 0.0)); }

/// Tangents by differences of one piece with a step and its half.
struct Halving {
  TangentKind kind;
  Entries whole, half;
};

constexpr std::array difference_kinds{TangentKind::central_differences, TangentKind::forward_differences,
                                      TangentKind::backward_differences};

/// Observed orders of the differences of a piece, in the order of `difference_kinds`.
struct Orders {
  std::array<std::optional<double>, 3> order;
  bool has_kink = false;
};

// Forward and backward differences differ by h K' where the tangent is smooth, by its jump where it is not.
bool jumps(const Halving& forward, const Halving& backward, double noise) {
  const double whole = greatest_difference(forward.whole, backward.whole),
               half = greatest_difference(forward.half, backward.half);
  return half > noise && !(std::abs(std::log2(whole / half) - 1) < 0.3);
}

Orders observed_orders(const Piece& piece, const Entries& reference, bool may_have_kinks) {
  constexpr double eps = std::numeric_limits<double>::epsilon();
  const double size = greatest_entry(reference);
  Orders orders;
  std::array<bool, 3> done{};
  for (double h : {1e-4, 1e-3, 1e-2}) {
    std::array<Halving, 3> halvings;
    const double noise = 1e3 * eps * (1 + piece.magnitude) / (h / 2) * size;
    for (int d = 0; d < 3; ++d) {
      if (done[d] && !may_have_kinks) continue;
      halvings[d] = {difference_kinds[d], scaled_tangent(piece, difference_kinds[d], h),
                     scaled_tangent(piece, difference_kinds[d], h / 2)};
    }
    if (may_have_kinks && jumps(halvings[1], halvings[2], noise)) {
      orders.has_kink = std::none_of(done.begin(), done.end(), [](bool d) { return d; });
      return orders;  // with longer steps it is no farther
    }
    for (int d = 0; d < 3; ++d) {
      if (done[d] || halvings[d].whole.empty() || halvings[d].half.empty()) continue;
      const double whole = greatest_difference(halvings[d].whole, reference),
                   half = greatest_difference(halvings[d].half, reference);
      if (!(half > noise)) continue;
      orders.order[d] = std::log2(whole / half);
      done[d] = true;
    }
    if (std::all_of(done.begin(), done.end(), [](bool d) { return d; })) break;
  }
  return orders;
}

/// A value and the piece it belongs to; over all ranks the greatest value, of equal ones the first piece.
struct Worst {
  double value = -1;
  long long key = -1;

  void include(double other, long long other_key) {
    if (other > value) *this = {other, other_key};
  }
  void reduce(const Comm& comm) {
    const double greatest = all_reduced(comm, Teuchos::REDUCE_MAX, value);
    const long long mine = value == greatest ? key : std::numeric_limits<long long>::max();
    key = all_reduced(comm, Teuchos::REDUCE_MIN, mine);
    value = greatest;
  }
};

// Turns over a few pieces, so that neither a cache nor the clock is measured.
double seconds_per_piece(const std::vector<Piece>& pieces, TangentKind kind) {
  const std::size_t n = std::min<std::size_t>(pieces.size(), 12);
  if (n == 0) return 0;
  std::size_t n_entries = 0;
  for (std::size_t k = 0; k < n; ++k) n_entries = std::max(n_entries, pieces[k].scale.size() * pieces[k].scale.size());
  Entries K(n_entries);
  std::array<double, 7> turns{};
  for (double& turn : turns) {
    const double start = Teuchos::Time::wallTime();
    for (std::size_t k = 0; k < n; ++k) pieces[k].tangent(kind, best_step(kind), K.data());
    turn = (Teuchos::Time::wallTime() - start) / static_cast<double>(n);
  }
  std::nth_element(turns.begin(), turns.begin() + 3, turns.end());
  return turns[3];
}

}  // namespace

int expected_order(TangentKind kind) {
  switch (kind) {
    case TangentKind::central_differences:
      return 2;
    case TangentKind::forward_differences:
    case TangentKind::backward_differences:
      return 1;
    default:
      return 0;
  }
}

StateResult check_tangents(const CheckedTerm& term, const double* x, const Comm& comm) {
  const std::size_t n_ways = term.ways.size();
  const auto pieces = term.pieces(x);
  std::vector<Worst> farthest(n_ways), oddest(n_ways);
  std::vector<double> odd_order(n_ways, 0.0), seconds(n_ways);
  std::vector<int> counts(n_ways + 2, 0);  // of orders per way, of pieces, of kinks
  counts[n_ways] = static_cast<int>(pieces.size());
  for (const Piece& piece : pieces) {
    const Entries reference = scaled_tangent(piece, term.reference, best_step(term.reference));
    const double size = greatest_entry(reference);
    const Orders orders = observed_orders(piece, reference, term.has_kinks);
    counts[n_ways + 1] += orders.has_kink;
    for (std::size_t w = 0; w < n_ways; ++w) {
      const TangentKind kind = term.ways[w].kind;
      const auto at = std::find(difference_kinds.begin(), difference_kinds.end(), kind);
      const bool is_difference = at != difference_kinds.end();
      if (!(is_difference && orders.has_kink))
        farthest[w].include(greatest_difference(scaled_tangent(piece, kind, best_step(kind)), reference) / size, piece.key);
      if (!is_difference) continue;
      if (const auto& order = orders.order[at - difference_kinds.begin()]) {
        const double off = std::isfinite(*order) ? std::abs(*order - expected_order(kind)) : infinity;
        if (off > oddest[w].value) odd_order[w] = *order;
        oddest[w].include(off, piece.key);
        ++counts[w];
      }
    }
  }
  for (std::size_t w = 0; w < n_ways; ++w) seconds[w] = seconds_per_piece(pieces, term.ways[w].kind);
  all_reduce(comm, Teuchos::REDUCE_SUM, counts);
  all_reduce(comm, Teuchos::REDUCE_MAX, seconds);

  StateResult result{counts[n_ways], counts[n_ways + 1], {}};
  for (std::size_t w = 0; w < n_ways; ++w) {
    const double mine = oddest[w].value;
    const long long my_key = oddest[w].key;
    farthest[w].reduce(comm);
    oddest[w].reduce(comm);
    const bool is_mine = mine == oddest[w].value && my_key == oddest[w].key;
    const double order = all_reduced(comm, Teuchos::REDUCE_MAX, is_mine ? odd_order[w] : -infinity);
    WayResult way{std::max(0.0, farthest[w].value), farthest[w].key, {}, oddest[w].key, counts[w], seconds[w]};
    if (way.n_orders > 0) way.order = order;
    result.ways.push_back(way);
  }
  return result;
}

std::vector<std::string> disagreements(const CheckedTerm& term, const std::string& state, const StateResult& result,
                                       const TangentLimits& limits) {
  std::vector<std::string> lines;
  std::string reference;
  for (const Way& way : term.ways)
    if (way.kind == term.reference) reference = way.name;
  for (std::size_t w = 0; w < term.ways.size(); ++w) {
    const auto& [kind, name] = term.ways[w];
    const WayResult& way = result.ways[w];
    const int order = expected_order(kind);
    const std::string where = fmt::format("{}, {} state", term.name, state);
    if (order == 0 && !(way.difference <= limits.exact))
      lines.push_back(
          fmt::format("error[T01] {}, {}: \"{}\" differs from \"{}\" by {:.2g} of the greatest entry - must be at most {:g}",
                      where, term.describe(way.farthest), name, reference, way.difference, limits.exact));
    if (order > 0 && way.order && !(std::abs(*way.order - order) <= limits.order))
      lines.push_back(fmt::format("error[T02] {}, {}: \"{}\" approach \"{}\" with order {:.2f} - must be {} +- {:g}", where,
                                  term.describe(way.oddest), name, reference, *way.order, order, limits.order));
  }
  return lines;
}

}  // namespace mortise
