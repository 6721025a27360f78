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
readMeshes(const Teuchos::ParameterList& section, const CrackedBodies<D>& bodies, const State<D>& state,
           double edge, double cellAtFronts, std::vector<std::string>& warnings, std::vector<int>& bodyGroups)
{
  std::vector<surface::CrackMesh<D>> meshes;
  const typename CrackedBodies<D>::Regions regions = bodies.regions(state);
  Attempts attempts;
  for (const std::string& name : sublistNames(section))
    attempts.attempt(
        [&]
        {
          int bodyGroup = 0;
          meshes.push_back(bodies.read(section.sublist(name), "Cracks > " + name, regions, state, edge,
                                       cellAtFronts, warnings, bodyGroup));
          bodyGroups.push_back(bodyGroup);
        });
  attempts.throwIfAny();
  return meshes;
}

template <int D>
std::vector<surface::CrackMesh<D>> readCracks(const Teuchos::ParameterList& section,
                                              const CrackedBodies<D>& bodies, State<D>& state, double edge,
                                              double cellAtFronts)
{
  std::vector<int> bodyGroups;
  const std::vector<surface::CrackMesh<D>> meshes =
      readMeshes(section, bodies, state, edge, cellAtFronts, state.warnings, bodyGroups);
  CrackSet<D>& set = state.cracks;
  for (const std::string& name : sublistNames(section))
  {
    const surface::CrackMesh<D>& mesh = meshes[set.cracks.size()];
    const int numFronts = static_cast<int>(surface::frontsOf(mesh).size());
    Crack<D> crack;
    crack.name = name;
    crack.bodyGroup = bodyGroups[set.cracks.size()];
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
  if (bodies.areKeptApart())
  {
    set.bodyGroupOf = View<int*>("rhegma::bodyGroupOfCrack", bodyGroups.size());
    const auto host = Kokkos::create_mirror_view(set.bodyGroupOf);
    std::copy(bodyGroups.begin(), bodyGroups.end(), host.data());
    Kokkos::deep_copy(set.bodyGroupOf, host);
  }
  set.nodeSide = View<int*>("rhegma::nodeSide", state.mesh.grid.numNodes);
  set.enrichedField = View<int*>("rhegma::enrichedField", state.mesh.grid.numNodes);
  Kokkos::deep_copy(set.enrichedField, -1);
  return meshes;
}

template std::vector<surface::CrackMesh<2>> readMeshes(const Teuchos::ParameterList&, const CrackedBodies<2>&,
                                                       const State<2>&, double, double,
                                                       std::vector<std::string>&, std::vector<int>&);
template std::vector<surface::CrackMesh<2>> readCracks(const Teuchos::ParameterList&, const CrackedBodies<2>&,
                                                       State<2>&, double, double);
template std::vector<surface::CrackMesh<3>> readMeshes(const Teuchos::ParameterList&, const CrackedBodies<3>&,
                                                       const State<3>&, double, double,
                                                       std::vector<std::string>&, std::vector<int>&);
template std::vector<surface::CrackMesh<3>> readCracks(const Teuchos::ParameterList&, const CrackedBodies<3>&,
                                                       State<3>&, double, double);

} // namespace Rhegma::cracks
