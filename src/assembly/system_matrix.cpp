#include "assembly/system_matrix.hpp"

#include <algorithm>
#include <numeric>

namespace mortise {
namespace {

using LocalGraph = Graph::local_graph_device_type;

/// The graph with the columns of other ranks in the order of ranks, then of numbers, so that the unknowns of a point stand side
/// by side; Tpetra leaves those of one rank as they come.
RCP<const Graph> with_sorted_columns(const Graph& graph) {
  const RCP<const Map> owned = graph.getRowMap(), columns = graph.getColMap();
  const int n_owned = static_cast<int>(owned->getNodeNumElements()), n = static_cast<int>(columns->getNodeNumElements());
  std::vector<GlobalIndex> numbers(columns->getNodeElementList().begin(), columns->getNodeElementList().end());
  std::vector<int> ranks(n - n_owned);
  owned->getRemoteIndexList(Teuchos::ArrayView<const GlobalIndex>(numbers.data() + n_owned, n - n_owned),
                            Teuchos::ArrayView<int>(ranks.data(), n - n_owned));
  std::vector<int> order(n), place(n);  // new -> old, old -> new
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin() + n_owned, order.end(), [&](int a, int b) {
    return std::make_pair(ranks[a - n_owned], numbers[a]) < std::make_pair(ranks[b - n_owned], numbers[b]);
  });
  std::vector<GlobalIndex> sorted;
  for (int k = 0; k < n; ++k) {
    place[order[k]] = k;
    sorted.push_back(numbers[order[k]]);
  }
  const auto unknown = Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid();
  const RCP<const Map> sorted_columns =
      Teuchos::rcp(new Map(unknown, Teuchos::ArrayView<const GlobalIndex>(sorted), columns->getIndexBase(), columns->getComm()));

  const auto old = graph.getLocalGraphHost();
  LocalGraph::entries_type::non_const_type entries("columns", old.entries.extent(0));
  for (int row = 0; row < n_owned; ++row) {
    const auto begin = old.row_map(row), end = old.row_map(row + 1);
    for (auto k = begin; k < end; ++k) entries(k) = place[old.entries(k)];
    std::sort(entries.data() + begin, entries.data() + end);
  }
  return Teuchos::rcp(new Graph(LocalGraph(entries, old.row_map), owned, sorted_columns, owned, owned));
}

}  // namespace

SystemMatrix::SystemMatrix(const DofSpace& dofs, const std::vector<Cell>& cells) : dofs_(dofs) {
  const auto& points = dofs.overlap_points();
  std::vector<int> index(dofs.n_points(), -1);  // point -> position in the overlap
  for (std::size_t k = 0; k < points.size(); ++k) index[points[k]] = static_cast<int>(k);

  const auto coupled = [&](int a, int b) { return a == b || dofs.is_node(points[a]) || dofs.is_node(points[b]); };
  std::vector<std::vector<int>> neighbours(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) neighbours[k].push_back(static_cast<int>(k));
  for (const auto& cell : cells)
    for (int p : cell)
      for (int r : cell)
        if (p != r && coupled(index[p], index[r])) neighbours[index[p]].push_back(index[r]);

  const int n_rows = static_cast<int>(dofs.overlap_map()->getNodeNumElements());
  LocalGraph::row_map_type::non_const_type row_start("row start", n_rows + 1);
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
  LocalGraph::entries_type::non_const_type columns("columns", n_entries);
  for (std::size_t k = 0; k < points.size(); ++k)
    for (int i = 0; i < dofs.size(points[k]); ++i) {
      std::size_t at = row_start(dofs.local(points[k]) + i);
      for (int b : neighbours[k])
        for (int j = 0; j < dofs.size(points[b]); ++j) columns(at++) = dofs.local(points[b]) + j;
    }
  share_rows(LocalGraph(columns, row_start));

  // Rows of the owned matrix also hold what other ranks couple, and number columns in another way.
  const auto owned = owned_->getLocalMatrixHost().graph;
  const RCP<const Map> column_map = owned_->getColMap();
  const auto row_begin = [&](int row) {
    return static_cast<int>(row < dofs.n_owned() ? owned.row_map(row) : row_start(row) - row_start(dofs.n_owned()));
  };
  const auto row_length = [&](int row) {
    return static_cast<int>(row < dofs.n_owned() ? owned.row_map(row + 1) - owned.row_map(row)
                                                 : row_start(row + 1) - row_start(row));
  };
  diagonal_.resize(dofs.n_owned());
  for (std::size_t k = 0; k < points.size(); ++k) {
    const int row = dofs.local(points[k]);
    if (row >= dofs.n_owned()) continue;
    const int *begin = &owned.entries(row_begin(row)), *end = begin + row_length(row);
    for (std::size_t n = 0; n < neighbours[k].size(); ++n) {
      const int b = neighbours[k][n];
      if (!ghost_.is_null()) {
        const int column = column_map->getLocalElement(dofs.global(points[b]));
        block_start[k][n] = static_cast<int>(std::lower_bound(begin, end, column) - begin);
      }
      if (b == static_cast<int>(k))
        for (int i = 0; i < dofs.size(points[k]); ++i) diagonal_[row + i] = row_begin(row + i) + block_start[k][n] + i;
    }
  }

  for (const auto& cell : cells) {
    for (int p : cell) {
      const int row = dofs.local(p);
      places_.push_back({row >= dofs.n_owned(), dofs.size(p), row_length(row)});
      for (int r : cell) {
        const auto& near = neighbours[index[p]];
        const auto found = std::lower_bound(near.begin(), near.end(), index[r]);
        const bool here = found != near.end() && *found == index[r];
        starts_.push_back(here ? row_begin(row) + block_start[index[p]][found - near.begin()] : -1);
      }
    }
    first_.push_back(places_.size());
    first_start_.push_back(starts_.size());
  }
  find_values();
}

// On several ranks owned rows, which come first, get all columns that any rank couples them with; the rows behind them are sent.
void SystemMatrix::share_rows(const LocalGraph& overlap_rows) {
  const RCP<const Map> overlap = dofs_.overlap_map(), owned = dofs_.owned_map();
  const auto shares = Teuchos::rcp(new Graph(overlap_rows, overlap, overlap, overlap, overlap));
  if (dofs_.comm()->getSize() == 1) {
    owned_ = Teuchos::rcp(new Matrix(shares));
    owned_->fillComplete(owned, owned);
    return;
  }
  const auto graph = Teuchos::rcp(new Graph(owned, 0));
  graph->doExport(*shares, Export(overlap, owned), Tpetra::INSERT);
  graph->fillComplete(owned, owned);
  owned_ = Teuchos::rcp(new Matrix(with_sorted_columns(*graph)));
  owned_->fillComplete(owned, owned);

  const int n_owned = dofs_.n_owned(), n_ghosts = static_cast<int>(overlap->getNodeNumElements()) - n_owned;
  const auto row_start = overlap_rows.row_map;
  const auto first = row_start(n_owned), end = row_start(n_owned + n_ghosts);
  std::vector<GlobalIndex> ghosts;
  for (int k = 0; k < n_ghosts; ++k) ghosts.push_back(overlap->getGlobalElement(n_owned + k));
  const auto unknown = Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid();
  const RCP<const Map> ghost_map =
      Teuchos::rcp(new Map(unknown, Teuchos::ArrayView<const GlobalIndex>(ghosts), overlap->getIndexBase(), dofs_.comm()));
  LocalGraph::row_map_type::non_const_type ghost_start("row start of ghosts", n_ghosts + 1);
  for (int k = 0; k <= n_ghosts; ++k) ghost_start(k) = row_start(n_owned + k) - first;
  const LocalGraph ghost_rows(Kokkos::subview(overlap_rows.entries, std::make_pair(first, end)), ghost_start);
  ghost_ = Teuchos::rcp(new Matrix(Teuchos::rcp(new Graph(ghost_rows, ghost_map, overlap, owned, owned))));
  ghost_->fillComplete(owned, owned);
  exporter_ = Teuchos::rcp(new Export(ghost_map, owned));
}

void SystemMatrix::find_values() {
  owned_values_ = owned_->getLocalMatrixHost().values.data();
  if (!ghost_.is_null()) ghost_values_ = ghost_->getLocalMatrixHost().values.data();
}

namespace {

std::size_t n_entries(const RCP<Matrix>& matrix) { return matrix.is_null() ? 0 : matrix->getNodeNumEntries(); }

void restore(double* values, std::size_t n, const std::vector<double>& constant) {
  if (constant.empty()) {
    std::fill_n(values, n, 0.0);
  } else {
    std::copy(constant.begin(), constant.end(), values);
  }
}

}  // namespace

void SystemMatrix::reset() {
  find_values();
  restore(owned_values_, n_entries(owned_), owned_constant_);
  restore(ghost_values_, n_entries(ghost_), ghost_constant_);
}

void SystemMatrix::keep_as_constant() {
  owned_constant_.assign(owned_values_, owned_values_ + n_entries(owned_));
  ghost_constant_.assign(ghost_values_, ghost_values_ + n_entries(ghost_));
}

void SystemMatrix::clear() {
  owned_constant_.clear();
  ghost_constant_.clear();
  reset();
}

void SystemMatrix::add(std::size_t c, const double* K) {
  const Place* places = places_.data() + first_[c];
  const int* starts = starts_.data() + first_start_[c];
  const int n = static_cast<int>(first_[c + 1] - first_[c]);
  for (int a = 0; a < n; ++a) {
    double* values = places[a].is_ghost ? ghost_values_ : owned_values_;
    for (int i = 0; i < places[a].size; ++i)
      for (int b = 0; b < n; ++b) {
        if (const int start = starts[a * n + b]; start >= 0) {
          double* to = values + start + i * places[a].stride;
          for (int j = 0; j < places[b].size; ++j) to[j] += K[j];
        }
        K += places[b].size;
      }
  }
}

RCP<Matrix> SystemMatrix::assemble() {
  if (!ghost_.is_null()) {
    owned_->resumeFill();
    owned_->doExport(*ghost_, *exporter_, Tpetra::ADD);
    owned_->fillComplete(dofs_.owned_map(), dofs_.owned_map());
  }
  return owned_;
}

std::size_t SystemMatrix::bytes() const {
  return (n_entries(owned_) + n_entries(ghost_)) * (sizeof(double) + sizeof(int)) +
         (owned_constant_.size() + ghost_constant_.size()) * sizeof(double) +
         static_cast<std::size_t>(dofs_.n_owned()) * (sizeof(int) + sizeof(std::size_t)) +
         (first_.size() + first_start_.size()) * sizeof(std::size_t) + places_.size() * sizeof(Place) +
         starts_.size() * sizeof(int);
}

}  // namespace mortise
