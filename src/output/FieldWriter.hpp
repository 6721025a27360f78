#pragma once
/// fields.h5 and fields.xdmf: particles, leaves and cracks in time, for ParaView.

#include "output/Snapshot.hpp"

#include <memory>
#include <string>

namespace Rhegma
{

class Archive;

/// Writes the fields of a run, a group of fields.h5 per time: /t00000, /t00001, ..., with attribute `time`
/// [s].
///
///     particles/  position, displacement [m], velocity [m/s] (n,3); stress (n,6) Cauchy xx yy zz xy yz xz
///     [Pa];
///                 von_mises (n) [Pa]; mass (n) [kg]; edge (n) first undeformed edge [m]; deformation (n,9) F
///                 row by row; edges (n,9) undeformed edge vectors one after another [m]; body, material (n)
///                 int; the fields of effects under their names with _ for spaces; on request
///                 principal_stress (n) [Pa], energy_density (n) [J/m3], damage (n) from 0 to 1,
///                 state_1 (n), state_2 (n), ... of laws of shared libraries
///     leaves/     points (m,3), cells (k,4 or 8): the cells that hold particles
///     tools/      points (t,3), cells (u,2 or 3) of the surfaces of rigid tools, tool (u) number of the tool
///                 of each cell; only where there are tools
///     cracks/     points (v,3) midway between the faces, opening (v,3) from face -1 to face +1 [m],
///                 cells (s,2 or 3), crack (s) number of the crack of each cell; only where there are cracks
///
/// 2D is padded with z = 0. fields.h5 is closed after every time, so that it can be read during the run and a
/// kill leaves the written times; fields.xdmf is replaced completely.
template <int D>
class FieldWriter
{
public:
  /// Makes both files; older ones are replaced. \param folder must exist \param ranks of the run; each writes
  /// its part, and all calls are collective Throws OutputError when the files can't be made or written, here
  /// and later.
  explicit FieldWriter(const std::string& folder, const Ranks& ranks = {});
  /// Continues the files of a run whose checkpoint the archive loads; later times are removed. Throws
  /// OutputError when they are not those of the run. Collective.
  FieldWriter(const std::string& folder, Archive& archive);
  ~FieldWriter();
  FieldWriter(FieldWriter&&) noexcept;
  FieldWriter& operator=(FieldWriter&&) noexcept;

  /// Adds the current fields. A time that was just written is not written again.
  /// \param requested fields that only some runs write
  void write(const State<D>& state, const RequestedFields& requested = {});

  /// Saves the times of the files.
  void serialize(Archive& archive);

  /// Synchronises the files to the disk.
  void sync() const;

private:
  class Files;
  std::unique_ptr<Files> files_;
  double lastTime_ = -1.0;
};

} // namespace Rhegma
