#pragma once
/// Other cracks in the path of a front.

#include "state/CrackSet.hpp"

#include <vector>

namespace Rhegma::cracks
{

/// The first crack on a straight path.
struct CrackOnPath
{
  int crack = -1;      ///< -1: there is none
  double length = 0.0; ///< of the path up to it, or all of it [m]
};

/// Finds the cracks, other than the own one of a front, that straight paths come to. Faces count as they are
/// now, on the host.
template <int D>
class CracksOnPath
{
public:
  /// \param own  the crack of the front
  CracksOnPath(const CrackSet<D>& set, int own);

  /// The first of them on a path, closer than `near` to it: also one whose plane contains the path.
  /// \param from, direction, length of the path [m] \param near positive [m]
  CrackOnPath first(const Vector<D>& from, const Vector<D>& direction, double length, double near) const;

private:
  /// The nearest face to a point: its crack and distance [m].
  CrackOnPath nearest(const Vector<D>& x) const;

  struct Face
  {
    Vector<D> corner[D];
    int crack;
  };
  std::vector<Face> faces_;
};

} // namespace Rhegma::cracks
