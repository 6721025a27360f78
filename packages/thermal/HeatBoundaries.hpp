#pragma once
/// Temperature, flux and convection at the surface.

#include "boundary/ReadLoad.hpp"
#include "thermal/HeatNodes.hpp"

#include <Teuchos_ParameterList.hpp>

#include <string>
#include <vector>

namespace Rhegma::thermal
{

/// A box whose nodes have a prescribed temperature.
template <int D>
struct HeldTemperature
{
  Vector<D> lower, upper; ///< [m]
  double temperature;     ///< [K]
  TimeFunction history;
  std::string name; ///< of its section
};

/// A surface with a heat flux: prescribed, or by convection.
template <int D>
struct HeatedSurface
{
  Surface<D> surface;
  double flux = 0.0;        ///< [W/m2]
  double coefficient = 0.0; ///< [W/(m2 K)]; 0: a given flux
  double ambient = 0.0;     ///< [K]
  TimeFunction history;
};

/// The thermal boundaries of a scene.
template <int D>
class HeatBoundaries
{
public:
  /// Reads them from the scene's Boundaries. \param scene validated. Throws std::invalid_argument, with the
  /// path, for one that holds no node or meets no particle; warns of one that is cold at the start.
  void read(const Teuchos::ParameterList& scene, State<D>& state);

  /// Pairs of boxes that prescribe different temperatures on a node, for the present particles and cells.
  /// Collective. \return a message for each pair (boundary/Contradictions.hpp); empty where there is none
  std::string contradictions(const State<D>& state, double finalTime) const;

  /// Prescribes the temperature of nodes at the end of the step, and its change.
  void hold(const State<D>& state, const HeatNodes<D>& nodes, double time) const;

  /// Adds the heat that comes through surfaces over a step to the nodes' rate, of this rank. \param begin
  /// of the step [s] \param dt its length [s], over which the mean of a history acts \return the power [W]
  double addFlux(State<D>& state, const HeatNodes<D>& nodes, double begin, double dt);

  /// Adds the change of that heat with a change of the nodal temperature (first column) to a flow (first
  /// column); the positions are those of the last addFlux. \return the change of the power [W]
  double addResponse(const View<double* [2]>& change, const View<double* [2]>& flow) const;

  /// Adds to each node's heat flow per own temperature that of convection [W/K], or more.
  void addDiagonal(const View<double*>& diagonal) const;

  /// Longest step that convection allows [s], for the capacity of a layer of cells.
  double stepLimit(double capacity, double spacing) const;

  /// All of them with the parameters that are their sizes, such as "Boundaries > Air > Coefficient (20 W/(m2
  /// K))".
  std::string asText() const;

private:
  std::vector<HeldTemperature<D>> held_;
  std::vector<HeatedSurface<D>> surfaces_;
};

} // namespace Rhegma::thermal
