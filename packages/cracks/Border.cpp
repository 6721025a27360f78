#include "cracks/Border.hpp"

#include "cracks/Triangulation.hpp"
#include "geometry/Cross.hpp"

namespace Rhegma::cracks
{

namespace
{

/// Whether there is material for a cell from a place on. \param way of any length
bool isAhead(const MaterialPlaces<3>& material, const Vector<3>& x, const Vector<3>& way, double spacing)
{
  for (const double step : {0.25, 0.5, 0.75, 1.0})
    if (!material.fills(x + (step * spacing / norm(way)) * way))
      return false;
  return true;
}

/// Whether a piece of border is one of a front that runs on to a surface at an angle: straight ahead of it
/// the body ends, but at one end of the piece only, and from the other there is material for a cell, straight
/// ahead or by up to 45 degrees away from the surface. \param out across the piece, of any length
bool runsOnToSurface(const MaterialPlaces<3>& material, const Vector<3>& a, const Vector<3>& b,
                     const Vector<3>& out, double spacing)
{
  constexpr double nearEnd = 0.1, just = 0.25; // of the piece; of a cell
  const Vector<3> along = b - a, ahead = (1.0 / norm(out)) * out;
  for (const bool back : {false, true})
  {
    const Vector<3> in = back ? a + nearEnd * along : b - nearEnd * along,
                    at = back ? b - nearEnd * along : a + nearEnd * along;
    const Vector<3> aside = ((back ? -1.0 : 1.0) / norm(along)) * along;
    if (!material.fills(at + just * spacing * ahead) && material.fills(in + just * spacing * ahead) &&
        (isAhead(material, in, ahead, spacing) || isAhead(material, in, ahead + aside, spacing)))
      return true;
  }
  return false;
}

} // namespace

void markBorder(CrackMesh<3>& mesh, const KindOfBorder& kindOf, const MaterialPlaces<3>& material,
                double spacing)
{
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
           (isAhead(material, middle, out, spacing) || runsOnToSurface(material, a, b, out, spacing)));
      mesh.beyond[t][i] = front ? facet::front : facet::mouth;
    }
}

} // namespace Rhegma::cracks
