#include "cracks/CrackedBodies.hpp"

#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "geometry/Cross.hpp"
#include "scene/BondedGroups.hpp"
#include "surface/NearestOnSimplex.hpp"

#include <algorithm>
#include <exception>
#include <limits>
#include <stdexcept>

namespace Rhegma::cracks
{

namespace
{

using surface::CrackMesh;

template <int D>
Vector<D> cornerOf(const CrackMesh<D>& mesh, int simplex, int k)
{
  return mesh.vertices[mesh.simplices[simplex][k]];
}

/// Length of a crack (2D), or twice its area.
template <int D>
double sizeOf(const CrackMesh<D>& mesh)
{
  double size = 0.0;
  for (int s = 0; s < static_cast<int>(mesh.simplices.size()); ++s)
  {
    const Vector<D> edge = cornerOf(mesh, s, 1) - cornerOf(mesh, s, 0);
    if constexpr (D == 2)
      size += norm(edge);
    else
      size += norm(cross(edge, cornerOf(mesh, s, 2) - cornerOf(mesh, s, 0)));
  }
  return size;
}

/// The largest distance of a part of a crack from another part [m].
template <int D>
double furthest(const CrackMesh<D>& part, const CrackMesh<D>& from)
{
  double most = 0.0;
  for (const Vector<D>& x : part.vertices)
  {
    double nearest = 1e300;
    for (int s = 0; s < static_cast<int>(from.simplices.size()); ++s)
    {
      Vector<D> corner[D];
      for (int k = 0; k < D; ++k)
        corner[k] = cornerOf(from, s, k);
      nearest = std::min(nearest, surface::distanceToSimplex(corner, x));
    }
    most = std::max(most, nearest);
  }
  return most;
}

/// The scene without the bodies of other groups.
Teuchos::ParameterList only(const Teuchos::ParameterList& scene, const std::vector<std::string>& names,
                            const std::vector<bool>& holds)
{
  Teuchos::ParameterList part;
  Teuchos::ParameterList& bodies = part.sublist("Bodies");
  for (std::size_t b = 0; b < names.size(); ++b)
    if (holds[b])
      bodies.sublist(names[b]) = scene.sublist("Bodies").sublist(names[b]);
  return part;
}

/// What of a crack lies in one group of bodies.
template <int D>
struct PartOfCrack
{
  CrackMesh<D> mesh;
  double size = 0.0; ///< as of sizeOf; 0: nothing, infinite: the crack is wrong in itself
  std::vector<std::string> warnings;
  std::exception_ptr wrong; ///< why it cannot be a crack of this group
};

/// Reads that part. Where its fronts are wrong, it still has its mesh, so that its size and how far it
/// reaches are known.
template <int D>
PartOfCrack<D> partIn(const Teuchos::ParameterList& list, const std::string& where,
                      const ReadingContext<D>& context)
{
  PartOfCrack<D> part;
  try
  {
    part.mesh = readCrack<D>(list, where, context, part.warnings);
    part.size = sizeOf(part.mesh);
    return part;
  }
  catch (const std::invalid_argument& error)
  {
    part.wrong = std::current_exception();
    if (std::string(error.what()).find(outsideOfBodies) != std::string::npos)
      return part;
  }
  Teuchos::ParameterList plain(list);
  plain.set("Fronts", "None");
  try
  {
    part.mesh = readCrack<D>(plain, where, context, part.warnings);
    part.size = sizeOf(part.mesh);
  }
  catch (const std::invalid_argument&)
  {
    part.size = std::numeric_limits<double>::infinity();
  }
  return part;
}

} // namespace

template <int D>
CrackedBodies<D>::CrackedBodies(const Teuchos::ParameterList& scene, bool keptApart) : all_(scene)
{
  const std::vector<std::string> names = sublistNames(scene.sublist("Bodies"));
  const BondedGroups groups = bondedGroups(scene.sublist("Bodies"), names);
  for (int g = 0; keptApart && g < groups.count(); ++g)
  {
    std::vector<bool> holds;
    for (const int of : groups.of)
      holds.push_back(of == g);
    groups_.push_back({groups.names[g], holds, SceneBodies<D>(only(scene, names, holds))});
  }
}

template <int D>
typename CrackedBodies<D>::Regions CrackedBodies<D>::regions(const State<D>& state) const
{
  Regions regions;
  if (groups_.empty())
    regions.push_back(std::make_unique<BodyRegion<D>>(all_, state));
  for (const Group& group : groups_)
    regions.push_back(std::make_unique<BodyRegion<D>>(group.shapes, state, group.holds));
  return regions;
}

template <int D>
CrackMesh<D> CrackedBodies<D>::read(const Teuchos::ParameterList& list, const std::string& where,
                                    const Regions& regions, const State<D>& state, double edge, double front,
                                    std::vector<std::string>& warnings, int& bodyGroup) const
{
  const double cell = state.mesh.grid.spacing;
  bodyGroup = 0;
  if (groups_.empty())
    return readCrack<D>(list, where, ReadingContext<D>{*regions.front(), cell, edge, front}, warnings);
  std::vector<PartOfCrack<D>> parts;
  std::size_t own = 0;
  for (std::size_t g = 0; g < groups_.size(); ++g)
  {
    parts.push_back(partIn(list, where, ReadingContext<D>{*regions[g], cell, edge, front}));
    own = parts[g].size > parts[own].size ? g : own;
  }
  if (parts[own].wrong)
    std::rethrow_exception(parts[own].wrong);
  bodyGroup = static_cast<int>(own) + 1;
  for (std::size_t g = 0; g < groups_.size(); ++g)
    if (const double beyond = furthest(parts[g].mesh, parts[own].mesh);
        g != own && beyond > mostOverhang * cell)
      throw std::invalid_argument(where + ": it cuts " + groups_[own].name + " and reaches " +
                                  readableLength(beyond) + " into " + groups_[g].name +
                                  ", which is not bonded to it: a crack belongs to bodies that are one; let "
                                  "it end at the surface, or bond the two (Bodies > NAME > Bonded To)");
  warnings.insert(warnings.end(), parts[own].warnings.begin(), parts[own].warnings.end());
  return parts[own].mesh;
}

template class CrackedBodies<2>;
template class CrackedBodies<3>;

} // namespace Rhegma::cracks
