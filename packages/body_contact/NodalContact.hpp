#pragma once
/// Contact of the fields of shared nodes.

#include "body_contact/PairLaws.hpp"
#include "body_contact/SharedNodes.hpp"

namespace Rhegma::body_contact
{

/// Springs of interfaces between the fields of pairs, in this step. Empty views: there are no interfaces.
template <int D>
struct NodalSprings
{
  View<int*> joins;               ///< of each pair: not 0 where an interface takes the place of contact
  View<double* [D]> force;        ///< of the stretched springs, on the first of the two fields [N]
  View<double* [D]> normal;       ///< area times normal, summed over points [m2]
  View<double* [D][D]> stiffness; ///< derivative of the force with respect to the jump [N/m]

  /// Whether an interface joins the fields of pair q.
  KOKKOS_INLINE_FUNCTION bool join(int q) const { return joins.extent(0) > 0 && joins(q) != 0; }
};

/// Two fields of different groups at a shared node. The impulse acts on that of the second group, its
/// opposite on the other. Two groups have two such pairs where one of them has two fields next to a crack.
template <int D>
struct NodalPairs
{
  View<int*> first;          ///< pairs of shared node s: first(s) .. first(s + 1) - 1
  View<int* [2]> group;      ///< the two groups, the lower number first
  View<int* [2]> row;        ///< rows of their fields
  View<int*> node;           ///< at which they are
  View<double* [D]> impulse; ///< in this step [N s]; zero where the two do not press on each other
  View<double* [D]> normal;  ///< unit normal from the first to the second, along axes that no support holds
  View<double*> gap;         ///< between their particles' domains along the normal; negative: overlap [m]
  /// What the projection loses of the two fields' velocity relative to `aim`, along the normal and along the
  /// faces, as a fraction: 1 where they move alike.
  View<double* [2]> loses;
  View<double* [D]> aim; ///< relative velocity that the impulse aims at; zero in contact [m/s]
  NodalSprings<D> springs;
  View<double* [2]> taken; ///< energy that contact takes in this step, and the part of it along the faces [J]
  /// Heat by friction, and heat that passes from the first to the second, in this step [J]; empty where
  /// particles have no temperature.
  View<double* [2]> heat;
  int count = 0; ///< number of pairs
};

/// What a pair of groups has exchanged in a step.
template <int D>
struct PairSums
{
  Vector<D> impulse{};     ///< on the second group [N s]
  double dissipated = 0.0; ///< kinetic energy that contact took [J]
  double friction = 0.0;   ///< the part of it along the faces [J]
  double heated = 0.0;     ///< the part of that which became heat of the bodies [J]
  double passed = 0.0;     ///< heat that passed from the first to the second [J]
  double overlap = 0.0;    ///< largest, of domains that press on each other [m]
  int closed = 0;          ///< nodes at which the two press on each other
};

/// Lists the pairs of the shared nodes.
template <int D>
void listPairs(const SharedNodes<D>& shared, NodalPairs<D>& pairs);

/// Finds the normals and gaps of the pairs from the particles at each node.
template <int D>
void findGaps(const State<D>& state, const SharedNodes<D>& shared, const NodalPairs<D>& pairs);

/// Changes the nodes' motion by impulses between the fields that touch and would move into each other, and
/// records them, the normal along free axes and how the projection joins the two. Springs of interfaces act
/// as impulses, too, at an end of the step that their stiffness chooses.
template <int D>
void exchangeImpulses(const State<D>& state, const SharedNodes<D>& shared, const NodalPairs<D>& pairs,
                      const PairLaws& laws);

/// Gives the fields that press on each other the same velocity along the normal in the projection that
/// strains the particles, and along the faces too where they stick. Finds the energy that contact takes: the
/// particles' kinetic energy changes by the impulse of a node times the mean of its velocities before and
/// after the step, as the particles have them, and the work of all other forces by the change of the
/// projection.
///
/// Without this change the strain would follow velocities in which the fields move into or away from each
/// other, while forces act as if they did not. That pair is not adjoint, and feeds oscillations: bars of
/// impedances 1 and 2 that met a tenth of a cell beyond a row of nodes gained 8 % of their energy.
template <int D>
void joinProjection(const State<D>& state, const SharedNodes<D>& shared, const NodalPairs<D>& pairs);

/// Sums of the pairs of two groups, or of all where `one` is below 0.
template <int D>
PairSums<D> sumPairs(const NodalPairs<D>& pairs, int one = -1, int other = -1);

} // namespace Rhegma::body_contact
