#pragma once
/// The state of burning cracks that lasts from step to step.

#include "combustion/Burning.hpp"
#include "combustion/FaceHeat.hpp"
#include "combustion/Meeting.hpp"
#include "combustion/Regression.hpp"

#include <vector>

namespace Rhegma::combustion
{

/// Largest change of the gas and of its volume in a step, as a fraction.
constexpr double largestChange = 0.1;

template <int D>
struct BurnState
{
  std::vector<Burning<D>> cracks;
  FacePoints<D> points;
  Fire<D> fire;
  Regression<D> regression;
  FaceHeat<D> heat;
  FaceHeating heating;           ///< at each face point
  View<double*> depth;           ///< density times the depth that burns in a step, at each face point [kg/m2]
  View<double*> heatToFaces;     ///< heat that the faces take there [J]
  View<double*> pressure;        ///< that the faces feel there, where gas flows [Pa]
  View<double*> swept;           ///< volume that opens there in a step [m3]
  double startMass = 0.0;        ///< of the particles [kg]
  int endedFronts = 0;           ///< as last seen
  std::vector<Meeting> meetings; ///< of cracks that have ended on others

  /// Updates the face points and resizes the fields on them.
  void update(const State<D>& state)
  {
    const bool anew = points.update(state);
    fire.update(points, anew);
    const std::size_t count = points.count();
    if (depth.extent(0) == count)
      return;
    for (View<double*>* field : {&depth, &heatToFaces, &pressure, &swept, &heating.given,
                                 &heating.conductance, &heating.gasTemperature})
      *field = View<double*>("rhegma::combustion::atFacePoints", count);
  }
};

} // namespace Rhegma::combustion
