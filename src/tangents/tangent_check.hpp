// Compares the ways to differentiate a term, at one state: differences, orders, times.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tangents/checked_term.hpp"

namespace mortise {

/// How far tangents may be apart (conventions, exit code 8).
struct TangentLimits {
  double exact = 1e-10;  ///< of the greatest entry, for ways without truncation
  double order = 0.3;    ///< between the observed and the expected order of differences
};

/// One way at one state, over all pieces and ranks.
struct WayResult {
  double difference = 0;    ///< greatest over the pieces: |K - K_ref| / |K_ref|, greatest entries; infinite if K cannot be found
  long long farthest = -1;  ///< the piece where it is
  std::optional<double> order;  ///< of differences: the one that is farthest from what it should be; none: truncation never shows
  long long oddest = -1;        ///< the piece where it is
  int n_orders = 0;             ///< pieces that had one
  double seconds = 0;           ///< per piece: median of 7 turns, of the slowest rank
};

struct StateResult {
  int n_pieces = 0;             ///< that were compared
  int n_kinks = 0;              ///< of these, with a kink so near that differences say nothing
  std::vector<WayResult> ways;  ///< as CheckedTerm::ways
};

/// The order that differences of a kind have; 0: a way without truncation.
int expected_order(TangentKind kind);

/// Entries (k, l) are compared after multiplication with scale_k scale_l, so that no unit matters. The order of differences is
/// seen in one halving of the step from h = 1e-4, 1e-3 or 1e-2 of the scale, the first at which truncation exceeds round-off
/// 1000-fold. A piece of a term with kinks is left out of the orders if forward and backward differences do not approach each
/// other linearly there: whether a kink is near is decided without the tangents that are judged. Collective.
/// @param x positions and pressures on the overlap
StateResult check_tangents(const CheckedTerm& term, const double* x, const Comm& comm);

/// A line for each way that disagrees: term, state, piece by the user's numbers, way, figures.
std::vector<std::string> disagreements(const CheckedTerm& term, const std::string& state, const StateResult& result,
                                       const TangentLimits& limits = {});

}  // namespace mortise
