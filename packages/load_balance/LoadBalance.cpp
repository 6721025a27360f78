#include "load_balance/LoadBalance.hpp"

#include "archive/Archive.hpp"
#include "state/Subdomain.hpp"

#include <Kokkos_Timer.hpp>
#include <algorithm>
#include <cmath>
#include <memory>

namespace Rhegma::load_balance
{

namespace
{

/// The entries of summary.json.
struct Account
{
  long checks = 0, divisions = 0;
  double worst = 1.0, last = 1.0; ///< largest over mean cost of a rank, as found
  double left = 1.0;              ///< the same after the last division
  double seconds = 0.0;
};

/// Growth of the remaining imbalance, as a factor, from which another division is worthwhile.
constexpr double grown = 1.02;

Section section()
{
  Section s("Load Balance", "Dynamic load balance: redistributes cells and particles over the MPI ranks. "
                            "Without this section each rank keeps its initial subdomain.");
  s.refuse({when::present("Load Balance"), when::equilibrium()},
           "load steps of an equilibrium keep the first division among ranks; remove this section");
  s.real("Threshold")
      .range(1.0, 1000.0)
      .byDefault(1.1)
      .meaning("Cells are redistributed when the largest cost of a rank exceeds the mean by this factor.");
  s.integer("Interval")
      .atLeast(1)
      .byDefault(20)
      .meaning("Number of time steps between two checks of the costs.");
  return s;
}

/// Largest over mean cost of the ranks.
template <int D>
double imbalance(const State<D>& state)
{
  const double own = costOfParticles(state);
  const double mean = state.ranks.sum(own) / state.ranks.size();
  return mean > 0.0 ? state.ranks.max(own) / mean : 1.0;
}

template <int D>
void checkBalance(State<D>& state, double threshold, Account& account)
{
  const Kokkos::Timer timer;
  account.last = imbalance(state);
  account.worst = std::max(account.worst, account.last);
  ++account.checks;
  // Cells may be too coarse for the threshold: the imbalance that a division leaves is divided again only
  // after it has grown.
  if (state.ranks.many() && account.last > threshold && account.last > grown * account.left)
  {
    redivideState(state);
    ++account.divisions;
    account.left = account.last = imbalance(state);
  }
  account.seconds += timer.seconds();
}

template <int D>
Effect<D> make(const Teuchos::ParameterList& scene)
{
  const Teuchos::ParameterList& list = scene.sublist("Load Balance");
  const double threshold = list.get<double>("Threshold");
  const int interval = list.get<int>("Interval");
  const auto account = std::make_shared<Account>();
  Effect<D> effect;
  effect.name = "Load Balance";
  effect.call(Stage::BetweenSteps, "balance of ranks",
              {ifWritten(quantity::cells),
               ifWritten(quantity::crackGeometry)}, // fronts are measured by the nodes of the last step
              {quantity::ownership}, {},
              [=](State<D>& state)
              {
                if (state.clock.step % interval == 0)
                  checkBalance(state, threshold, *account);
              });
  effect.memory = [account](State<D>&, Archive& archive)
  {
    archive("checks", account->checks);
    archive("divisions", account->divisions);
    archive("worst", account->worst);
    archive("last", account->last);
    archive("seconds", account->seconds);
  };
  effect.report = [account](const State<D>& state, nlohmann::json& summary)
  {
    summary["load_balance"] = {{"imbalance", account->last},
                               {"largest_imbalance", account->worst},
                               {"checks", account->checks},
                               {"divisions", account->divisions},
                               {"seconds", state.ranks.max(account->seconds)}};
  };
  return effect;
}

} // namespace

EffectEntry loadBalanceEntry() { return {section(), {}, make<2>, make<3>, true}; }

template <int D>
double costOfParticles(const State<D>& state)
{
  const bool levels = state.particles.has(fields::level);
  BorrowedView<int*> level;
  if (levels)
    level = state.particles.integer(fields::level);
  double cost = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::loadBalance::cost", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p, double& sum) { sum += levels ? std::ldexp(1.0, level(p)) : 1.0; }, cost);
  return cost;
}

template double costOfParticles(const State<2>&);
template double costOfParticles(const State<3>&);

} // namespace Rhegma::load_balance
