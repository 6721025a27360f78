/// The examples in which cells follow what moves: how many particles are left in the end, how far the motion
/// is from that with fine cells everywhere and how far coarse cells are, and that remeshing keeps the energy
/// balance.

#include "../../src/step/Bodies.hpp"
#include "state/EnergySums.hpp"

#include <cmath>
#include <cstdio>
#include <map>

namespace Rhegma
{
namespace Test
{

namespace
{

constexpr int samples = 5;

/// The scene of an example. \param cell its coarse cells [m] \param level of all cells; -1: as the scene has
/// it
template <int D>
Teuchos::ParameterList example(const std::string& name, const std::vector<std::string>& overrides,
                               double cell, int level)
{
  const SceneResult scene = readScene(
      std::string(RHEGMA_SOURCE_DIR) + "/xml_inputs/examples/" + name + ".xml", overrides, effectSchema());
  for (const SceneError& error : scene.errors)
    ADD_FAILURE() << toString(error);
  Teuchos::ParameterList list(*scene.list);
  EXPECT_EQ(list.sublist("Domain").get<double>("Cell Size"), cell);
  if (level >= 0)
  {
    list.remove("Adaptivity");
    list.sublist("Domain").set("Cell Size", std::ldexp(cell, -level));
  }
  return list;
}

/// Mass and momentum of the material that starts in each cell of an undeformed lattice.
template <int D>
struct CellMotion
{
  double mass = 0.0;
  Vector<D> momentum{};
};
template <int D>
using Motion = std::map<std::array<int, D>, CellMotion<D>>;

template <int D>
Motion<D> motionOf(const State<D>& state, double cell)
{
  const HostParticles<D> particles(state);
  const auto reference = onHost(state.particles.template real<D>(fields::reference));
  Motion<D> motion;
  for (int p = 0; p < particles.size; ++p)
  {
    std::array<int, D> at;
    for (int d = 0; d < D; ++d)
      at[d] = static_cast<int>(std::floor(reference(p, d) / cell));
    CellMotion<D>& fraction = motion[at];
    fraction.mass += particles.mass(p);
    for (int d = 0; d < D; ++d)
      fraction.momentum[d] += particles.mass(p) * particles.velocity(p, d);
  }
  return motion;
}

/// Changes by remeshing, as fractions of mass, energy and momentum.
struct Balance
{
  double mass = 0.0, momentum = 0.0, energy = 0.0;
};

/// Computes the sums before and after every remeshing.
template <int D>
Effect<D> accountant(Balance& balance)
{
  struct Before
  {
    double mass, energy, merged;
    Vector<D> momentum;
  };
  const auto measure = [](State<D>& state)
  {
    measureEnergy(state);
    Before now{0.0, state.energy.kinetic + state.energy.strain, state.energy.merged, state.sample.momentum};
    const HostParticles<D> particles(state);
    long double mass = 0.0; // many small ones, in another order each time
    for (int p = 0; p < particles.size; ++p)
      mass += particles.mass(p);
    now.mass = static_cast<double>(mass);
    return now;
  };
  const auto before = std::make_shared<Before>();
  Effect<D> effect;
  effect.name = "Accountant";
  effect.call(
      {Stage::BetweenSteps, "balance before", {}, {quantity::crackGeometry}, {}, [=](State<D>& state) {
         *before = measure(state);
       }});
  effect.call({Stage::BetweenSteps,
               "balance after",
               {ifWritten(quantity::cells)},
               {},
               {},
               [=, &balance](State<D>& state)
               {
                 const Before after = measure(state);
                 balance.mass = std::max(balance.mass, std::fabs(after.mass / before->mass - 1.0));
                 const double energy = after.energy + after.merged - before->merged - before->energy;
                 if (before->energy > 0.0)
                 {
                   balance.energy = std::max(balance.energy, std::fabs(energy) / before->energy);
                   const double size = std::sqrt(2.0 * before->mass * before->energy);
                   balance.momentum =
                       std::max(balance.momentum, norm(after.momentum - before->momentum) / size);
                 }
               }});
  return effect;
}

template <int D>
struct Followed
{
  std::vector<Motion<D>> motion; ///< at equal times, the last one the end
  int first = 0, last = 0, most = 0;
  double particleSteps = 0.0;
  Balance balance;
};

template <int D>
Followed<D> follow(const Teuchos::ParameterList& scene, double cell)
{
  Followed<D> followed;
  Run<D> run(scene, {accountant<D>(followed.balance)});
  run.initialize();
  State<D>& state = run.state();
  followed.first = followed.most = state.particles.size();
  const double end = scene.sublist("Time").template get<double>("Final Time");
  for (int k = 1; k <= samples; ++k)
  {
    const double until = end * k / samples;
    while (state.clock.time < until)
    {
      run.step(until, false);
      followed.most = std::max(followed.most, state.particles.size());
    }
    followed.motion.push_back(motionOf<D>(state, cell));
  }
  followed.last = state.particles.size();
  followed.particleSteps = state.particles.particleSteps;
  return followed;
}

/// Root of the mean over all samples of the kinetic energy of the difference over that of `right`.
template <int D>
double difference(const Followed<D>& one, const Followed<D>& right)
{
  double off = 0.0, all = 0.0;
  for (int k = 0; k < samples; ++k)
    for (const auto& cell : right.motion[k])
    {
      const auto same = one.motion[k].find(cell.first);
      if (same == one.motion[k].end())
      {
        ADD_FAILURE() << "no material of a cell";
        return 1.0;
      }
      const Vector<D> v = (1.0 / cell.second.mass) * cell.second.momentum;
      const Vector<D> d = (1.0 / same->second.mass) * same->second.momentum - v;
      off += cell.second.mass * dot(d, d);
      all += cell.second.mass * dot(v, v);
    }
  return std::sqrt(off / all);
}

/// Bound of the difference of adaptive and fine cells: the error of fine cells, a third of the difference of
/// coarse and fine cells, as errors go with the square of the cell (Richardson). The waves of a few coarse
/// cells that make up most of that difference are worse off in fine cells.
template <int D>
void checkTracking(const std::string& name, const std::vector<std::string>& overrides, double cell)
{
  const Followed<D> adaptive = follow<D>(example<D>(name, overrides, cell, -1), cell);
  const Followed<D> fine = follow<D>(example<D>(name, overrides, cell, 1), cell);
  const Followed<D> coarse = follow<D>(example<D>(name, overrides, cell, 0), cell);
  const double off = difference(adaptive, fine), coarseOff = difference(coarse, fine);
  std::printf(
      "%s: %d particles, %d at most, %d in the end, %d in small cells; %.3f of their steps of particles; off "
      "by %.1f %%, large cells by %.1f %%; remeshing changed mass by %.1e, momentum %.1e, energy %.1e\n",
      name.c_str(), adaptive.first, adaptive.most, adaptive.last, fine.last,
      adaptive.particleSteps / fine.particleSteps, 100.0 * off, 100.0 * coarseOff, adaptive.balance.mass,
      adaptive.balance.momentum, adaptive.balance.energy);
  EXPECT_GT(adaptive.most, adaptive.first);
  EXPECT_NEAR(adaptive.last, adaptive.first, 0.2 * adaptive.first);
  EXPECT_LT(off, coarseOff / 3.0);
  EXPECT_LT(adaptive.particleSteps, fine.particleSteps);
  EXPECT_LT(adaptive.balance.mass, 1e-13);
  EXPECT_LT(adaptive.balance.momentum, 1e-12);
  EXPECT_LT(adaptive.balance.energy, 1e-10);
}

} // namespace

/// Half as high as the example: it does not change along the height.
TEST(Tracking, AWave)
{
  checkTracking<2>("adaptive_wave",
                   {"Bodies:Plate:Upper Corner={1.2, 0.005}", "Boundaries:Hammer:To={0, 0.005}",
                    "Boundaries:Ceiling:Position=0.005"},
                   2.5e-3);
}

/// Half as long as the example.
TEST(Tracking, AnImpactIn3D)
{
  checkTracking<3>("impact_adaptive",
                   {"Bodies:Rod:Upper Corner={0.11, 0.02, 0.02}", "Domain:Upper Corner={0.16, 0.04, 0.04}",
                    "Time:Final Time=4.8e-3"},
                   5e-3);
}

} // namespace Test
} // namespace Rhegma
