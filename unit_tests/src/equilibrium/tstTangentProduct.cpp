/// Products with the stiffness without a matrix.

#include "equilibrium/TangentProduct.hpp"
#include "src/step/Bodies.hpp"

#include <cmath>

namespace Rhegma
{
namespace Test
{

namespace
{

/// A beam of three cells by two, turned in its cells, that shear strains.
template <int D>
Teuchos::ParameterList turnedBeam(const std::string& formulation)
{
  Teuchos::ParameterList scene = emptyScene<D>(all<D>(-3.0), all<D>(6.0), 1.0, "MUSL", "GIMP");
  scene.sublist("Domain").set("Formulation", formulation);
  scene.sublist("Time").set("Analysis", "Static");
  scene.sublist("Time").set("Rigid Modes", "Remove");
  scene.sublist("Time").set("Final Time", 1.0);
  addMaterial(scene, "Neo-Hookean", 0.3);
  Vector<D> high = all<D>(2.0);
  high[0] = 3.0;
  addBox<D>(scene, "Beam", all<D>(0.0), high);
  scene.sublist("Bodies").sublist("Beam").set("Rotation", 17.0);
  return scene;
}

/// Compares products and the diagonal with those of the blocks of a matrix. Both take the same tangents, and
/// leave out slopes below 1e-8 at most.
template <int D>
void compareWithMatrix(const std::string& formulation)
{
  Rhegma::Run<D> run(validated(turnedBeam<D>(formulation)));
  run.initialize();
  const State<D>& state = run.state();
  equilibrium::RowGraph graph = equilibrium::numberRows(state);
  const equilibrium::RowOwners owners;
  const equilibrium::Resistances<D> resistances(state, graph);
  equilibrium::connect(state, resistances, equilibrium::Couplings::All, equilibrium::ClippedBoxes<D>(),
                       owners, graph);
  const int n = D * graph.rows;
  const equilibrium::Values at("at", n), u("u", n), force("force", n);
  for (int k = 0; k < n; ++k)
  {
    at(k) = 0.02 * std::sin(1.0 + 0.7 * k);
    u(k) = std::cos(2.0 + 1.3 * k);
  }
  const equilibrium::Stiffness stiffness =
      equilibrium::assemble(state, resistances, at, equilibrium::ClippedBoxes<D>(), owners, graph, false);
  const equilibrium::TangentProduct<D> product(state, owners, graph, resistances, at);
  ASSERT_TRUE(stiffness.exists && product.exists() && product.isSymmetric());
  product.apply(u, force);
  const equilibrium::Values diagonal = product.diagonal();
  double largest = 0.0;
  for (int k = 0; k < n; ++k)
    largest = std::max(largest, diagonal(k));
  ASSERT_GT(largest, 0.0);
  for (int r = 0; r < graph.rows; ++r)
    for (int i = 0; i < D; ++i)
    {
      double sum = 0.0;
      for (int e = graph.first(r); e < graph.first(r + 1); ++e)
        for (int k = 0; k < D; ++k)
          sum += stiffness.blocks(D * D * e + D * i + k) * u(D * graph.column(e) + k);
      EXPECT_NEAR(force(D * r + i), sum, 1e-8 * largest) << r << " " << i;
      EXPECT_NEAR(diagonal(D * r + i), stiffness.blocks(D * D * graph.find(r, r) + (D + 1) * i),
                  1e-12 * largest);
    }
}

} // namespace

TEST(TangentProduct, IsThatOfTheMatrix)
{
  compareWithMatrix<2>("Updated Lagrangian");
  compareWithMatrix<3>("Updated Lagrangian");
}

TEST(TangentProduct, IsThatOfTheMatrixInUndeformedCells)
{
  compareWithMatrix<2>("Total Lagrangian");
  compareWithMatrix<3>("Total Lagrangian");
}

/// Pieces by the particles alone are those by coupled rows.
TEST(TangentProduct, NeedsNoGraphForPieces)
{
  Rhegma::Run<3> run(validated(turnedBeam<3>("Updated Lagrangian")));
  run.initialize();
  const State<3>& state = run.state();
  equilibrium::RowGraph graph = equilibrium::numberRows(state);
  const auto alone = equilibrium::findPieces(state, {}, equilibrium::RowOwners(), graph);
  equilibrium::connectRows(state, {}, equilibrium::ClippedBoxes<3>(), equilibrium::RowOwners(), graph);
  EXPECT_EQ(alone, equilibrium::findPieces(graph, equilibrium::RowOwners()));
  EXPECT_EQ(alone.second, 1);
}

} // namespace Test
} // namespace Rhegma
