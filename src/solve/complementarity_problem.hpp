// Small linear complementarity problems: which of a few undecided nodes are in contact.
#pragma once

#include <optional>
#include <vector>

namespace mortise {

/// Solves  w = q + M z,  z >= 0, w >= 0, z . w = 0  by block principal pivoting: all wrong signs are flipped at once as long as
/// their number falls, else the wrong one of least index alone (Murty 1974; Judice & Pires 1994), which ends for every P-matrix.
/// @param M n x n, row-major  @param q n entries  @param no_sign size below which an entry counts as zero
/// @param basic where it begins: whether z may be positive at an entry, n of them; empty: nowhere
/// @return z, or nothing if a pivot block is singular, the pivoting does not end or M or q is not finite
std::optional<std::vector<double>> solve_complementarity(const std::vector<double>& M, const std::vector<double>& q,
                                                         double no_sign, std::vector<char> basic = {});

}  // namespace mortise
