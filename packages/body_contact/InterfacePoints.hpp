#pragma once
/// Points along interfaces that join two bodies by springs.

#include "body_contact/NodalContact.hpp"

#include <Teuchos_ParameterList.hpp>

#include <vector>

namespace Rhegma
{
class Archive;
}

namespace Rhegma::body_contact
{

/// Points on the faces of two groups that touch at the start, an eighth of a cell apart or less, up to a
/// quarter on surfaces that are gathered from pieces (Geometry::Pieces). Each has a displacement jump, the
/// integral of the jump of the velocity that strains the two bodies, and a traction on either of them, equal
/// and opposite. The forces on nodes are those whose work is that of the tractions, so that the springs
/// neither create nor dissipate energy but by the length of the step.
template <int D>
struct InterfacePoints
{
  View<int* [2]> group;        ///< numbers of the two groups, the lower one first
  View<double*> area;          ///< undeformed [m2]
  View<double* [2]> stiffness; ///< along the normal, and along the faces [Pa/m]
  View<double* [D]> position;  ///< midway between the two faces [m]
  View<double* [D]> normal;    ///< unit vector across the faces; turns with them
  View<double* [D]>
      jump;            ///< displacement of the second group less that of the first [m]; turns with the normal
  View<int*> released; ///< not 0 once no node is common to both groups, so that no force acts any more
  StencilTable<D> table; ///< linear functions of the cell at common nodes, renormalised; node: the pair there
  int count = 0;         ///< number of points
};

/// Finds the points of all pairs with an interface. Throws std::invalid_argument, with the path of the pair,
/// where its bodies do not touch. \param scene validated
template <int D>
InterfacePoints<D> placeInterfaces(const Teuchos::ParameterList& scene, const std::vector<NamedPair>& named,
                                   const BondedGroups& groups, const State<D>& state);

/// Makes the stencils of the points, marks the pairs of nodes that they join or that are next to those, and
/// sums forces and stiffness of the springs there.
template <int D>
void sumSprings(const State<D>& state, const SharedNodes<D>& shared, NodalPairs<D>& pairs,
                const InterfacePoints<D>& points);

/// Releases all points: no node is common to any two groups, so that none has a stencil.
template <int D>
void releaseInterfaces(const InterfacePoints<D>& points);

/// Moves the points with the velocity that strains the bodies: positions, normals and jumps.
template <int D>
void moveInterfaces(const State<D>& state, const NodalPairs<D>& pairs, const InterfacePoints<D>& points);

/// Elastic energy of the points of two groups that still act, or of all where `one` is below 0 [J].
template <int D>
double energyOfInterfaces(const InterfacePoints<D>& points, int one = -1, int other = -1);

/// Saves or loads what changes during a run.
template <int D>
void serialize(InterfacePoints<D>& points, Archive& archive);

} // namespace Rhegma::body_contact
