// Stresses, gradients and wave speeds of particles of undeformed cells.

#include "state/CellFrame.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

namespace Rhegma
{

namespace
{

constexpr int many = 200;

template <int D>
struct Matrices
{
  View<double* [D * D]> motion { "test::motion", many };  ///< gradient of velocity in the cells
  View<double* [D * D]> force { "test::force", many };    ///< stress in the cells
  View<double*> powerOfCells{"test::powerOfCells", many}; ///< force : motion
  View<double*> powerOfBody{"test::powerOfBody", many};   ///< Kirchhoff stress : gradient in the body
  View<double*> wrongStretch{"test::wrongStretch", many}; ///< motion - gradient in the body * F
  View<double*> speed{"test::speed", many};               ///< slowestStretch
  View<double*> turnedSpeed{"test::turnedSpeed", many};   ///< the same after another turn of the body
};

/// Deformation gradients near a rotation, with stretches from 0.6 to 1.8.
template <int D>
void fill(State<D>& state, std::mt19937& engine, const Matrices<D>& all)
{
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  state.method.totalLagrangian = true;
  state.particles.add({fields::deformation, gradientSize<D>, "", ""});
  state.particles.add({fields::stress, symmetricSize<D>, "Pa", ""});
  state.particles.resize(many);
  const auto F = state.particles.template real<gradientSize<D>>(fields::deformation);
  const auto tau = state.particles.template real<symmetricSize<D>>(fields::stress);
  for (int p = 0; p < many; ++p)
  {
    const double angle = 3.0 * uniform(engine), c = std::cos(angle), s = std::sin(angle);
    double stretch[D * D];
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
        stretch[D * i + j] = i == j ? 1.2 + 0.4 * uniform(engine) : 0.2 * uniform(engine);
    for (int j = 0; j < D; ++j)
    {
      F(p, j) = c * stretch[j] - s * stretch[D + j];
      F(p, D + j) = s * stretch[j] + c * stretch[D + j];
      if constexpr (D == 3)
        F(p, 2 * D + j) = stretch[2 * D + j];
    }
    if constexpr (D == 2)
      F(p, 4) = 1.0;
    for (int k = 0; k < symmetricSize<D>; ++k)
      tau(p, k) = uniform(engine);
    for (int k = 0; k < D * D; ++k)
      all.motion(p, k) = uniform(engine);
  }
}

template <int D>
void measure(const State<D>& state, const Matrices<D>& all)
{
  const CellFrame<D> frame(state);
  const auto tau = state.particles.template real<symmetricSize<D>>(fields::stress);
  const auto deformation = state.particles.template real<gradientSize<D>>(fields::deformation);
  Kokkos::parallel_for(
      "test::cellFrame", Kokkos::RangePolicy<ExecSpace>(0, many), KOKKOS_LAMBDA(const int p) {
        double T[D * D], L[D * D];
        frame.stress(p, &tau(p, 0), T);
        for (int k = 0; k < D * D; ++k)
          L[k] = all.motion(p, k);
        frame.pushForward(p, L);
        double cells = 0.0, body = 0.0, wrong = 0.0;
        for (int i = 0; i < D; ++i)
          for (int j = 0; j < D; ++j)
          {
            cells += T[D * i + j] * all.motion(p, D * i + j);
            body += tau(p, symmetricIndex<D>(i, j)) * L[D * i + j];
            double rate = -all.motion(p, D * i + j);
            for (int k = 0; k < D; ++k)
              rate += L[D * i + k] * deformation(p, D * k + j);
            wrong = std::fmax(wrong, std::fabs(rate));
          }
        all.powerOfCells(p) = cells;
        all.powerOfBody(p) = body;
        all.wrongStretch(p) = wrong;
        double F[gradientSize<D>], turned[gradientSize<D>];
        for (int k = 0; k < gradientSize<D>; ++k)
          F[k] = turned[k] = deformation(p, k);
        for (int j = 0; j < D; ++j) // by 0.7
        {
          turned[j] = std::cos(0.7) * F[j] - std::sin(0.7) * F[D + j];
          turned[D + j] = std::sin(0.7) * F[j] + std::cos(0.7) * F[D + j];
        }
        all.speed(p) = slowestStretch<D>(F);
        all.turnedSpeed(p) = slowestStretch<D>(turned);
      });
  Kokkos::fence();
}

/// Factor of the speed of a wave along a direction of the undeformed body: |F^-T N|.
template <int D>
double factorAlong(const State<D>& state, int p, std::mt19937& engine)
{
  const auto F = state.particles.template real<gradientSize<D>>(fields::deformation);
  std::normal_distribution<double> normal;
  double N[D], size = 0.0, back[D * D], square = 0.0;
  for (double& n : N)
  {
    n = normal(engine);
    size += n * n;
  }
  inverseInAxes<D>(&F(p, 0), back);
  for (int i = 0; i < D; ++i)
  {
    double sum = 0.0;
    for (int j = 0; j < D; ++j)
      sum += back[D * j + i] * N[j];
    square += sum * sum;
  }
  return std::sqrt(square / size);
}

template <int D>
void expectSameBody()
{
  const unsigned seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 engine(seed);
  State<D> state;
  const Matrices<D> all;
  fill(state, engine, all);
  measure(state, all);
  for (int p = 0; p < many; ++p)
  {
    EXPECT_NEAR(all.powerOfCells(p), all.powerOfBody(p), 1e-12) << p;
    EXPECT_LT(all.wrongStretch(p), 1e-13) << p;
    EXPECT_NEAR(all.turnedSpeed(p), all.speed(p), 1e-12) << p;
    double largest = 0.0;
    for (int k = 0; k < 2000; ++k)
      largest = std::max(largest, factorAlong<D>(state, p, engine));
    EXPECT_LE(largest, all.speed(p) * (1.0 + 1e-12)) << p;
    if (D == 2) // there it is that of some direction
      EXPECT_GT(largest, 0.999 * all.speed(p)) << p;
    else // of a symmetric matrix of three rows the sums of rows are at most the root of three times that
      EXPECT_GT(std::sqrt(std::sqrt(3.0)) * largest, 0.9 * all.speed(p)) << p;
  }
}

} // namespace

TEST(CellFrame, PowerOfCellsIsThatOfTheBody2D) { expectSameBody<2>(); }
TEST(CellFrame, PowerOfCellsIsThatOfTheBody3D) { expectSameBody<3>(); }

TEST(CellFrame, StressIsKirchhoffsInDeformedCells)
{
  State<2> state;
  const Matrices<2> all;
  std::mt19937 engine(1);
  fill(state, engine, all);
  state.method.totalLagrangian = false;
  const CellFrame<2> frame(state);
  EXPECT_FALSE(frame.undeformed);
  const auto tau = state.particles.real<symmetricSize<2>>(fields::stress);
  double T[4];
  frame.stress(7, &tau(7, 0), T);
  EXPECT_EQ(T[0], tau(7, 0));
  EXPECT_EQ(T[3], tau(7, 1));
  EXPECT_EQ(T[1], tau(7, 2));
  EXPECT_EQ(T[2], tau(7, 2));
}

} // namespace Rhegma
