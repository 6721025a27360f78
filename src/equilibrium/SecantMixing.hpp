#pragma once
/// Faster convergence of an iteration that leaves a few directions behind.

#include "equilibrium/Particles.hpp"

#include <deque>
#include <functional>

namespace Rhegma::equilibrium
{

/// Secants over the last few changes (Anderson, Journal of the ACM 12, 1965, 547, without damping; Walker and
/// Ni, SIAM Journal on Numerical Analysis 49, 2011, 1715). Where all but `depth` directions converge at once,
/// these do so in as many more iterations, whatever their rate was.
class SecantMixing
{
public:
  using Dot = std::function<double(const Values&, const Values&)>;

  /// \param depth number of secants \param dot product of two sets of values, of all ranks
  SecantMixing(int depth, Dot dot) : depth_(depth), dot_(std::move(dot)) {}

  /// Takes an iteration into account and improves its change. \param at where it started
  /// \param change that it would make; on exit the one to make
  void improve(const Values& at, const Values& change);

private:
  struct Secant
  {
    Values position, change; ///< differences of two iterations
  };

  std::size_t depth_;
  Dot dot_;
  Values lastPosition_, lastChange_;
  std::deque<Secant> secants_;
};

} // namespace Rhegma::equilibrium
