#include "surface/Border.hpp"

#include <gtest/gtest.h>

using namespace Rhegma;
using namespace Rhegma::surface;

/// A unit square of two triangles in a body that ends at x = 1.5: the edge at x = 1 has half a cell of
/// material ahead of it, too little to be a front; the others have more.
TEST(Border, IsAFrontWhereMaterialIsAhead)
{
  CrackMesh<3> mesh;
  mesh.vertices = {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {1.0, 1.0, 0.0}, {0.0, 1.0, 0.0}};
  mesh.simplices = {{0, 1, 2}, {0, 2, 3}};
  const auto isIn = [](const Vector<3>& x) { return x[0] < 1.5; };
  const BrokenLigament broken = markBorder(
      mesh, [](const Vector<3>&) { return BorderKind::FrontIfMaterialAhead; }, isIn, 1.0);
  EXPECT_EQ(broken.length, 1.0);
  EXPECT_EQ(norm(broken.middle - Vector<3>{1.0, 0.5, 0.0}), 0.0);
  EXPECT_EQ(mesh.beyond[0][0], facet::surfaceBreaking); // edge 1-2
  EXPECT_EQ(mesh.beyond[0][1], 1);                      // the diagonal
  EXPECT_EQ(mesh.beyond[0][2], facet::front);
  EXPECT_EQ(mesh.beyond[1][0], facet::front);
  EXPECT_EQ(mesh.beyond[1][1], facet::front);
  markBorder(
      mesh, [](const Vector<3>&) { return BorderKind::Front; }, isIn, 1.0);
  EXPECT_EQ(mesh.beyond[0][0], facet::front);
  const auto nearly = [](const Vector<3>& x) { return x[0] < 1.999; };
  const BrokenLigament oblique = markBorder(
      mesh, [](const Vector<3>&) { return BorderKind::FrontIfMaterialAhead; }, nearly, 1.001);
  EXPECT_EQ(mesh.beyond[0][0], facet::front); // an edge shorter than a cell between two fronts
  EXPECT_EQ(oblique.length, 0.0);
  const BrokenLigament none = markBorder(
      mesh, [](const Vector<3>&) { return BorderKind::SurfaceBreaking; }, isIn, 1.0);
  EXPECT_EQ(none.length, 0.0);
  EXPECT_EQ(mesh.beyond[1][1], facet::surfaceBreaking);
}
