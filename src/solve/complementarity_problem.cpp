#include "solve/complementarity_problem.hpp"

#include <Teuchos_LAPACK.hpp>

namespace mortise {
namespace {

// Solves A x = b, A column-major. @return false if singular
bool solve_dense(std::vector<double> A, std::vector<double>& b) {
  const int n = static_cast<int>(b.size());
  std::vector<int> pivots(n);
  int info = 0;
  if (n > 0) Teuchos::LAPACK<int, double>().GESV(n, 1, A.data(), n, pivots.data(), b.data(), n, &info);
  return info == 0;
}

}  // namespace

std::optional<std::vector<double>> solve_complementarity(const std::vector<double>& M, const std::vector<double>& q,
                                                         double no_sign, std::vector<char> basic) {
  const std::size_t n = q.size();
  basic.resize(n, 0);
  std::size_t fewest = n + 1;
  int patience = 3;
  for (int round = 0; round < 1000; ++round) {
    std::vector<std::size_t> in;
    for (std::size_t k = 0; k < n; ++k)
      if (basic[k]) in.push_back(k);
    std::vector<double> A, z_in;
    for (std::size_t c : in) {
      for (std::size_t r : in) A.push_back(M[r * n + c]);
      z_in.push_back(-q[c]);
    }
    if (!solve_dense(A, z_in)) return std::nullopt;
    std::vector<double> z(n, 0.0);
    for (std::size_t k = 0; k < in.size(); ++k) z[in[k]] = z_in[k];
    std::vector<std::size_t> wrong;
    for (std::size_t r = 0; r < n; ++r) {
      double w = q[r];
      for (std::size_t c = 0; c < n; ++c) w += M[r * n + c] * z[c];
      if (basic[r] ? !(z[r] >= 0) : !(w >= -no_sign)) wrong.push_back(r);
    }
    if (wrong.empty()) return z;
    if (wrong.size() < fewest) {
      fewest = wrong.size();
      patience = 3;
    } else {
      --patience;
    }
    if (patience < 0) wrong.resize(1);
    for (std::size_t r : wrong) basic[r] = !basic[r];
  }
  return std::nullopt;
}

}  // namespace mortise
