#pragma once
/// Solid that turns into gas.

#include "transfer/FacePoints.hpp"

#include <string>

namespace Rhegma::combustion
{

/// Mass that a particle has lost to gas over its remaining mass: like all quantities per undeformed volume,
/// the mean over the volumes of its parts is that of the whole.
inline const std::string burntOverLeft = "burnt over remaining mass";

/// No particle loses more than this fraction of its mass, so that its nodes keep a mass.
constexpr double mostBurnt = 0.9;

/// The mass that particles next to burning faces lose.
///
/// A face that recedes by r dt demands the mass rho r dt A of its nodes, which distribute the demand among
/// the particles with a stored stencil on them, by their mass on the node: the mass of the gas is that lost
/// by the particles, to round-off. Demand and mass of nodes of several ranks are summed over these. A
/// particle loses undeformed volume as it loses mass, and keeps its velocity, deformation and stress.
template <int D>
class Regression
{
public:
  /// What was lost: mass [kg], all energy with it, and the part of it that is heat above `coldest` [J].
  struct Loss
  {
    double mass = 0.0;
    double energy = 0.0;
    double heat = 0.0;
  };

  /// Finds the mass that each particle loses in this step. To be called while stencils and nodal masses are
  /// those of the step. Collective. \param depth density times the depth that burns, of each face point
  /// [kg/m2] \return the mass that the particles of this rank will lose [kg]
  double computeLoss(const State<D>& state, const FacePoints<D>& points, int crack,
                     const View<double*>& depth);

  /// Removes it from the particles. To be called in the same step, once for each call of `computeLoss`.
  /// \param coldest temperature from which heat counts, where there is any [K] \return what the particles of
  /// this rank lost
  Loss apply(State<D>& state, double coldest);

  // Public because compilers for devices want kernels in public functions.
  void clear(const State<D>& state);
  void clearTouched(const State<D>& state, const FacePoints<D>& points);
  void demand(const State<D>& state, const FacePoints<D>& points, int crack, const View<double*>& depth);
  void findGivers(const State<D>& state);
  void weighNodes(const State<D>& state);
  double fraction(const State<D>& state);

private:
  View<double*> demand_;  ///< of each node [kg]; on one rank zero between calls
  View<double*> present_; ///< mass of these particles on each node with a demand [kg]; likewise
  View<int*> giver_;      ///< rows of the stored stencils that touch such a node
  int givers_ = 0;        ///< how many of them
  View<double*> loss_;    ///< of each giver, as a fraction of its mass
};

} // namespace Rhegma::combustion
