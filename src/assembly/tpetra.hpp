// The Tpetra types of the program: one scalar, one pair of ordinals.
#pragma once

#include <Teuchos_Comm.hpp>
#include <Teuchos_RCP.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Export.hpp>
#include <Tpetra_Import.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_Vector.hpp>

namespace mortise {

using GlobalIndex = long long;
using Map = Tpetra::Map<int, GlobalIndex>;
using Vector = Tpetra::Vector<double, int, GlobalIndex>;
using Matrix = Tpetra::CrsMatrix<double, int, GlobalIndex>;
using Graph = Tpetra::CrsGraph<int, GlobalIndex>;
using Import = Tpetra::Import<int, GlobalIndex>;
using Export = Tpetra::Export<int, GlobalIndex>;
using Comm = Teuchos::Comm<int>;
template <class T>
using RCP = Teuchos::RCP<T>;

}  // namespace mortise
