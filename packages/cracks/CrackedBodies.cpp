#include "cracks/CrackedBodies.hpp"

#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "geometry/Cross.hpp"
#include "scene/BondedGroups.hpp"
#include "surface/NearestOnSimplex.hpp"

#include <algorithm>
#include <exception>
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
CrackMesh<D> CrackedBodies<D>::read(const Teuchos::ParameterList& list, const std::string& where,
                                    const State<D>& state, double edge, double front,
                                    std::vector<std::string>& warnings, int& bodyGroup) const
{
  const double cell = state.mesh.grid.spacing;
  const auto readIn =
      [&](const SceneBodies<D>& shapes, const std::vector<bool>& bodies, std::vector<std::string>& said)
  {
    const BodyRegion<D> region(shapes, state, bodies);
    return readCrack<D>(list, where, ReadingContext<D>{region, cell, edge, front}, said);
  };
  bodyGroup = 0;
  if (groups_.empty())
    return readIn(all_, {}, warnings);
  std::vector<CrackMesh<D>> parts(groups_.size());
  std::vector<std::vector<std::string>> said(groups_.size());
  std::exception_ptr wrong;
  double largest = 0.0;
  for (std::size_t g = 0; g < groups_.size(); ++g)
    try
    {
      parts[g] = readIn(groups_[g].shapes, groups_[g].holds, said[g]);
      const double size = sizeOf(parts[g]);
      bodyGroup = size > largest ? static_cast<int>(g) + 1 : bodyGroup;
      largest = std::max(largest, size);
    }
    catch (const std::invalid_argument&)
    {
      wrong = std::current_exception();
    }
  if (bodyGroup == 0)
  {
    readIn(all_, {}, warnings); // says what is wrong with the crack itself
    std::rethrow_exception(wrong);
  }
  const CrackMesh<D>& own = parts[bodyGroup - 1];
  for (std::size_t g = 0; g < groups_.size(); ++g)
    if (static_cast<int>(g) + 1 != bodyGroup && !parts[g].simplices.empty())
      if (const double beyond = furthest(parts[g], own); beyond > mostOverhang * cell)
        throw std::invalid_argument(
            where + ": it cuts " + groups_[bodyGroup - 1].name + " and reaches " + readableLength(beyond) +
            " into " + groups_[g].name +
            ", which is not bonded to it: a crack belongs to bodies that are one; let "
            "it end at the surface, or bond the two (Bodies > NAME > Bonded To)");
  warnings.insert(warnings.end(), said[bodyGroup - 1].begin(), said[bodyGroup - 1].end());
  return own;
}

template class CrackedBodies<2>;
template class CrackedBodies<3>;

} // namespace Rhegma::cracks
