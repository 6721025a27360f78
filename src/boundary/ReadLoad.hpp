#pragma once
/// Loads from the scene.

#include "boundary/BodySurface.hpp"
#include "boundary/Loads.hpp"

#include <Teuchos_ParameterList.hpp>

#include <functional>
#include <string>
#include <vector>

namespace Rhegma
{

/// Points of a load on the particles of a body, and the total force at history 1 [N].
template <int D>
struct PlacedLoad
{
  std::vector<LoadPoint<D>> points;
  Vector<D> force;
  double alongNormals = 0.0; ///< and a force along each point's normal; the sum of their sizes [N]
};

/// Places a load on a body. \param where path of the list, for messages
template <int D>
using PlaceLoad = std::function<PlacedLoad<D>(const Teuchos::ParameterList& list, const Seeds<D>& seeds,
                                              const std::string& where)>;

/// Places the load of a boundary with the parameter `Body`. Throws std::invalid_argument, with the section's
/// path, for a load that reaches no particle. \param history factor over time
template <int D>
Load<D> readLoad(const Teuchos::ParameterList& list, const State<D>& state, const std::string& name,
                 const std::string& history, const PlaceLoad<D>& place);

/// A part of a body's surface.
template <int D>
struct PlacedSurface
{
  std::vector<LoadPoint<D>> points; ///< with the fractions of the area that their pieces are
  SurfaceMeasure<D> measure;
  /// Whether it is a line (2D) or a parallelogram (3D), whose points have one normal, that of the measure:
  /// right of From -> To, along Edge 1 x Edge 2.
  bool flat;
};

/// Places the part of a surface that the parameters of describeSurface give. Throws std::invalid_argument
/// where it is not on the body. \param scene validated \param seeds and the others as for PlaceLoad
template <int D>
PlacedSurface<D> placeSurface(const Teuchos::ParameterList& scene, const Teuchos::ParameterList& list,
                              const Seeds<D>& seeds, const std::string& where);

/// A part of a surface as points without force.
template <int D>
struct Surface
{
  Load<D> points;
  double area; ///< [m2]
};

/// The part of a surface of a boundary. Throws std::invalid_argument where it reaches no particle.
template <int D>
Surface<D> readSurface(const Teuchos::ParameterList& scene, const Teuchos::ParameterList& list,
                       const State<D>& state, const std::string& name);

} // namespace Rhegma
