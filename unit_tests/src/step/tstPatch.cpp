/// Patch test through the transfer kernels: a linear velocity gives every particle the same stress, and the
/// same stress everywhere gives no force on nodes inside the body.

#include "Bodies.hpp"

#include "material/Materials.hpp"
#include "step/CoreStep.hpp"
#include "transfer/Gather.hpp"
#include "transfer/Scatter.hpp"

#include <random>

namespace Rhegma
{
namespace Test
{

namespace
{

constexpr double side = 6.0; // of the body, in cells of 1 m
constexpr int drifts = 25;

/// A cube that starts on the lattice, two particles a cell and axis.
template <int D>
Rhegma::Run<D> cube(const std::string& shape)
{
  Teuchos::ParameterList scene = emptyScene<D>(all<D>(-4.0), all<D>(14.0), 1.0, "MUSL", shape);
  addMaterial(scene, "Neo-Hookean", 0.3);
  addBox<D>(scene, "Cube", all<D>(0.0), all<D>(side));
  Rhegma::Run<D> run(validated(scene));
  run.initialize();
  return run;
}

template <int D>
Vector<D> offTheLattice()
{
  Vector<D> shift = all<D>(0.68);
  shift[0] = 0.21;
  shift[1] = 1.37;
  return shift;
}

/// Moves the body as a whole.
template <int D>
void drift(State<D>& state, const Vector<D>& shift)
{
  moveBody(state, shift);
  sortState(state);
}

/// One step of 1 s with the velocity L x at the nodes, by the kernel that every step uses.
template <int D>
void strainBy(State<D>& state, const double (&L)[D][D])
{
  const auto motion = Kokkos::create_mirror_view(state.mesh.nodes.motion);
  Kokkos::deep_copy(motion, 0.0);
  for (int n = 0; n < state.mesh.grid.numNodes; ++n)
  {
    const Vector<D> x = state.mesh.grid.nodePosition(n);
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
        motion(n, i) += L[i][j] * x[j];
  }
  Kokkos::deep_copy(state.mesh.nodes.motion, motion);
  state.clock.dt = 1.0;
  ASSERT_TRUE(std::isfinite(strainAndMove(state, StrainVelocity::Motion, true, true)));
  ASSERT_EQ(state.failure, "");
  sortState(state);
}

/// The largest internal force on a node whose cells the body fills, over the largest stress times the face of
/// a cell. \param lower, upper corners of the body
template <int D>
double residual(State<D>& state, const Vector<D>& lower, const Vector<D>& upper)
{
  clearNodes(state);
  scatter(state, ScatterWhat::Force);
  const auto sums = onHost(state.mesh.nodes.sums);
  double largest = 0.0;
  int inside = 0;
  for (int n = 0; n < state.mesh.grid.numNodes; ++n)
  {
    const Vector<D> x = state.mesh.grid.nodePosition(n);
    bool in = true;
    for (int d = 0; d < D; ++d)
      in = in && x[d] - 1.0 >= lower[d] - 1e-9 && x[d] + 1.0 <= upper[d] + 1e-9;
    if (!in)
      continue;
    ++inside;
    for (int d = 0; d < D; ++d)
      largest = std::max(largest, std::abs(sums(n, Nodes<D>::forceAt + d)));
  }
  EXPECT_GE(inside, D == 2 ? 16 : 64);
  const HostParticles<D> particles(state);
  double stress = 0.0;
  for (int k = 0; k < symmetricSize<D>; ++k)
    stress = std::max(stress, std::abs(particles.stress(0, k)));
  EXPECT_GT(stress, 0.01);
  return largest / stress;
}

/// The largest residual over many positions of the body relative to the cells; the first is where it started.
template <int D>
double worstAfterDrift(const std::string& shape)
{
  Rhegma::Run<D> run = cube<D>(shape);
  State<D>& state = run.state();
  setUniformStress(state);
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> anywhere(-0.4, 0.4);
  Vector<D> lower = all<D>(0.0);
  double worst = 0.0;
  for (int k = 0; k < drifts; ++k)
  {
    Vector<D> shift;
    for (int d = 0; d < D; ++d)
      shift[d] = anywhere(engine) + (lower[d] > 3.0 ? -1.0 : 0.3);
    drift(state, shift);
    lower = lower + shift;
    worst = std::max(worst, residual<D>(state, lower, lower + all<D>(side)));
  }
  return worst;
}

template <int D>
double onTheLattice(const std::string& shape)
{
  Rhegma::Run<D> run = cube<D>(shape);
  sortState(run.state());
  setUniformStress(run.state());
  return residual<D>(run.state(), all<D>(0.0), all<D>(side));
}

/// The largest difference between the particles' stress and that of one particle that has 1 + L, over the
/// largest component.
template <int D>
double stressSpread(const State<D>& state, const double (&L)[D][D])
{
  double F[gradientSize<D>] = {}, tau[symmetricSize<D>];
  if (D == 2)
    F[gradientSize<D> - 1] = 1.0;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j)
      F[i * D + j] = L[i][j] + (i == j ? 1.0 : 0.0);
  EXPECT_TRUE(updateStress<D>(state.materials.properties[0], F, tau, nullptr));
  const HostParticles<D> particles(state);
  double spread = 0.0, size = 0.0;
  for (int k = 0; k < symmetricSize<D>; ++k)
  {
    size = std::max(size, std::abs(tau[k]));
    for (int p = 0; p < particles.size; ++p)
      spread = std::max(spread, std::abs(particles.stress(p, k) - tau[k]));
  }
  return spread / size;
}

template <int D>
void checkUniformStress(const std::string& shape)
{
  const Vector<D> shift = offTheLattice<D>();
  double L[D][D];
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j)
      L[i][j] = 0.07 * (i + 1) - 0.05 * j;
  for (const bool moved : {false, true})
  {
    Rhegma::Run<D> run = cube<D>(shape);
    drift(run.state(), moved ? shift : all<D>(0.0));
    strainBy<D>(run.state(), L);
    const double spread = stressSpread<D>(run.state(), L);
    std::printf("%s, %dD, %s: stress off by %.1e\n", shape.c_str(), D, moved ? "drifted" : "lattice", spread);
    EXPECT_LT(spread, 1e-12);
  }
}

/// Stretched along the axes and drifted: the boxes follow F, so that they tile the stretched body.
template <int D>
double afterStretch(const std::string& shape)
{
  Rhegma::Run<D> run = cube<D>(shape);
  State<D>& state = run.state();
  const Vector<D> shift = offTheLattice<D>();
  drift(state, shift);
  double L[D][D] = {};
  Vector<D> lower = shift, upper = shift + all<D>(side);
  for (int d = 0; d < D; ++d)
  {
    L[d][d] = 0.13 - 0.11 * d;
    lower[d] *= 1.0 + L[d][d];
    upper[d] *= 1.0 + L[d][d];
  }
  strainBy<D>(state, L);
  EXPECT_LT(stressSpread<D>(state, L), 1e-12);
  return residual<D>(state, lower, upper);
}

template <int D>
void checkForces()
{
  const double linear = onTheLattice<D>("Linear"), gimp = onTheLattice<D>("GIMP");
  const double linearMoved = worstAfterDrift<D>("Linear"), gimpMoved = worstAfterDrift<D>("GIMP");
  const double linearStretched = afterStretch<D>("Linear"), gimpStretched = afterStretch<D>("GIMP");
  std::printf(
      "%dD, force inside over stress x face: lattice linear %.1e, GIMP %.1e; drifted linear %.1e, GIMP "
      "%.1e; stretched linear %.2f, GIMP %.1e\n",
      D, linear, gimp, linearMoved, gimpMoved, linearStretched, gimpStretched);
  EXPECT_LT(linear, 1e-12);
  EXPECT_LT(gimp, 1e-12);
  // A cell has two particles an axis wherever it lies on a body whose particles are half a cell apart.
  EXPECT_LT(linearMoved, 1e-12);
  EXPECT_LT(gimpMoved, 1e-12);
  EXPECT_LT(gimpStretched, 1e-12);
  // Elsewhere one cell has more particles than its neighbour, and points feel it. Were this zero, the patch
  // test would see nothing.
  EXPECT_GT(linearStretched, 0.1);
}

} // namespace

TEST(Patch, UniformStressIsReproducedIn2D)
{
  checkUniformStress<2>("Linear");
  checkUniformStress<2>("GIMP");
}

TEST(Patch, UniformStressIsReproducedIn3D)
{
  checkUniformStress<3>("Linear");
  checkUniformStress<3>("GIMP");
}

TEST(Patch, UniformStressLeavesNoForceInsideIn2D) { checkForces<2>(); }

TEST(Patch, UniformStressLeavesNoForceInsideIn3D) { checkForces<3>(); }

} // namespace Test
} // namespace Rhegma
