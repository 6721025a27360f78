/// Shear strain at the cells' centres: exact for linear motions, adjoint to the force of shear stress.

#include "../grid/RandomTrees.hpp"
#include "src/step/Bodies.hpp"
#include "step/CoreStep.hpp"
#include "transfer/Gather.hpp"
#include "transfer/ParticleViews.hpp"
#include "transfer/Scatter.hpp"
#include "transfer/Stencils.hpp"
#include "transfer/TreeStencil.hpp"

#include <cmath>
#include <random>
#include <vector>

namespace Rhegma
{
namespace Test
{

namespace
{

constexpr double roundOff = 1e-13; ///< of sums of a few dozen numbers of order one
constexpr unsigned seed = 24;

/// A box of half widths up to half the leaf around it, anywhere.
template <int D>
Vector<D> anyBox(const TreeSight<D>& sight, std::mt19937& engine, Vector<D>& half)
{
  std::uniform_real_distribution<double> fraction(0.0, 1.0);
  Vector<D> x;
  for (int d = 0; d < D; ++d)
    x[d] = sight.grid.lower[d] + fraction(engine) * (sight.grid.upper[d] - sight.grid.lower[d]);
  for (int d = 0; d < D; ++d)
    half[d] = (0.01 + 0.49 * fraction(engine)) * sight.spacingAt(x);
  return x;
}

/// On leaves of any size, of a displacement that is linear each component has its own gradient.
template <int D, ShapeKind S>
void linearFields()
{
  const Grid<D> grid = lattice<D>();
  std::mt19937 engine(seed);
  StencilTable<D> table;
  table.reserve(1, true);
  for (int t = 0; t < 100; ++t)
  {
    Tree<D> tree;
    buildTree(randomBranches(grid, 3, engine), tree);
    const NodePositions<D> positions{grid, tree.finePosition};
    const TreeSight<D> sight(grid, tree);
    const TreeStencils<D, S> stencils(grid, tree, table);
    for (int b = 0; b < 30; ++b)
    {
      Vector<D> half{};
      const Vector<D> x = anyBox(sight, engine, half);
      if (!stencils.write(0, x, S == ShapeKind::Gimp ? half : Vector<D>{}))
        continue;
      double sum[D * D] = {}, first[D][D * D] = {};
      for (int k = 0; k < table.count(0); ++k)
        for (int c = 0; c < D * D; ++c)
        {
          sum[c] += grid.spacing * table.gradient(0, k, c);
          for (int m = 0; m < D; ++m)
            first[m][c] += (positions(table.node(0, k))[m] - x[m]) * table.gradient(0, k, c);
        }
      for (int c = 0; c < D * D; ++c)
      {
        ASSERT_NEAR(sum[c], 0.0, 8 * roundOff);
        for (int m = 0; m < D; ++m)
          ASSERT_NEAR(first[m][c], m == c / D ? 1.0 : 0.0, 8 * roundOff) << "axis " << m << ", entry " << c;
      }
    }
  }
}

/// The displacement of a bent cell, u_0 = x_0 x_1, has no shear strain anywhere in the cell, and the normal
/// strain x_1 where the point is.
template <int D>
void bentCell()
{
  const Grid<D> grid = makeGrid<D>(all<D>(-1.0), all<D>(2.0), 1.0);
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> fraction(0.0, 1.0);
  StencilTable<D> table;
  table.reserve(1, true);
  for (int k = 0; k < 50; ++k)
  {
    Vector<D> x;
    for (int d = 0; d < D; ++d)
      x[d] = fraction(engine);
    writeStencil<D, ShapeKind::Linear>(grid, table, 0, x, {});
    double normal = 0.0, shear = 0.0, atParticle = 0.0;
    for (int e = 0; e < table.count(0); ++e)
    {
      const Vector<D> node = grid.nodePosition(table.node(0, e));
      const double u = (node[0] - 0.5) * (node[1] - 0.5);
      normal += u * table.gradient(0, e, 0);
      shear += u * table.gradient(0, e, D);
      atParticle += u * table.slope(0, e, 1);
    }
    EXPECT_NEAR(normal, x[1] - 0.5, roundOff);
    EXPECT_NEAR(shear, 0.0, roundOff);
    EXPECT_NEAR(atParticle, x[0] - 0.5, roundOff); // what stiffens the cell otherwise
  }
}

/// Numbers for each component of a node, anything.
template <int D>
std::vector<double> anyRows(const Grid<D>& grid, std::mt19937& engine)
{
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  std::vector<double> rows(grid.numNodes * (D == 2 ? 2 : 4));
  for (double& r : rows)
    r = number(engine);
  return rows;
}

/// Tensor products give the gradients, and forces on nodes, that rows of the table give.
template <int D, ShapeKind S>
void productsAreTables()
{
  constexpr int width = D == 2 ? 2 : 4;
  constexpr ShearStrain centres = ShearStrain::AtCellCentres;
  const Grid<D> grid = makeGrid<D>(all<D>(-1.0), all<D>(2.0), 0.7);
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> fraction(0.0, 1.0);
  StencilTable<D> table;
  table.reserve(1, true);
  for (int b = 0; b < 50; ++b)
  {
    Vector<D> x, half;
    for (int d = 0; d < D; ++d)
    {
      x[d] = grid.lower[d] + fraction(engine) * (grid.upper[d] - grid.lower[d]);
      half[d] = (0.01 + 0.49 * fraction(engine)) * grid.spacing;
    }
    writeStencil<D, S>(grid, table, 0, x, half);
    LaneStencils<D, S> lane;
    lane.fill(grid, x.c, half.c, 1);
    const TensorStencil<D, S, centres> product{lane, grid.stride, 0, grid.spacing};
    const TableStencil<D, centres> row{table, 0};
    const std::vector<double> values = anyRows(grid, engine);
    Pack<width> byProduct[D], byRow[D];
    const Pack<width> value = product.template valueAndGradient<width>(values.data(), byProduct);
    const Pack<width> same = row.template valueAndGradient<width>(values.data(), byRow);
    std::vector<double> forces(values.size(), 0.0), others(values.size(), 0.0);
    product.template addFlux<width>(forces.data(), byRow);
    row.template addFlux<width>(others.data(), byRow);
    for (int i = 0; i < D; ++i)
    {
      ASSERT_NEAR(value[i], same[i], roundOff);
      for (int j = 0; j < D; ++j)
        ASSERT_NEAR(byProduct[j][i], byRow[j][i], 10 * roundOff) << "component " << i << " along " << j;
    }
    for (std::size_t k = 0; k < forces.size(); ++k)
    {
      const bool component = D == 2 || k % width < D;
      ASSERT_NEAR(forces[k], component ? others[k] : forces[k], 100 * roundOff);
    }
  }
}

/// A box with random particles, in refined cells too.
template <int D>
Teuchos::ParameterList shakenScene(const std::string& shape, bool refined)
{
  const Vector<D> upper = all<D>(D == 2 ? 8.0 : 4.0);
  Teuchos::ParameterList scene = emptyScene<D>(all<D>(-4.0), upper + all<D>(4.0), 1.0, "MUSL", shape);
  scene.sublist("Domain").set("Shear Strain", "At Cell Centres");
  addMaterial(scene, "Linear Elastic", 0.3);
  addBox<D>(scene, "Box", all<D>(0.0), upper);
  if (refined)
  {
    Teuchos::ParameterList& adaptivity = scene.sublist("Adaptivity");
    adaptivity.set("Maximum Level", 1);
    adaptivity.set("Front Cells", 0.0);
    Teuchos::ParameterList& box = adaptivity.sublist("Corner");
    box.set("Lower Corner", array(all<D>(0.0)));
    box.set("Upper Corner", array(all<D>(2.0)));
    box.set("Level", 1);
  }
  return scene;
}

/// Random positions, stresses and velocities of nodes: what the forces do on the nodes is what the stress
/// does on the particles. \param shake largest displacement of a particle [m]
template <int D>
void forceIsAdjoint(const std::string& shape, bool refined)
{
  Rhegma::Run<D> run(validated(shakenScene<D>(shape, refined)));
  run.initialize();
  if (refined)
    run.step(1e-6, false);
  State<D>& state = run.state();
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> number(-0.4, 0.4);
  HostParticles<D> particles(state);
  for (int p = 0; p < particles.size; ++p)
  {
    for (int d = 0; d < D; ++d)
      particles.position(p, d) += (refined ? 0.1 : 1.0) * number(engine);
    for (int k = 0; k < symmetricSize<D>; ++k)
      particles.stress(p, k) = number(engine);
    for (int k = 0; k < gradientSize<D>; ++k)
      particles.deformation(p, k) = k % (D + 1) == 0 ? 1.0 : 0.0;
  }
  particles.store(state);
  sortState(state);
  storeStencils(state);
  EXPECT_EQ(state.stored.count > 0, refined);
  const HostParticles<D> before(state);
  clearNodes(state);
  scatter(state, ScatterWhat::All);
  const auto sums = onHost(state.mesh.nodes.sums);
  const auto velocity = Kokkos::create_mirror_view(state.mesh.nodes.projection);
  double onNodes = 0.0, size = 0.0;
  for (std::size_t n = 0; n < velocity.extent(0); ++n)
    for (int d = 0; d < D; ++d)
    {
      velocity(n, d) = number(engine);
      const double power = sums(n, Nodes<D>::forceAt + d) * velocity(n, d);
      onNodes += power;
      size += std::fabs(power);
    }
  Kokkos::deep_copy(state.mesh.nodes.projection, velocity);
  state.clock.dt = 1e-3;
  strainAndMove(state, StrainVelocity::Projection, true, false);
  const HostParticles<D> after(state);
  const auto volume = onHost(state.particles.scalar(fields::volume));
  double inParticles = 0.0;
  for (int p = 0; p < after.size; ++p)
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
        inParticles -= volume(p) * before.stress(p, symmetricIndex<D>(i, j)) *
                       (after.deformation(p, i * D + j) - (i == j ? 1.0 : 0.0)) / state.clock.dt;
  EXPECT_GT(size, 0.1);
  // F is known to 1e-16, its change of 1e-3 to 1e-13.
  EXPECT_NEAR(onNodes, inParticles, 1e-12 * size);
}

} // namespace

TEST(ShearStrain, LinearFieldsIn2D)
{
  linearFields<2, ShapeKind::Linear>();
  linearFields<2, ShapeKind::Gimp>();
}

TEST(ShearStrain, LinearFieldsIn3D)
{
  linearFields<3, ShapeKind::Linear>();
  linearFields<3, ShapeKind::Gimp>();
}

TEST(ShearStrain, ProductsAreTables)
{
  productsAreTables<2, ShapeKind::Linear>();
  productsAreTables<2, ShapeKind::Gimp>();
  productsAreTables<3, ShapeKind::Linear>();
  productsAreTables<3, ShapeKind::Gimp>();
}

TEST(ShearStrain, VanishesInABentCell)
{
  bentCell<2>();
  bentCell<3>();
}

TEST(ShearStrain, ForceIsAdjointIn2D)
{
  for (const char* shape : {"Linear", "GIMP"})
    for (const bool refined : {false, true})
      forceIsAdjoint<2>(shape, refined);
}

TEST(ShearStrain, ForceIsAdjointIn3D)
{
  for (const char* shape : {"Linear", "GIMP"})
    for (const bool refined : {false, true})
      forceIsAdjoint<3>(shape, refined);
}

} // namespace Test
} // namespace Rhegma
