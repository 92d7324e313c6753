// What the tangent check sees of a term: pieces, each with a tangent that can be found in several ways.
//
// A new term joins by a function that returns a CheckedTerm, and one line in `checked_terms`.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "assembly/step_problem.hpp"
#include "assembly/tangent_kind.hpp"

namespace mortise {

/// A way to differentiate, under the name that the user reads.
struct Way {
  TangentKind kind;
  std::string name;
};

/// A part of a term with a tangent of its own, at one state: an element, a pair of facets.
struct Piece {
  long long key;              ///< the same on any number of ranks
  std::vector<double> scale;  ///< size of each unknown: entry (k, l) of the tangent counts scale_k scale_l (an energy for all)
  double magnitude;           ///< greatest |unknown| / scale: what round-off is multiplied with
  /// Overwrites K, square and row-major. @return false for an inadmissible state
  std::function<bool(TangentKind kind, double relative_step, double* K)> tangent;
};

struct CheckedTerm {
  std::string name;         ///< e.g. `body "slab" (hex8, standard, neo-hookean)`
  std::string pieces_name;  ///< e.g. `elements`
  std::vector<Way> ways;    ///< in the order of the table
  TangentKind reference;    ///< the way that the others are compared with
  TangentKind time_unit;    ///< the way whose time is 1
  bool has_kinks;           ///< the tangent may jump between states
  int n_pieces, n_chosen;   ///< of all ranks: all that there are to choose from, and those that were chosen
  std::function<std::vector<Piece>(const double* x)> pieces;  ///< those chosen, of this rank, at a state on the overlap
  std::function<std::string(long long key)> describe;         ///< a piece by the user's own numbers, on every rank
};

/// Every stride-th of `n` entries, so that at most `most` are chosen.
inline int stride_for(int n, int most) { return n <= most ? 1 : (n + most - 1) / most; }

/// The elements of one type in a body.
/// @param law that an element is given for a way; not the body's own only in tests of the check
CheckedTerm checked_elements(const StepProblem& problem, const BodyTerm& body, ElementType type, int most,
                             const std::function<MaterialLaw(TangentKind)>& law);

/// The pairs of facets of one contact pair that overlap, by at least a hundredth of the secondary facet.
CheckedTerm checked_facets(const StepProblem& problem, const MortarTerm& pair, const Partition& partition, int most);

/// The sides of a load that follows the positions, at the last time at which it acts. @throws DeckError for a formula without
/// value
CheckedTerm checked_sides(const StepProblem& problem, const Load& load, const Partition& partition, int most);

/// All terms of a scene whose tangents depend on the state, in the same order on every rank. @param most pieces of a term
std::vector<CheckedTerm> checked_terms(const StepProblem& problem, const Partition& partition, int most);

}  // namespace mortise
