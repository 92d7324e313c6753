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

  for (const auto& cell : cells) {
    for (int p : cell) {
      const int row = dofs.local(p);
      places_.push_back({dofs.size(p), static_cast<int>(row_start(row + 1) - row_start(row))});
      for (int r : cell) {
        const auto& near = neighbours[index[p]];
        const auto found = std::lower_bound(near.begin(), near.end(), index[r]);
        const bool here = found != near.end() && *found == index[r];
        starts_.push_back(here ? static_cast<int>(row_start(row)) + block_start[index[p]][found - near.begin()] : -1);
      }
    }
    first_.push_back(places_.size());
    first_start_.push_back(starts_.size());
  }

  const LocalMatrix local("tangent", n_rows, n_rows, n_entries, values, row_start, columns);
  if (dofs.comm()->getSize() > 1) {
    share_rows(local);
  } else {
    overlap_ = Teuchos::rcp(new Matrix(local, dofs.overlap_map(), dofs.overlap_map(), dofs.overlap_map(), dofs.overlap_map()));
  }
}

// Owned rows come first. Their entries are copied to places known from here on; only the rows behind them pass through an export,
// which searches.
void SystemMatrix::share_rows(const LocalMatrix& local) {
  const RCP<const Map> overlap = dofs_.overlap_map(), owned = dofs_.owned_map();
  const int n_rows = local.numRows(), n_owned = dofs_.n_owned(), n_ghosts = n_rows - n_owned;
  const auto row_start = local.graph.row_map;
  const auto first = row_start(n_owned), end = row_start(n_rows);

  std::vector<GlobalIndex> ghosts;
  for (int row = n_owned; row < n_rows; ++row) ghosts.push_back(overlap->getGlobalElement(row));
  const auto none = Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid();
  const RCP<const Map> ghost_map =
      Teuchos::rcp(new Map(none, Teuchos::ArrayView<const GlobalIndex>(ghosts), overlap->getIndexBase(), dofs_.comm()));
  LocalMatrix::row_map_type::non_const_type ghost_start("row start of ghosts", n_ghosts + 1);
  for (int k = 0; k <= n_ghosts; ++k) ghost_start(k) = row_start(n_owned + k) - first;
  const auto range = std::make_pair(first, end);
  const LocalMatrix ghost_rows("tangent of ghosts", n_ghosts, n_rows, end - first, Kokkos::subview(local.values, range),
                               ghost_start, Kokkos::subview(local.graph.entries, range));
  ghost_ = Teuchos::rcp(new Matrix(ghost_rows, ghost_map, overlap, owned, owned));
  exporter_ = Teuchos::rcp(new Export(ghost_map, owned));

  const auto graph = Teuchos::rcp(new Graph(owned, 0));
  {  // all shares of the owned rows, of this rank and of others
    const Matrix shares(local, overlap, overlap, overlap, overlap);
    graph->doExport(*shares.getCrsGraph(), Export(overlap, owned), Tpetra::INSERT);
    graph->fillComplete(owned, owned);
  }
  owned_ = Teuchos::rcp(new Matrix(graph));
  owned_->fillComplete(owned, owned);

  const auto to = owned_->getLocalMatrixHost();
  const auto columns = owned_->getColMap();
  place_in_owned_.resize(first);
  for (int row = 0; row < n_owned; ++row) {
    const auto begin = &to.graph.entries(0) + to.graph.row_map(row), stop = &to.graph.entries(0) + to.graph.row_map(row + 1);
    for (auto k = row_start(row); k < row_start(row + 1); ++k) {
      const int column = columns->getLocalElement(overlap->getGlobalElement(local.graph.entries(k)));
      place_in_owned_[k] = static_cast<int>(std::lower_bound(begin, stop, column) - &to.graph.entries(0));
    }
  }
  std::vector<char> is_hit(owned_->getNodeNumEntries(), 0);
  for (int place : place_in_owned_) is_hit[place] = 1;
  for (std::size_t k = 0; k < is_hit.size(); ++k)
    if (!is_hit[k]) of_others_.push_back(static_cast<int>(k));
}

void SystemMatrix::reset() {
  if (constant_.extent(0) > 0) {
    Kokkos::deep_copy(values_, constant_);
  } else {
    Kokkos::deep_copy(values_, 0.0);
  }
}

void SystemMatrix::keep_as_constant() {
  if (constant_.extent(0) == 0) constant_ = decltype(constant_)("constant part", values_.extent(0));
  Kokkos::deep_copy(constant_, values_);
}

void SystemMatrix::clear() {
  constant_ = {};
  reset();
}

void SystemMatrix::add(std::size_t c, const double* K) {
  const Place* places = places_.data() + first_[c];
  const int* starts = starts_.data() + first_start_[c];
  const int n = static_cast<int>(first_[c + 1] - first_[c]);
  double* values = values_.data();
  for (int a = 0; a < n; ++a)
    for (int i = 0; i < places[a].size; ++i)
      for (int b = 0; b < n; ++b) {
        if (const int start = starts[a * n + b]; start >= 0) {
          double* to = values + start + i * places[a].stride;
          for (int j = 0; j < places[b].size; ++j) to[j] += K[j];
        }
        K += places[b].size;
      }
}

RCP<Matrix> SystemMatrix::assemble() {
  if (exporter_.is_null()) return overlap_;
  owned_->resumeFill();
  {
    double* to = owned_->getLocalMatrixHost().values.data();
    const double* from = values_.data();
    for (int place : of_others_) to[place] = 0;
    for (std::size_t k = 0; k < place_in_owned_.size(); ++k) to[place_in_owned_[k]] = from[k];
  }
  owned_->doExport(*ghost_, *exporter_, Tpetra::ADD);
  owned_->fillComplete(dofs_.owned_map(), dofs_.owned_map());
  return owned_;
}

std::size_t SystemMatrix::bytes() const {
  const std::size_t n_entries = values_.extent(0), n_shared = place_in_owned_.size() + of_others_.size();
  const std::size_t entry = sizeof(double) + sizeof(int);
  return n_entries * entry + constant_.extent(0) * sizeof(double) + diagonal_.size() * (sizeof(int) + sizeof(std::size_t)) +
         (first_.size() + first_start_.size()) * sizeof(std::size_t) + places_.size() * sizeof(Place) +
         starts_.size() * sizeof(int) + n_shared * sizeof(int) + (owned_.is_null() ? 0 : owned_->getNodeNumEntries() * entry);
}

}  // namespace mortise
