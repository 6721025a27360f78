#pragma once
/// Heat that passes from gas to the faces of cracks.

#include "transfer/FacePoints.hpp"

namespace Rhegma::combustion
{

/// What heats the faces at each face point over a step.
struct FaceHeating
{
  View<double*> given;          ///< to each of the two faces [J/m2]
  View<double*> conductance;    ///< h dt, between gas and each of the two faces [J/(m2 K)]
  View<double*> gasTemperature; ///< [K]
};

/// Adds heat to the nodes of the faces; their change of temperature goes to the particles, as with
/// conduction: a particle's heat changes by rho c V sum N dT. A node has the capacity of the particles with
/// stored stencils that see it, and is heated by the gas as a body of uniform temperature is, T -> T_gas -
/// (T_gas - T) exp(-H / C), so that any conductance is stable and no node passes the gas. The heat from the
/// gas equals the heat to the particles, to round-off.
///
/// Nodes of several ranks sum over these.
template <int D>
class FaceHeat
{
public:
  /// Finds the temperatures of nodes and faces. To be called while the stencils are those of the step.
  /// Collective.
  void measure(const State<D>& state, const FacePoints<D>& points);

  /// Of the faces at each point, below and above [K]; 0 where a face has no nodes. All ranks have all.
  const View<double* [2]>& temperature() const { return atFaces_; }

  /// Heats the faces of a crack after `measure`; records it under `heat`. Collective. \param heatToFaces heat
  /// that both faces take at each point, of all ranks [J]
  void give(State<D>& state, const FacePoints<D>& points, int crack, const FaceHeating& heating,
            const View<double*>& heatToFaces);

  // Public because compilers for devices want kernels in public functions.
  void clear(const State<D>& state) const;
  void weigh(const State<D>& state) const;
  void findTemperatures(const State<D>& state) const;
  void checkFaces(const State<D>& state, const FacePoints<D>& points) const;
  void sumDemand(const State<D>& state, const FacePoints<D>& points, int crack,
                 const FaceHeating& heating) const;
  void change(const State<D>& state) const;
  void charge(const State<D>& state, const FacePoints<D>& points, int crack, const FaceHeating& heating,
              const View<double*>& heatToFaces) const;
  double toParticles(State<D>& state) const;

private:
  /// Of each node: capacity [J/K], heat [J] and its moments [J/m] as in packages/thermal, then temperature
  /// [K].
  View<double * [D + 3]> nodes_;
  static constexpr int capacityAt = 0, heatAt = 1, momentAt = 2, temperatureAt = D + 2;
  /// Of each node: H [J/K], H T_gas [J], heat that is supplied [J]; then fraction of H that acts [-], change
  /// of temperature [K].
  View<double* [5]> demand_;
  static constexpr int fractionAt = 3, changeAt = 4;
  View<double* [2]> atFaces_;
};

} // namespace Rhegma::combustion
