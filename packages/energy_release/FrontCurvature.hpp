#pragma once
/// How a front bends in the surface of its crack.

#include "energy_release/FrontLine.hpp"

namespace Rhegma::energy_release
{

/// By how much the directions of neighbouring front nodes diverge over the length between them [1/m]: 1 / a
/// for a disk of radius a, positive where an advance makes the front longer; zero for a straight front.
class FrontCurvature
{
public:
  explicit FrontCurvature(const FrontLine& line);

  /// At a position on the front, interpolated between front nodes [1/m]. \param onLine the line of the front
  /// \param arc length of that line up to the position [m]
  double at(int onLine, double arc) const;

private:
  struct Node
  {
    double arc, curvature;
  };
  std::vector<std::vector<Node>> lines_; ///< the nodes of each line, in their order
  std::vector<double> loop_;             ///< of each line: its length if it is closed, else 0 [m]
};

} // namespace Rhegma::energy_release
