// Short words for what is done with Tpetra vectors all the time.
#pragma once

#include <Teuchos_CommHelpers.hpp>
#include <string>
#include <vector>

#include "assembly/tpetra.hpp"

namespace mortise {

/// The values of a vector on this rank; valid as long as the vector is.
inline double* data(Vector& v) { return v.getDataNonConst().getRawPtr(); }
inline const double* data(const Vector& v) { return v.getData().getRawPtr(); }

/// Sum, greatest, ... of each entry over all ranks; collective.
template <class T>
void all_reduce(const Comm& comm, Teuchos::EReductionType type, std::vector<T>& values) {
  const std::vector<T> local = values;
  if (!local.empty()) Teuchos::reduceAll(comm, type, static_cast<int>(local.size()), local.data(), values.data());
}

/// The same for one value.
template <class T>
T all_reduced(const Comm& comm, Teuchos::EReductionType type, T local) {
  T all{};
  Teuchos::reduceAll(comm, type, 1, &local, &all);
  return all;
}

/// The message of the first rank that has one, on all ranks; collective.
inline std::string agreed(const Comm& comm, const std::string& fault) {
  const int none = comm.getSize();
  const int rank = all_reduced(comm, Teuchos::REDUCE_MIN, fault.empty() ? none : comm.getRank());
  if (rank == none) return "";
  std::string message = fault;
  int size = static_cast<int>(message.size());
  Teuchos::broadcast(comm, rank, &size);
  message.resize(static_cast<std::size_t>(size));
  Teuchos::broadcast(comm, rank, size, message.data());
  return message;
}

}  // namespace mortise
