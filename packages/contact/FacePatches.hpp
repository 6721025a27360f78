#pragma once
/// Patches of face points, on each of which contact in equilibrium has one pressure.

#include "transfer/FacePoints.hpp"

#include <vector>

namespace Rhegma::contact
{

/// Least distance between the middles of patches, in cells. Nodes next to a crack are a cell apart: with a
/// pressure for each face point, half a cell apart, there are more constraints than motions of the faces
/// against each other, and pressures swing from point to point (Babuska, Numer. Math. 20 (1973) 179; for
/// cracks that cut cells Bechet, Moes and Wohlmuth, Int. J. Numer. Meth. Eng. 78 (2009) 931).
constexpr double patchSpacing = 3.0;

/// Most cells between two nodes of a patch, along an axis: points are less than `patchSpacing` from the
/// middle of their patch when it is made, their nodes less than a cell from them, and faces stretch by up to
/// a third before points are placed anew. Nodes farther apart are not coupled on several ranks, which takes
/// more iterations to the same equilibrium.
constexpr int mostNodesApart = 11;

/// Cosine of the largest angle between the normals of a patch's points and that of its middle.
constexpr double patchAlignment = 0.95;

/// Divides the points of each crack among patches: some points, no two of them nearer than `patchSpacing`,
/// are middles, and the others belong to the nearest middle of a like normal. \return the patch of each
/// point; patches are numbered in the order of their middles
template <int D>
std::vector<int> findPatches(const State<D>& state, const FacePoints<D>& points);

} // namespace Rhegma::contact
