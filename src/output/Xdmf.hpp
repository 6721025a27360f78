#pragma once
/// The XML next to an HDF5 file that tells ParaView what is in it.

#include "output/Snapshot.hpp"

#include <string>
#include <utility>
#include <vector>

namespace Rhegma
{

class Archive;

/// Grows by a time after another. Each kind of mesh is a temporal collection of its own: readers give
/// repeated names inside one collection a number that changes with time, and blocks chosen by name would be
/// lost.
class XdmfDocument
{
public:
  /// \param file name of the HDF5 file, next to the XDMF file
  explicit XdmfDocument(std::string file) : file_(std::move(file)) {}

  /// Adds the meshes of a time. \param group in which the snapshot lies
  void add(const Snapshot& snapshot, const std::string& group);

  std::string text() const;

  void keep(Archive& archive);

private:
  struct Collection
  {
    std::string name;
    std::string grids;
  };

  std::string file_;
  std::vector<Collection> collections_;
};

} // namespace Rhegma
