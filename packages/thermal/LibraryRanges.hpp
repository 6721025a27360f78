#pragma once
/// Whether materials of the library stay at the temperatures for which their constants are given
/// (docs/reference/materials.md).

#include "state/State.hpp"
#include "thermal/JudgeTemperatures.hpp"

#include <Teuchos_ParameterList.hpp>

#include <string>
#include <vector>

namespace Rhegma
{
class Archive;
}

namespace Rhegma::thermal
{

/// A material of a scene that is one of the library, and the temperatures that it has had.
struct LibraryRange
{
  std::string where;                      ///< its path in the scene
  std::string name;                       ///< in the library
  int material;                           ///< its number
  TemperatureRange valid;                 ///< for which its constants are given
  TemperatureRange had;                   ///< in the samples of the run
  double lowestAt = 0.0, highestAt = 0.0; ///< times of both [s]
  double said = 0.0; ///< how far outside the start is, of which there is a warning already [K]

  /// How far outside it has been, colder or hotter [K]; negative where it was inside.
  double outside() const;
  /// A warning where it has been colder or hotter; of both that which is further outside. Else nothing.
  std::string warning() const;
};

/// All of the section Materials of a scene that are of the library.
std::vector<LibraryRange> libraryRanges(const Teuchos::ParameterList& materials);

/// Takes the particles' temperatures into account. Collective.
template <int D>
void sampleRanges(const State<D>& state, std::vector<LibraryRange>& ranges);

/// Warns of bodies that start outside of the ranges.
template <int D>
void warnOfRangesAtStart(State<D>& state, std::vector<LibraryRange>& ranges);

/// Saves or loads what they have had.
void storeRanges(std::vector<LibraryRange>& ranges, Archive& archive);

} // namespace Rhegma::thermal
