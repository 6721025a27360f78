#pragma once
/// State variables of laws of shared libraries, as fields.

#include "material/Materials.hpp"
#include "output/Snapshot.hpp"
#include "state/State.hpp"

#include <algorithm>

namespace Rhegma
{

/// A field for each state variable, state_1, state_2, ..., as many as the law with the most of them has; zero
/// where a particle's law has fewer. None where no material has such a law.
template <int D>
std::vector<DataSet> lawStates(const State<D>& state)
{
  const std::vector<Properties>& materials = state.materials.properties;
  std::vector<int> first(materials.size(), 0), count(materials.size(), 0); // in the history, by material
  for (std::size_t k = 0; k < materials.size(); ++k)
    if (isInBlocks(materials[k]))
    {
      const LoadedLaw& law = loadedLaw(static_cast<int>(materials[k].own[SharedLawNumber::law]));
      count[k] = law.states;
      first[k] = SharedLawHistory::numbers + law.numbers - law.states;
    }
  const int most = count.empty() ? 0 : *std::max_element(count.begin(), count.end());
  std::vector<DataSet> sets;
  if (most == 0)
    return sets;
  const auto history = onHost(state.particles.table(fields::history));
  const auto material = onHost(state.particles.integer(fields::material));
  for (int k = 0; k < most; ++k)
  {
    DataSet set{"state_" + std::to_string(k + 1), DataSet::Role::OnPoints, 1, false, {}, {}};
    for (std::size_t p = 0; p < material.extent(0); ++p)
      set.real.push_back(k < count[material(p)] ? history(p, first[material(p)] + k) : 0.0);
    sets.push_back(std::move(set));
  }
  return sets;
}

} // namespace Rhegma
