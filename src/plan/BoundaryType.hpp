#pragma once
/// Types of boundary: their parameters and what they do (docs/how-to/add-a-boundary.md).

#include "base/Types.hpp"
#include "scene/Schema.hpp"
#include "scene/SectionChecks.hpp"

#include <functional>
#include <string>
#include <vector>

namespace Rhegma
{

template <int D>
struct BoundaryParts; // boundary/BoundaryParts.hpp

/// Where a boundary acts, for those that need not know its type.
struct BoundaryRegion
{
  std::string name{}; ///< of the boundary in its scene
  enum class Kind
  {
    Unknown,
    Force,       ///< forces on the straight line between two points of a body
    Held,        ///< prescribed motion of the nodes in a box
    HeldOutside, ///< the same of those outside of it
    Mirror       ///< a plane of symmetry
  };
  Kind kind = Kind::Unknown;
  Vector<3> from{}, to{}; ///< ends of the line, corners of the box; a plane's position on its axis [m]
  std::string axes{};     ///< letters of those along which motion is prescribed
};

struct BoundaryType
{
  /// Adds one boundary of a scene. \param list its parameters
  template <int D>
  using Add =
      std::function<void(BoundaryParts<D>&, const Teuchos::ParameterList& list, const std::string& name)>;
  /// Checks several parameters together. \param where path of the list
  using Check =
      std::function<void(SectionChecks&, const Teuchos::ParameterList& list, const std::string& where)>;

  Section section; ///< its parameters; its name is the value of Type
  Check check{};   ///< may be empty; Body and History are checked for all types
  Add<2> add2{};
  Add<3> add3{};
  /// Capability of the effect that applies it, instead of `add` (scene/Compatibility.hpp); a section of the
  /// scene must provide it. Empty: none.
  std::string capability{};
  /// Where one acts, by its parameters alone; empty: nothing that others look for.
  std::function<BoundaryRegion(const Teuchos::ParameterList& list)> region{};
};

/// Adds a type of an application. Call it before making the schema or Simulation that uses it. Throws
/// std::invalid_argument where there is a type of that name or it can't be made.
void addBoundaryType(BoundaryType type);

/// The types that scenes may use.
const std::vector<BoundaryType>& boundaryTypes();

/// By the value of Type. Throws std::invalid_argument if there is none.
const BoundaryType& boundaryType(const std::string& name);

/// The boundaries of a validated scene that say where they act.
std::vector<BoundaryRegion> boundaryRegions(const Teuchos::ParameterList& scene);

/// The list of boundary/Types.cpp.
std::vector<BoundaryType> builtInBoundaryTypes();

/// Checks the section Boundaries, if there is one.
void checkBoundaries(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors);

} // namespace Rhegma
