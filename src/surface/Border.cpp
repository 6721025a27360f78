#include "surface/Border.hpp"

#include "geometry/Cross.hpp"
#include "surface/Triangulation.hpp"

#include <algorithm>

namespace Rhegma::surface
{

namespace
{

constexpr double some = 0.1; ///< material ahead of an edge, which may be cut along a curved surface [cells]

/// Whether a border edge is one of a front that meets a surface at an angle: straight ahead of it the body
/// ends, but at one end of the edge only, and from the other there is material for a cell, straight ahead or
/// by up to 45 degrees away from the surface. \param out across the edge, of any length
bool meetsSurfaceAtAnAngle(const Region<3>& bodies, const Vector<3>& a, const Vector<3>& b,
                           const Vector<3>& out, double cell)
{
  constexpr double nearEnd = 0.1, just = 0.25; // of the edge; of a cell
  const Vector<3> along = b - a, ahead = (1.0 / norm(out)) * out;
  for (const bool back : {false, true})
  {
    const Vector<3> in = back ? a + nearEnd * along : b - nearEnd * along,
                    at = back ? b - nearEnd * along : a + nearEnd * along;
    const Vector<3> aside = ((back ? -1.0 : 1.0) / norm(along)) * along;
    if (!bodies(at + just * cell * ahead) && bodies(in + just * cell * ahead) &&
        (extendsBeyond(bodies, in, ahead, cell) || extendsBeyond(bodies, in, ahead + aside, cell)))
      return true;
  }
  return false;
}

} // namespace

BrokenLigament markBorder(CrackMesh<3>& mesh, const KindOfBorder& kindOf, const Region<3>& bodies,
                          double cell)
{
  BrokenLigament broken;
  double longest = 0.0;
  mesh.beyond = findNeighbours(mesh.simplices);
  for (std::size_t t = 0; t < mesh.simplices.size(); ++t)
    for (int i = 0; i < 3; ++i)
    {
      if (mesh.beyond[t][i] >= 0)
        continue;
      const Vector<3>&a = mesh.vertices[mesh.simplices[t][(i + 1) % 3]],
            &b = mesh.vertices[mesh.simplices[t][(i + 2) % 3]], &c = mesh.vertices[mesh.simplices[t][i]];
      const Vector<3> middle = 0.5 * (a + b), out = cross(b - a, cross(b - a, c - a));
      const BorderKind kind = kindOf(middle);
      const bool front =
          kind == BorderKind::Front ||
          (kind == BorderKind::FrontIfMaterialAhead &&
           (extendsBeyond(bodies, middle, out, cell) || meetsSurfaceAtAnAngle(bodies, a, b, out, cell)));
      mesh.beyond[t][i] = front ? facet::front : facet::surfaceBreaking;
      if (front || kind == BorderKind::SurfaceBreaking || !bodies(middle + (some * cell / norm(out)) * out))
        continue;
      const double length = norm(b - a);
      broken.length += length;
      if (length > longest)
        broken.middle = middle;
      longest = std::max(longest, length);
    }
  return broken;
}

} // namespace Rhegma::surface
