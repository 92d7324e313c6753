#include "solve/block_split.hpp"

namespace mortise {
namespace {

RCP<const Map> map_of(const std::vector<GlobalIndex>& numbers, const RCP<const Comm>& comm) {
  const auto invalid = Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid();
  return Teuchos::rcp(new Map(invalid, Teuchos::ArrayView<const GlobalIndex>(numbers.data(), numbers.size()), 0, comm));
}

}  // namespace

BlockSplit::BlockSplit(const RCP<const Map>& map, GlobalIndex n_positions) : n_positions_(n_positions) {
  n_pressures_ = static_cast<GlobalIndex>(map->getGlobalNumElements()) - n_positions;
  std::array<std::vector<GlobalIndex>, 2> numbers;
  for (int i = 0; i < static_cast<int>(map->getNodeNumElements()); ++i) {
    const GlobalIndex number = map->getGlobalElement(i);
    const int part = number < n_positions ? 0 : 1;
    rows_[part].push_back(i);
    numbers[part].push_back(number);
  }
  for (int part : {0, 1}) maps_[part] = map_of(numbers[part], map->getComm());
}

bool BlockSplit::take(const Matrix& A) {
  const bool is_new = graph_ != A.getCrsGraph();
  if (is_new) take_graph(A);
  const auto values = A.getLocalMatrixHost().values;
  for (auto& row : blocks_)
    for (auto& block : row)
      for (std::size_t e = 0; e < block.source.size(); ++e) block.values(e) = values(block.source[e]);
  return is_new;
}

void BlockSplit::take_graph(const Matrix& A) {
  graph_ = A.getCrsGraph();
  const auto columns = A.getColMap();
  const int n_columns = static_cast<int>(columns->getNodeNumElements());
  std::vector<int> part_of(n_columns), index_of(n_columns);
  std::array<std::vector<GlobalIndex>, 2> numbers;
  for (int j = 0; j < n_columns; ++j) {
    const GlobalIndex number = columns->getGlobalElement(j);
    part_of[j] = number < n_positions_ ? 0 : 1;
    index_of[j] = static_cast<int>(numbers[part_of[j]].size());
    numbers[part_of[j]].push_back(number);
  }
  const std::array<RCP<const Map>, 2> column_maps{map_of(numbers[0], columns->getComm()), map_of(numbers[1], columns->getComm())};

  using LocalMatrix = Matrix::local_matrix_device_type;
  const auto local = A.getLocalMatrixHost();
  for (int r : {0, 1})
    for (int c : {0, 1}) {
      Block& block = blocks_[r][c];
      const int n_rows = static_cast<int>(rows_[r].size());
      LocalMatrix::row_map_type::non_const_type row_start("row start", n_rows + 1);
      std::vector<int> found;
      block.source.clear();
      for (int i = 0; i < n_rows; ++i) {
        for (auto e = local.graph.row_map(rows_[r][i]); e < local.graph.row_map(rows_[r][i] + 1); ++e) {
          const int j = local.graph.entries(e);
          if (part_of[j] != c) continue;
          found.push_back(index_of[j]);
          block.source.push_back(e);
        }
        row_start(i + 1) = block.source.size();
      }
      LocalMatrix::index_type entries("columns", found.size());
      std::copy(found.begin(), found.end(), entries.data());
      LocalMatrix::values_type values("values", found.size());
      block.values = values;
      const LocalMatrix part("block", n_rows, static_cast<int>(numbers[c].size()), found.size(), values, row_start, entries);
      block.matrix = Teuchos::rcp(new Matrix(part, maps_[r], column_maps[c], maps_[c], maps_[r]));
    }
}

void BlockSplit::restrict_to(int part, const Vector& whole, Vector& v) const {
  const auto from = whole.getData();
  auto to = v.getDataNonConst();
  for (std::size_t k = 0; k < rows_[part].size(); ++k) to[k] = from[rows_[part][k]];
}

void BlockSplit::extend(int part, const Vector& v, Vector& whole) const {
  const auto from = v.getData();
  auto to = whole.getDataNonConst();
  for (std::size_t k = 0; k < rows_[part].size(); ++k) to[rows_[part][k]] = from[k];
}

}  // namespace mortise
