#pragma once
/// Heat that passes between the faces of cracks.

#include "thermal/HeatNodes.hpp"
#include "transfer/FacePoints.hpp"

#include <Teuchos_ParameterList.hpp>

#include <vector>

namespace Rhegma
{
class Archive;
} // namespace Rhegma

namespace Rhegma::thermal
{

/// The conductance of the faces of a crack.
struct FaceLaw
{
  double conductance = 0.0;    ///< [W/(m2 K)]; 0: they insulate
  bool onlyWhereClosed = true; ///< no heat where the faces are open
};

/// Conductance between the two fields of nodes next to cracks: q = h (T on side -1 - T on side +1).
///
/// The face area of a node is that at which its enriched field ends, sum V grad N over the particles on it,
/// along the crack's normal: with this area a uniform flux through the crack leaves no heat on nodes, for any
/// position of the crack in the cells. h is the mean of the faces around the node.
///
/// Each node passes heat between its own two fields by itself, with the temperatures at the end of the step
/// (backward Euler), so that any conductance is stable: an infinite one makes the two temperatures one, which
/// is conduction without a crack. Heat is conserved to round-off.
///
/// Nodes just ahead of a front and behind it, whose fields springs join (FrontSprings.hpp), pass heat as far
/// as the cells there are not cut: the conductance is k b times CrackSet::frontConductance, k the mean
/// conductivity around the node and b the thickness times the fraction of the lesser field, so that the
/// insulating crack of the cells ends at the front.
template <int D>
class CrackConduction
{
public:
  /// Reads the sublist `Crack Faces` of Thermal.
  void read(const Teuchos::ParameterList& list, const State<D>& state);

  /// Not 0 for the cracks whose faces never conduct. \return of all cracks
  std::vector<char> insulating() const;

  /// Finds the conductance of the nodes as the faces are now; needs the capacities of the nodes. Collective.
  void update(const State<D>& state, const HeatNodes<D>& nodes);

  /// Gives the two fields of a node in perfect contact the one temperature that the node would have without a
  /// crack: if the temperatures met during the step instead, particles that already have the temperature of
  /// the other side would be changed beyond it. \param fraction as in markMaterials
  void merge(const State<D>& state, const HeatNodes<D>& nodes, double fraction) const;

  /// Passes heat over dt, after all other changes of the nodes. \return heat [J] that held nodes take up from
  /// outside for it
  double exchange(const State<D>& state, const HeatNodes<D>& nodes, double dt) const;

  /// Whether some nodes pass heat between their fields now.
  bool active(const State<D>& state) const
  {
    return (conducts_ || state.cracks.frontConductance.extent(0) > 0) && conductance_.extent(0) > 0 &&
           state.cracks.enrichedField.extent(0) > 0;
  }

  /// Between the two fields of each node of the lattice that has two [W/K]; others have none.
  const View<double*>& conductance() const { return conductance_; }

  void serialize(Archive& archive);

  /// Of perfect contact, in place of an infinite one [W/(m2 K)].
  static constexpr double perfect = 1e30;

  /// Parts of `update`; public because compilers for devices want kernels in public functions.
  void searchAround(const State<D>& state);
  void addFaces(const State<D>& state);
  void findConductance(const State<D>& state);
  void ofFaces(const State<D>& state);
  void ofFronts(const State<D>& state, const HeatNodes<D>& nodes);

private:
  bool conducts_ = false, perfectContact_ = false;
  View<FaceLaw*> laws_; ///< of each crack
  FacePoints<D> points_;
  ObservedPoints<D> around_; ///< half a cell away from them on either side, seen without a crack
  StencilTable<D> stencils_;
  /// Of a node: area of face around it times conductance, times 1, times normal. Of an enriched field: where
  /// its material ends [m2], in the last columns.
  View<double * [D + 2]> faces_;
  View<double*> conductance_;
  View<double* [2]> aroundNode_; ///< of a node: volume, and volume times conductivity, of what lies around it
};

} // namespace Rhegma::thermal
