#include "cracks/CrackSetup.hpp"

#include "base/Attempts.hpp"
#include "base/ReadList.hpp"
#include "cracks/Layout.hpp"
#include "cracks/ReadCrack.hpp"
#include "surface/FrontPieces.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace Rhegma::cracks
{

template <int D>
std::vector<surface::CrackMesh<D>>
readMeshes(const Teuchos::ParameterList& section, const SceneBodies<D>& bodies, const State<D>& state,
           double edge, double cellAtFronts, std::vector<std::string>& warnings)
{
  const double spacing = state.mesh.grid.spacing;
  const BodyRegion<D> region(bodies, state);
  const ReadingContext<D> context{region, spacing, edge, cellAtFronts};
  std::vector<surface::CrackMesh<D>> meshes;
  Attempts attempts;
  for (const std::string& name : sublistNames(section))
    attempts.attempt(
        [&] { meshes.push_back(readCrack(section.sublist(name), "Cracks > " + name, context, warnings)); });
  attempts.throwIfAny();
  return meshes;
}

template <int D>
std::vector<surface::CrackMesh<D>> readCracks(const Teuchos::ParameterList& section,
                                              const SceneBodies<D>& bodies, State<D>& state, double edge,
                                              double cellAtFronts)
{
  const std::vector<surface::CrackMesh<D>> meshes =
      readMeshes(section, bodies, state, edge, cellAtFronts, state.warnings);
  CrackSet<D>& set = state.cracks;
  for (const std::string& name : sublistNames(section))
  {
    const surface::CrackMesh<D>& mesh = meshes[set.cracks.size()];
    const int numFronts = static_cast<int>(surface::frontsOf(mesh).size());
    Crack<D> crack;
    crack.name = name;
    for (int number = 0; number < numFronts; ++number)
    {
      CrackFront<D> front;
      front.crack = static_cast<int>(set.cracks.size());
      front.number = number;
      set.fronts.push_back(front);
    }
    set.cracks.push_back(crack);
  }
  layOut(set, meshes, state.mesh.grid.spacing);
  set.nodeSide = View<int*>("rhegma::nodeSide", state.mesh.grid.numNodes);
  set.enrichedField = View<int*>("rhegma::enrichedField", state.mesh.grid.numNodes);
  Kokkos::deep_copy(set.enrichedField, -1);
  return meshes;
}

template std::vector<surface::CrackMesh<2>> readMeshes(const Teuchos::ParameterList&, const SceneBodies<2>&,
                                                       const State<2>&, double, double,
                                                       std::vector<std::string>&);
template std::vector<surface::CrackMesh<2>> readCracks(const Teuchos::ParameterList&, const SceneBodies<2>&,
                                                       State<2>&, double, double);
template std::vector<surface::CrackMesh<3>> readMeshes(const Teuchos::ParameterList&, const SceneBodies<3>&,
                                                       const State<3>&, double, double,
                                                       std::vector<std::string>&);
template std::vector<surface::CrackMesh<3>> readCracks(const Teuchos::ParameterList&, const SceneBodies<3>&,
                                                       State<3>&, double, double);

} // namespace Rhegma::cracks
