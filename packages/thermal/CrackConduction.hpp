#pragma once
/// Heat that passes between the faces of cracks.

#include "thermal/HeatNodes.hpp"
#include "transfer/FacePoints.hpp"

#include <Teuchos_ParameterList.hpp>

namespace Rhegma
{
class Archive;
} // namespace Rhegma

namespace Rhegma::thermal
{

/// What the faces of a crack let through.
struct FaceLaw
{
  double conductance = 0.0;    ///< [W/(m2 K)]; 0: they insulate
  bool onlyWhereClosed = true; ///< nothing where the faces have parted
};

/// Conductance between the two fields of nodes next to cracks: q = h (T on side -1 - T on side +1).
///
/// A node has the area of face that its second field ends at, sum V grad N over the particles that see it,
/// along the crack's normal: with that a flux that is the same on both sides is one that no node keeps,
/// wherever the crack lies in the cells. h is the mean of the faces around the node.
///
/// Each node passes heat between its own two fields by itself, with the temperatures at the end of the step
/// (backward Euler), so that any conductance is stable: an infinite one makes the two temperatures one, which
/// is conduction without a crack. What one field gives the other gets, to round-off.
template <int D>
class CrackConduction
{
public:
  /// Reads the sublist `Crack Faces` of Thermal.
  void read(const Teuchos::ParameterList& list, const State<D>& state);

  /// Whether heat passes through some crack at all.
  bool conducts() const { return conducts_; }

  /// Finds the conductance of the nodes as the faces are now; needs the masses of the nodes. Collective.
  void update(const State<D>& state);

  /// Gives the two fields of a node in perfect contact the one temperature that the node would have without a
  /// crack: if the faces came together in the step instead, those of their particles that had the temperature
  /// of the other side already would be pushed beyond it. \param share as markMaterials has it
  void merge(const State<D>& state, const HeatNodes<D>& nodes, double fraction) const;

  /// Passes heat over dt, after the nodes have got their change by other ways.
  /// \return heat [J] that held nodes take up from outside for it
  double exchange(const State<D>& state, const HeatNodes<D>& nodes, double dt) const;

  /// Whether there are faces that conduct now.
  bool active(const State<D>& state) const
  {
    return conducts_ && conductance_.extent(0) > 0 && state.cracks.second.extent(0) > 0;
  }

  /// Between the two fields of each node of the lattice that has two [W/K]; others have none.
  const View<double*>& conductance() const { return conductance_; }

  void store(Archive& archive);

  /// Of perfect contact, in place of an infinite one [W/(m2 K)].
  static constexpr double perfect = 1e30;

  /// Parts of `update`; public because compilers for devices want kernels in public functions.
  void searchAround(const State<D>& state);
  void addFaces(const State<D>& state);
  void findConductance(const State<D>& state);

private:
  bool conducts_ = false, perfectContact_ = false;
  View<FaceLaw*> laws_; ///< of each crack
  FacePoints<D> points_;
  ObservedPoints<D> around_; ///< half a cell away from them on either side, seen without a crack
  StencilTable<D> stencils_;
  /// Of a node: area of face around it times conductance, times 1, times normal. Of a second field: where its
  /// material ends [m2], in the last columns.
  View<double * [D + 2]> faces_;
  View<double*> conductance_;
};

} // namespace Rhegma::thermal
