#pragma once
/// Contact of the fields of shared nodes.

#include "body_contact/PairLaws.hpp"
#include "body_contact/SharedNodes.hpp"

namespace Rhegma::body_contact
{

/// Two groups at a shared node. The impulse acts on the second group, its opposite on the first.
template <int D>
struct NodalPairs
{
  View<int*> first;          ///< pairs of shared node s: first(s) .. first(s + 1) - 1
  View<int* [2]> group;      ///< the two groups, the lower number first
  View<int* [2]> row;        ///< rows of their fields
  View<double* [D]> impulse; ///< in this step [N s]; zero where the two do not press on each other
  View<double* [D]> normal;  ///< unit normal from the first to the second
  View<double*> gap;         ///< between their particles' domains along the normal; negative: overlap [m]
  int count = 0;             ///< number of pairs
};

/// What a pair of groups has exchanged in a step.
template <int D>
struct PairSums
{
  Vector<D> impulse{};     ///< on the second group [N s]
  double dissipated = 0.0; ///< kinetic energy that contact took [J]
  double friction = 0.0;   ///< the part of it that was taken along the faces [J]
  double overlap = 0.0;    ///< largest, of domains that press on each other [m]
  int closed = 0;          ///< nodes at which the two press on each other
};

/// Lists the pairs of the shared nodes.
template <int D>
void listPairs(const SharedNodes<D>& shared, NodalPairs<D>& pairs);

/// Finds the normals and gaps of the pairs from the particles at each node.
template <int D>
void findGaps(const State<D>& state, const SharedNodes<D>& shared, const NodalPairs<D>& pairs);

/// Changes the nodes' motion by impulses between the fields that touch and would move into each other.
template <int D>
void exchangeImpulses(const State<D>& state, const SharedNodes<D>& shared, const NodalPairs<D>& pairs,
                      const PairLaws& laws);

/// Sums of the pairs of two groups, or of all where `one` is below 0. The energy is that of the particles: it
/// changes by the impulse of a node times the mean of its velocities before and after the step, as the
/// particles have them.
template <int D>
PairSums<D> sumPairs(const State<D>& state, const NodalPairs<D>& pairs, int one = -1, int other = -1);

} // namespace Rhegma::body_contact
