#include "assembly/system_matrix.hpp"

#include <algorithm>

namespace mortise {

SystemMatrix::SystemMatrix(const DofSpace& dofs, const std::vector<Cell>& cells) : dofs_(dofs) {
  const auto& points = dofs.overlap_points();
  std::vector<int> index(dofs.n_points(), -1);  // point -> position in the overlap
  for (std::size_t k = 0; k < points.size(); ++k) index[points[k]] = static_cast<int>(k);

  const auto coupled = [&](int a, int b) { return a == b || dofs.size(points[a]) == 3 || dofs.size(points[b]) == 3; };
  std::vector<std::vector<int>> neighbours(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) neighbours[k].push_back(static_cast<int>(k));
  for (const auto& cell : cells)
    for (int p : cell)
      for (int r : cell)
        if (p != r && coupled(index[p], index[r])) neighbours[index[p]].push_back(index[r]);

  const int n_rows = static_cast<int>(dofs.overlap_map()->getNodeNumElements());
  using LocalMatrix = Matrix::local_matrix_device_type;
  LocalMatrix::row_map_type::non_const_type row_start("row start", n_rows + 1);
  std::vector<std::vector<int>> block_start(points.size());  // offset of each neighbour within a row
  std::size_t n_entries = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    auto& near = neighbours[k];
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    int length = 0;
    for (int b : near) {
      block_start[k].push_back(length);
      length += dofs.size(points[b]);
    }
    for (int i = 0; i < dofs.size(points[k]); ++i) {
      row_start(dofs.local(points[k]) + i) = n_entries;
      n_entries += length;
    }
  }
  row_start(n_rows) = n_entries;

  LocalMatrix::index_type columns("columns", n_entries);
  LocalMatrix::values_type values("values", n_entries);
  diagonal_.resize(n_rows);
  for (std::size_t k = 0; k < points.size(); ++k)
    for (int i = 0; i < dofs.size(points[k]); ++i) {
      const int row = dofs.local(points[k]) + i;
      std::size_t at = row_start(row);
      for (int b : neighbours[k])
        for (int j = 0; j < dofs.size(points[b]); ++j, ++at) {
          columns(at) = dofs.local(points[b]) + j;
          if (columns(at) == row) diagonal_[row] = static_cast<int>(at);
        }
    }
  values_ = values;
  overlap_ = Teuchos::rcp(new Matrix(LocalMatrix("tangent", n_rows, n_rows, n_entries, values, row_start, columns),
                                     dofs.overlap_map(), dofs.overlap_map(), dofs.overlap_map(), dofs.overlap_map()));

  for (const auto& cell : cells) {
    Scatter s;
    for (int p : cell) {
      const int a = index[p];
      s.size.push_back(dofs.size(p));
      const int row = dofs.local(p);
      s.stride.push_back(static_cast<int>(row_start(row + 1) - row_start(row)));
      for (int r : cell) {
        const int b = index[r];
        const auto found = std::lower_bound(neighbours[a].begin(), neighbours[a].end(), b);
        const bool here = found != neighbours[a].end() && *found == b;
        s.start.push_back(here ? static_cast<int>(row_start(row)) + block_start[a][found - neighbours[a].begin()] : -1);
      }
    }
    scatter_.push_back(std::move(s));
  }

  if (dofs.comm()->getSize() > 1) {
    exporter_ = Teuchos::rcp(new Export(dofs.overlap_map(), dofs.owned_map()));
    const auto graph = Teuchos::rcp(new Graph(dofs.owned_map(), 0));
    graph->doExport(*overlap_->getCrsGraph(), *exporter_, Tpetra::INSERT);
    graph->fillComplete(dofs.owned_map(), dofs.owned_map());
    owned_ = Teuchos::rcp(new Matrix(graph));
    owned_->fillComplete(dofs.owned_map(), dofs.owned_map());
  }
}

void SystemMatrix::zero() { Kokkos::deep_copy(values_, 0.0); }

void SystemMatrix::add(std::size_t c, const double* K) {
  const Scatter& s = scatter_[c];
  const int n = static_cast<int>(s.size.size());
  double* values = values_.data();
  int width = 0;
  for (int size : s.size) width += size;
  for (int a = 0; a < n; ++a) {
    for (int i = 0; i < s.size[a]; ++i, K += width) {
      const double* entry = K;
      for (int b = 0; b < n; ++b) {
        const int start = s.start[a * n + b];
        if (start >= 0) {
          double* to = values + start + i * s.stride[a];
          for (int j = 0; j < s.size[b]; ++j) to[j] += entry[j];
        }
        entry += s.size[b];
      }
    }
  }
}

RCP<Matrix> SystemMatrix::assemble() {
  if (exporter_.is_null()) return overlap_;
  owned_->resumeFill();
  owned_->setAllToScalar(0.0);
  owned_->doExport(*overlap_, *exporter_, Tpetra::ADD);
  owned_->fillComplete(dofs_.owned_map(), dofs_.owned_map());
  return owned_;
}

}  // namespace mortise
