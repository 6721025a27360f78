/// The method conserves momentum in all transfers, sorts and schemes.

#include "Bodies.hpp"

#include <tuple>

namespace Rhegma
{
namespace Test
{

namespace
{

struct Momentum
{
  double total[3] = {0.0, 0.0, 0.0};
  double size = 0.0; ///< sum of |m v|
};

template <int D>
Momentum momentumOf(const State<D>& state)
{
  const HostParticles<D> particles(state);
  Momentum momentum;
  for (int p = 0; p < particles.size; ++p)
  {
    double square = 0.0;
    for (int d = 0; d < D; ++d)
    {
      momentum.total[d] += particles.mass(p) * particles.velocity(p, d);
      square += particles.velocity(p, d) * particles.velocity(p, d);
    }
    momentum.size += particles.mass(p) * std::sqrt(square);
  }
  return momentum;
}

struct Flight
{
  double error = 0.0;    ///< largest change of momentum over the sum of |m v| at the start
  double exchange = 0.0; ///< largest change of one body's momentum over the same
  int sorts = 0;
  double cells = 0.0; ///< cells that the fastest body's middle has crossed
};

/// Two rubber balls that meet obliquely: they stick, turn, squeeze and vibrate while they fly on together.
template <int D>
Flight collide(const std::string& scheme, const std::string& shape)
{
  const double radius = D == 2 ? 4.0 : 2.5;
  Vector<D> lower = all<D>(-14.0), upper = all<D>(14.0);
  upper[0] = 34.0;
  Teuchos::ParameterList scene = emptyScene<D>(lower, upper, 1.0, scheme, shape);
  addMaterial(scene, "Neo-Hookean", 0.3);
  Vector<D> left = all<D>(0.13), right = all<D>(0.27), fast = all<D>(0.01), slow = all<D>(-0.02);
  left[0] = -7.0;
  right[0] = 7.0;
  right[1] += 0.7 * radius;
  fast[0] = 0.4;
  slow[0] = 0.1;
  addBall<D>(scene, "Left", left, radius).set("Velocity", array(fast));
  addBall<D>(scene, "Right", right, radius).set("Velocity", array(slow));

  Rhegma::Run<D> run(validated(scene));
  run.initialize();
  State<D>& state = run.state();
  const Momentum start = momentumOf(state);
  Flight flight;
  const auto id = [&] { return state.particles.integer(fields::id); };
  const auto host = [&] { return onHost(id()); };
  int half = 0;
  {
    const auto body = onHost(state.particles.integer(fields::body));
    for (int p = 0; p < state.particles.size(); ++p)
      half += body(p) == 0 ? 1 : 0;
  }
  double own = 0.0;
  {
    const HostParticles<D> particles(state);
    const auto ids = host();
    for (int p = 0; p < particles.size; ++p)
      own += ids(p) < half ? particles.mass(p) * particles.velocity(p, 0) : 0.0;
  }
  while (state.clock.time < 60.0)
  {
    flight.sorts += state.particles.sorted ? 0 : 1;
    run.step(1e30, false);
    if (state.clock.step % 10 != 0)
      continue;
    const Momentum now = momentumOf(state);
    for (int d = 0; d < D; ++d)
      flight.error = std::max(flight.error, std::abs(now.total[d] - start.total[d]) / start.size);
    const HostParticles<D> particles(state);
    const auto ids = host();
    double left0 = 0.0, middle = 0.0;
    for (int p = 0; p < particles.size; ++p)
      if (ids(p) < half)
      {
        left0 += particles.mass(p) * particles.velocity(p, 0);
        middle += particles.position(p, 0) / half;
      }
    flight.exchange = std::max(flight.exchange, std::abs(left0 - own) / start.size);
    flight.cells = middle - left[0];
  }
  return flight;
}

using Method = std::tuple<std::string, std::string>;

class Bodies : public testing::TestWithParam<Method>
{
protected:
  static void check(const Flight& flight)
  {
    // The case is meaningful only if many particles have changed cells and positions in memory.
    EXPECT_GT(flight.exchange, 0.1);
    EXPECT_GT(flight.cells, 10.0);
    EXPECT_GT(flight.sorts, 5);
    EXPECT_LT(flight.error, 1e-12);
    std::printf("momentum lost over the sum of |m v|: %.2e, exchanged %.2f, %.0f cells, %d sorts\n",
                flight.error, flight.exchange, flight.cells, flight.sorts);
  }
};

} // namespace

/// Asked: 1e-12 of the sum of |m v|. Each of about 300 steps rounds sums of some 1e3 terms, 1e-16 * 300 =
/// 3e-14.
TEST_P(Bodies, CollideAndKeepMomentumIn2D)
{
  check(collide<2>(std::get<0>(GetParam()), std::get<1>(GetParam())));
}

TEST_P(Bodies, CollideAndKeepMomentumIn3D)
{
  check(collide<3>(std::get<0>(GetParam()), std::get<1>(GetParam())));
}

/// A body of two cells flies along one axis through the whole of a block and beyond. Nothing else moves that
/// would have the particles sorted anew: its own cells must.
template <int D>
void flyAlong(int axis, const std::string& scheme, const std::string& shape)
{
  Vector<D> velocity = all<D>(0.0), end = all<D>(4.0);
  velocity[axis] = 0.3;
  end[axis] = 24.0;
  Teuchos::ParameterList scene = emptyScene<D>(all<D>(0.0), end, 1.0, scheme, shape);
  addMaterial(scene, "Neo-Hookean", 0.3);
  addBox<D>(scene, "Stone", all<D>(1.0), all<D>(3.0)).set("Velocity", array(velocity));
  Rhegma::Run<D> run(validated(scene));
  run.initialize();
  State<D>& state = run.state();
  const double start = HostParticles<D>(state).position(0, axis);
  const int first = onHost(state.particles.integer(fields::id))(0);
  while (state.clock.time < 60.0)
    run.step(60.0, false);
  const HostParticles<D> particles(state);
  const auto id = onHost(state.particles.integer(fields::id));
  for (int p = 0; p < particles.size; ++p)
  {
    for (int d = 0; d < D; ++d)
      EXPECT_NEAR(particles.velocity(p, d), velocity[d], 1e-12);
    for (int k = 0; k < symmetricSize<D>; ++k)
      EXPECT_NEAR(particles.stress(p, k), 0.0, 1e-12);
    if (id(p) == first)
    {
      EXPECT_NEAR(particles.position(p, axis) - start, 18.0, 1e-11);
    }
  }
}

TEST_P(Bodies, FlyAlongEveryAxis)
{
  for (int axis = 0; axis < 2; ++axis)
    flyAlong<2>(axis, std::get<0>(GetParam()), std::get<1>(GetParam()));
  for (int axis = 0; axis < 3; ++axis)
    flyAlong<3>(axis, std::get<0>(GetParam()), std::get<1>(GetParam()));
}

INSTANTIATE_TEST_SUITE_P(Momentum, Bodies,
                         testing::Combine(testing::Values("MUSL", "USF", "USAVG"),
                                          testing::Values("Linear", "GIMP")),
                         CaseName());

} // namespace Test
} // namespace Rhegma
