#include "cracks/Border.hpp"

#include "cracks/Triangulation.hpp"
#include "geometry/Cross.hpp"

namespace Rhegma::cracks
{

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
      bool front = kind != BorderKind::Mouth;
      if (kind == BorderKind::FrontIfMaterialAhead)
        for (const double step : {0.25, 0.5, 0.75, 1.0})
          front = front && material.fills(middle + (step * spacing / norm(out)) * out);
      mesh.beyond[t][i] = front ? facet::front : facet::mouth;
    }
}

} // namespace Rhegma::cracks
