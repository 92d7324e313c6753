#include "solve/direct_solver.hpp"

#include <dmumps_c.h>
#include <fmt/format.h>
#include <metis.h>
#include <mpi.h>

#include <Teuchos_DefaultMpiComm.hpp>
#include <Teuchos_Time.hpp>
#include <algorithm>
#include <numeric>

namespace mortise {
namespace {

MPI_Comm raw(const Comm& comm) {
  const auto* mpi = dynamic_cast<const Teuchos::MpiComm<int>*>(&comm);
  if (!mpi) return MPI_COMM_SELF;
  return *mpi->getRawMpiComm();
}

// Pairs of different groups that meet in the entries, each once per run of equal pairs.
std::vector<int> pairs_of_groups(const std::vector<int>& rows, const std::vector<int>& columns, const std::vector<int>& group) {
  std::vector<int> pairs;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const int a = group[rows[k] - 1], b = group[columns[k] - 1];
    if (a == b || (!pairs.empty() && pairs[pairs.size() - 2] == a && pairs.back() == b)) continue;
    pairs.push_back(a);
    pairs.push_back(b);
  }
  return pairs;
}

// Position of each unknown in the pivot order: nested dissection of the graph of groups.
std::vector<int> pivot_order(const std::vector<int>& pairs, const std::vector<int>& group) {
  const int n_groups = group.empty() ? 0 : *std::max_element(group.begin(), group.end()) + 1;
  std::vector<std::vector<idx_t>> near(n_groups);
  for (std::size_t k = 0; k < pairs.size(); k += 2) {
    near[pairs[k]].push_back(pairs[k + 1]);
    near[pairs[k + 1]].push_back(pairs[k]);
  }
  std::vector<idx_t> start{0}, neighbours;
  for (auto& list : near) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    neighbours.insert(neighbours.end(), list.begin(), list.end());
    start.push_back(static_cast<idx_t>(neighbours.size()));
    std::vector<idx_t>().swap(list);
  }
  std::vector<idx_t> weight(n_groups, 0), perm(n_groups), inverse(n_groups), options(METIS_NOPTIONS);
  for (int g : group) ++weight[g];
  METIS_SetDefaultOptions(options.data());
  options[METIS_OPTION_SEED] = 1;
  idx_t n = n_groups;
  METIS_NodeND(&n, start.data(), neighbours.data(), weight.data(), options.data(), perm.data(), inverse.data());
  std::vector<int> sorted(group.size());
  std::iota(sorted.begin(), sorted.end(), 0);
  std::stable_sort(sorted.begin(), sorted.end(), [&](int a, int b) { return inverse[group[a]] < inverse[group[b]]; });
  std::vector<int> position(group.size());
  for (std::size_t k = 0; k < sorted.size(); ++k) position[sorted[k]] = static_cast<int>(k) + 1;
  return position;
}

// A pivot below this, relative to the norm of the scaled matrix, is round-off. Rigid motions leave 1e-15 on 1,000 unknowns and
// 1e-11 on 20,000 (MUMPS' own limit of 1e-21 takes most of them for stiffness); the tip of a bar of 1,000 x 1 x 1 elements still
// has 5e-10.
constexpr double null_pivot = 1e-10;

}  // namespace

struct DirectSolver::Mumps {
  DMUMPS_STRUC_C id{};
  RCP<const Map> map;
  std::vector<int> group;
  MPI_Comm comm;
  int rank, n_ranks, n;
  bool central, started = false;
  long graph_number = -1, analyses = 0;
  double seconds[3] = {0, 0, 0};
  std::vector<int> rows, columns, order;  // of all entries (central: on rank 0) or of this rank's
  std::vector<double> values, rhs;
  std::vector<int> entries_of, rows_of, entries_at, rows_at;  // per rank, on rank 0
  std::vector<int> row_of;                                    // unknown (from 0) of each gathered row

  int& icntl(int k) { return id.icntl[k - 1]; }
  int infog(int k) const { return id.infog[k - 1]; }

  Mumps(const RCP<const Map>& m, std::vector<int> g, int largest_on_one_rank)
      : map(m), group(std::move(g)), comm(raw(*m->getComm())) {
    rank = m->getComm()->getRank();
    n_ranks = m->getComm()->getSize();
    n = static_cast<int>(m->getGlobalNumElements());
    central = n_ranks == 1 || n < largest_on_one_rank;
    const int mine = static_cast<int>(m->getNodeNumElements());
    rows_of.resize(n_ranks);
    MPI_Gather(&mine, 1, MPI_INT, rows_of.data(), 1, MPI_INT, 0, comm);
    rows_at.assign(n_ranks, 0);
    for (int r = 1; r < n_ranks; ++r) rows_at[r] = rows_at[r - 1] + rows_of[r - 1];
    std::vector<int> my_rows(mine);
    for (int k = 0; k < mine; ++k) my_rows[k] = static_cast<int>(m->getGlobalElement(k));
    row_of.resize(rank == 0 ? n : 0);
    MPI_Gatherv(my_rows.data(), mine, MPI_INT, row_of.data(), rows_of.data(), rows_at.data(), MPI_INT, 0, comm);
  }

  ~Mumps() { stop(); }

  bool takes_part() const { return !central || rank == 0; }

  void stop() {
    if (!started) return;
    id.job = -2;
    dmumps_c(&id);
    started = false;
  }

  void start() {
    stop();
    id = DMUMPS_STRUC_C{};
    id.comm_fortran = static_cast<MUMPS_INT>(MPI_Comm_c2f(central ? MPI_COMM_SELF : comm));
    id.par = 1;
    id.sym = 0;
    id.job = -1;
    dmumps_c(&id);
    started = true;
    for (int stream = 1; stream <= 4; ++stream) icntl(stream) = stream <= 3 ? -1 : 0;
    icntl(6) = 0;    // no permutation by values: the analysis holds for every matrix of this graph
    icntl(14) = 30;  // per cent of workspace beyond the estimate
    icntl(13) = 1;   // the last front without ScaLAPACK, which would not find its null pivots
    icntl(24) = 1;   // null pivots are found and counted instead of divided by
    id.cntl[2] = null_pivot;
  }

  // The pattern, on the rank(s) that factor.
  void take_pattern(const Matrix& A) {
    const auto local = A.getLocalMatrixHost();
    const auto row_map = A.getRowMap(), col_map = A.getColMap();
    std::vector<int> r, c;
    for (std::size_t i = 0; i < row_map->getNodeNumElements(); ++i)
      for (auto e = local.graph.row_map(i); e < local.graph.row_map(i + 1); ++e) {
        r.push_back(static_cast<int>(row_map->getGlobalElement(static_cast<int>(i))) + 1);
        c.push_back(static_cast<int>(col_map->getGlobalElement(local.graph.entries(e))) + 1);
      }
    if (!central || n_ranks == 1) {
      rows = std::move(r);
      columns = std::move(c);
      return;
    }
    const int mine = static_cast<int>(r.size());
    entries_of.resize(n_ranks);
    entries_at.assign(n_ranks, 0);
    MPI_Gather(&mine, 1, MPI_INT, entries_of.data(), 1, MPI_INT, 0, comm);
    for (int k = 1; k < n_ranks; ++k) entries_at[k] = entries_at[k - 1] + entries_of[k - 1];
    const int all = rank == 0 ? entries_at.back() + entries_of.back() : 0;
    rows.resize(all);
    columns.resize(all);
    MPI_Gatherv(r.data(), mine, MPI_INT, rows.data(), entries_of.data(), entries_at.data(), MPI_INT, 0, comm);
    MPI_Gatherv(c.data(), mine, MPI_INT, columns.data(), entries_of.data(), entries_at.data(), MPI_INT, 0, comm);
  }

  void take_values(const Matrix& A) {
    const auto local = A.getLocalMatrixHost();
    const int mine = static_cast<int>(local.values.extent(0));
    if (!central || n_ranks == 1) {
      values.assign(local.values.data(), local.values.data() + mine);
      return;
    }
    values.resize(rows.size());
    MPI_Gatherv(local.values.data(), mine, MPI_DOUBLE, values.data(), entries_of.data(), entries_at.data(), MPI_DOUBLE, 0, comm);
  }

  std::vector<int> gathered(const std::vector<int>& mine) const {  // on rank 0, in the order of ranks
    const int size = static_cast<int>(mine.size());
    std::vector<int> sizes(n_ranks), at(n_ranks, 0);
    MPI_Gather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, 0, comm);
    for (int r = 1; r < n_ranks; ++r) at[r] = at[r - 1] + sizes[r - 1];
    std::vector<int> all(rank == 0 ? at.back() + sizes.back() : 0);
    MPI_Gatherv(mine.data(), size, MPI_INT, all.data(), sizes.data(), at.data(), MPI_INT, 0, comm);
    return all;
  }

  void run(int job, double& clock) {
    const double begin = Teuchos::Time::wallTime();
    if (takes_part()) {
      id.job = job;
      dmumps_c(&id);
    }
    clock += Teuchos::Time::wallTime() - begin;
    MPI_Bcast(id.infog, sizeof(id.infog) / sizeof(id.infog[0]), MPI_INT, 0, comm);
  }

  void point_at_entries() {
    if (central) {
      id.nnz = static_cast<MUMPS_INT8>(rows.size());
      id.irn = rows.data();
      id.jcn = columns.data();
      id.a = values.data();
    } else {
      id.nnz_loc = static_cast<MUMPS_INT8>(rows.size());
      id.irn_loc = rows.data();
      id.jcn_loc = columns.data();
      id.a_loc = values.data();
    }
  }

  void analyse(const Matrix& A) {
    take_pattern(A);
    std::vector<int> pairs = pairs_of_groups(rows, columns, group);
    if (!central) pairs = gathered(pairs);
    if (rank == 0) order = pivot_order(pairs, group);
    if (takes_part()) {
      start();
      id.n = n;
      icntl(18) = central ? 0 : 3;
      icntl(7) = 1;
      id.perm_in = order.data();
    }
    point_at_entries();
    run(1, seconds[0]);
    ++analyses;
  }
};

DirectSolver::DirectSolver(const RCP<const Map>& map, std::vector<int> group, int largest_on_one_rank)
    : mumps_(std::make_unique<Mumps>(map, std::move(group), largest_on_one_rank)) {}
DirectSolver::~DirectSolver() = default;
DirectSolver::DirectSolver(DirectSolver&&) noexcept = default;

LinearReport DirectSolver::solve(const Matrix& A, const Vector& b, Vector& x, long graph_number) {
  const LinearReport factored = factor(A, graph_number);
  return factored.solved ? solve(b, x) : factored;
}

LinearReport DirectSolver::factor(const Matrix& A, long graph_number) {
  Mumps& m = *mumps_;
  LinearReport report;
  if (graph_number != m.graph_number) {
    m.analyse(A);
    m.graph_number = graph_number;
    if (m.infog(1) < 0) {
      m.graph_number = -1;
      report.cause = fmt::format("MUMPS could not analyse the matrix (error {}, {})", m.infog(1), m.infog(2));
      return report;
    }
  }
  m.take_values(A);
  m.point_at_entries();
  for (int attempt = 0; attempt < 6; ++attempt) {
    m.run(2, m.seconds[1]);
    if (m.infog(1) != -9 && m.infog(1) != -8) break;
    if (m.takes_part()) m.icntl(14) = 2 * m.icntl(14) + 20;
  }
  if (m.infog(1) < 0) {
    report.cause = m.infog(1) == -10 ? "the tangent is singular"
                                     : fmt::format("MUMPS could not factor the matrix (error {}, {})", m.infog(1), m.infog(2));
    return report;
  }
  report.null_pivots = m.infog(28);
  if (report.null_pivots > 0) {
    report.cause = fmt::format("the tangent is singular: {} null pivots", report.null_pivots);
    return report;
  }
  report.solved = true;
  return report;
}

LinearReport DirectSolver::solve(const Vector& b, Vector& x) {
  Mumps& m = *mumps_;
  LinearReport report;
  const auto b_mine = b.getData();
  std::vector<double> gathered(m.rank == 0 ? m.n : 0);
  const int mine = static_cast<int>(b_mine.size());
  MPI_Gatherv(b_mine.getRawPtr(), mine, MPI_DOUBLE, gathered.data(), m.rows_of.data(), m.rows_at.data(), MPI_DOUBLE, 0, m.comm);
  m.rhs.resize(m.rank == 0 ? m.n : 0);
  for (std::size_t k = 0; k < gathered.size(); ++k) m.rhs[m.row_of[k]] = gathered[k];
  m.id.rhs = m.rhs.data();
  m.id.nrhs = 1;
  m.id.lrhs = m.n;
  m.run(3, m.seconds[2]);
  if (m.infog(1) < 0) {
    report.cause = fmt::format("MUMPS could not solve (error {}, {})", m.infog(1), m.infog(2));
    return report;
  }
  for (std::size_t k = 0; k < gathered.size(); ++k) gathered[k] = m.rhs[m.row_of[k]];
  auto x_mine = x.getDataNonConst();
  MPI_Scatterv(gathered.data(), m.rows_of.data(), m.rows_at.data(), MPI_DOUBLE, x_mine.getRawPtr(), mine, MPI_DOUBLE, 0, m.comm);
  report.solved = true;
  return report;
}

long DirectSolver::analyses() const { return mumps_->analyses; }
double DirectSolver::factor_entries() const { return mumps_->infog(29) < 0 ? -1e6 * mumps_->infog(29) : mumps_->infog(29); }
double DirectSolver::seconds_analysis() const { return mumps_->seconds[0]; }
double DirectSolver::seconds_factor() const { return mumps_->seconds[1]; }
double DirectSolver::seconds_solve() const { return mumps_->seconds[2]; }

}  // namespace mortise
