#pragma once
/// The XML file that describes the content of an HDF5 file to ParaView.

#include "output/Snapshot.hpp"

#include <string>
#include <utility>
#include <vector>

namespace Rhegma
{

class Archive;

/// The document grows with each time. Each kind of mesh is a separate temporal collection: readers append a
/// number that changes with time to repeated names within one collection, and blocks selected by name would
/// be lost.
class XdmfDocument
{
public:
  /// \param file name of the HDF5 file, next to the XDMF file
  explicit XdmfDocument(std::string file) : file_(std::move(file)) {}

  /// Adds the meshes of a time. \param group in which the snapshot lies
  void add(const Snapshot& snapshot, const std::string& group);

  std::string text() const;

  void serialize(Archive& archive);

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
