#pragma once
/// The fields of one time on the host, as written to the file.

#include "state/State.hpp"

#include <string>
#include <vector>

namespace Rhegma
{

/// A table of a mesh: (rows, columns) row by row.
struct DataSet
{
  enum class Role
  {
    Points,
    Cells,
    OnPoints,
    OnCells
  };

  std::string name;
  Role role = Role::OnPoints;
  int columns = 1;
  bool integer = false;
  std::vector<double> real;
  std::vector<int> whole;
  std::size_t before = 0; ///< rows of ranks before this one
  std::size_t others = 0; ///< rows of all other ranks

  /// Rows here.
  std::size_t rows() const { return (integer ? whole.size() : real.size()) / columns; }
  /// Rows of the table in the file.
  std::size_t rowsOfAll() const { return rows() + others; }
};

/// Points, cells and their data; each mesh has one table of points and one of cells.
struct OutputMesh
{
  std::string name;
  std::string topology; ///< XDMF's name for the kind of cell
  std::vector<DataSet> data;
  bool onAllRanks = false; ///< each rank has all of it
};

struct Snapshot
{
  double time = 0.0; ///< [s]
  std::vector<OutputMesh> meshes;
};

/// Fields of particles that are written on request; a run without mechanics has none of them.
struct RequestedFields
{
  bool principalStress = false; ///< largest principal Cauchy stress [Pa]
  bool energyDensity = false;   ///< elastic energy per undeformed volume [J/m3]
  bool damage = false;          ///< damage of the law, where a law of the run has one
  bool stateVariables = false;  ///< state variables of laws of shared libraries (LawStates.hpp)
};

/// Particles, leaves and, where there are any, cracks as they are now; FieldWriter.hpp lists the tables.
template <int D>
Snapshot makeSnapshot(const State<D>& state, const RequestedFields& requested = {});

/// The meshes of a rank as parts of those of all, in the order of the ranks: cells name points of the whole.
/// Cells at borders between ranks, and their points, may occur twice. Data that all ranks have are written by
/// the first. Collective.
Snapshot partOfAll(const Ranks& ranks, Snapshot own);

} // namespace Rhegma
