#pragma once
/// Heat sources in the volume.

#include "scene/TimeFunction.hpp"
#include "state/State.hpp"

#include <Teuchos_ParameterList.hpp>

#include <string>
#include <vector>

namespace Rhegma::thermal
{

/// Heat that is released in a box at rest, or in a disk (2D) or ball (3D) that may move.
template <int D>
struct Source
{
  std::string name;
  bool ball = false;
  Vector<D> lower{}, upper{}; ///< corners of the box [m]
  Vector<D> centre{};         ///< of the ball at time 0 [m]
  Vector<D> velocity{};       ///< of the ball [m/s]
  double radius = 0.0;        ///< [m]
  double density = 0.0;       ///< of a box [W/m3]
  double power = 0.0;         ///< of a ball, in all [W]
  TimeFunction history = TimeFunction::parse("1");
};

/// Reads the sublist `Sources` of Thermal.
template <int D>
std::vector<Source<D>> readSources(const Teuchos::ParameterList& list);

/// Adds the power of a source over a time step [W] to the supply of each particle.
///
/// \param begin of the step [s] \param dt its length [s], over which the mean of the history acts, at the
/// position of its middle \return the power that was added, of all ranks: less than the source's
/// where a box lies partly outside of the bodies, none where nothing lies in it
template <int D>
double addSource(const State<D>& state, const Source<D>& source, double begin, double dt,
                 const View<double*>& supply);

/// Spreads a power evenly over the particles in a disk or ball, those on its rim by the part that lies
/// inside. \return the power that was added, of all ranks: none where the ball holds no particle
template <int D>
double addBall(const State<D>& state, const Vector<D>& centre, double radius, double power,
               const View<double*>& supply);

/// The radius over which cells of the state can spread heat, at least: the edge of the smallest [m].
template <int D>
double smallestRadius(const State<D>& state)
{
  return state.mesh.smallestSpacing();
}

/// The warning for a radius that cells of an edge do not resolve; empty where they do.
std::string unresolved(const std::string& what, double radius, double edge);

} // namespace Rhegma::thermal
