#pragma once
/// On which side of a crack a position lies.

#include "state/CrackSet.hpp"

#include <vector>

namespace Rhegma::energy_release
{

/// A crack of a 2D scene as seen from one of its fronts; ahead of the front it goes straight on.
class CrackSide
{
public:
  CrackSide(const CrackSet<2>& cracks, const CrackFront<2>& front);

  /// -1 or +1.
  int side(const Vector<2>& x) const;

private:
  struct Segment
  {
    Vector<2> begin, end;
  };
  std::vector<Segment> segments_;
  CrackFront<2> front_;
  double orientation_ = 1.0; ///< 1 where side +1 is left of the segments
};

} // namespace Rhegma::energy_release
