#pragma once
/// The list of all constitutive laws. A new law is its header and its entry here; all switches over laws, the
/// schema, readers, tables and merging of particles follow from the list.

#include "material/Fluid.hpp"
#include "material/HighRateSolid.hpp"
#include "material/J2Plastic.hpp"
#include "material/LinearElastic.hpp"
#include "material/MooneyRivlin.hpp"
#include "material/NeoHookean.hpp"
#include "material/Ogden.hpp"
#include "material/Orthotropic.hpp"
#include "material/SharedLibrary.hpp"
#include "material/ViscoScram.hpp"
#include "material/Viscoelastic.hpp"

#include <type_traits>

namespace Rhegma
{

/// A list of types.
template <class... Law>
struct LawList
{
  static constexpr int size = sizeof...(Law);
};

/// Properties::law is an index in it.
using Laws = LawList<LinearElastic, NeoHookean, MooneyRivlin, J2Plastic, Viscoelastic, HighRateSolid,
                     ViscoScram, SharedLibrary, Orthotropic, Ogden, Fluid>;

/// Index of a law in a list.
template <class Law, class... Listed>
constexpr int indexIn(LawList<Listed...> /*list*/)
{
  static_assert((std::is_same_v<Law, Listed> || ...), "the law is not in the list");
  int index = 0;
  bool found = false;
  ((found = found || std::is_same_v<Law, Listed>, index += found ? 0 : 1), ...);
  return index;
}

/// Whether a law computes many particles in one call, after the pass that strains them
/// (transfer/StressInBlocks.hpp): it has `numbers(properties)`, how many of its historySize a material
/// stores. Its `stress`, for one particle, serves everything else.
template <class Law, class = void>
struct ComputesBlocks : std::false_type
{
};
template <class Law>
struct ComputesBlocks<Law, std::void_t<decltype(&Law::numbers)>> : std::true_type
{
};

template <class Law>
constexpr int lawIndex = indexIn<Law>(Laws{});

} // namespace Rhegma
