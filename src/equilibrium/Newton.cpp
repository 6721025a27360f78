#include "equilibrium/Newton.hpp"

#include "parallel/StopTogether.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace Rhegma::equilibrium
{

namespace
{

/// A residual that is as small as rounding of the stress can make it ends a step, where it is this fraction
/// of the forces, or these are no more than so many times rounding; a warning says so (EquilibriumCore.cpp).
constexpr double enoughForResults = 1e-3, forcesOfNoStress = 100.0;

/// Of a sum of the forces of the particles around a node: their number times that of one of them.
constexpr double roundingOfSums = 16.0 * std::numeric_limits<double>::epsilon();

constexpr int mostHalvings = 6;

/// Fraction of the slope of the energy along a change, in its place, below which the change is as good as one
/// that lowers the residual. A part that bends stretches at first, by forces that are far larger than those
/// that bend it: a limit for them allows a tenth of the change in each iteration.
constexpr double leastFall = 0.5;

/// The first iteration of a body on its yield surface takes it as elastic, and may increase the residual. So
/// may those of a free body under compression, until secants are known.
constexpr double mostRiseAtFirst = 4.0;

/// Largest residual that an iteration may lead to.
template <int D>
double mostResidual(const State<D>& state, int iteration, std::size_t freeMotions, double now)
{
  const bool mayRise = (iteration == 0 && state.particles.has(fields::history)) ||
                       (freeMotions > 0 && iteration <= static_cast<int>(freeMotions));
  return mayRise ? mostRiseAtFirst * now : now;
}

/// Iterations with the stiffness of clipped boxes, after which the boxes are used as they are.
constexpr int mostClippedIterations = 8;

/// Fraction of a residual that an iteration with an approximate stiffness may leave before it is assembled
/// anew.
constexpr double usefulFraction = 0.1;

/// Residual of a linear solution, as a fraction of what ends the step.
constexpr double linearFraction = 0.1;

/// Residual of a linear solution with an approximate stiffness, as a fraction of the residual that the
/// iteration of Newton's method before it has left, and as a fraction of the right side at most. Further
/// digits would be lost to the error of the stiffness.
constexpr double linearFractionOfStiffness = 0.1, mostLinearFraction = 1e-3;

} // namespace

template <int D>
NewtonStep<D>::NewtonStep(const State<D>& state, std::shared_ptr<LinearSystem<D>> earlier, Boxes boxes,
                          SolverChoice choice)
    : graph_(numberRows(state)), owners_(findOwners(state, graph_)), resistances_(state, graph_)
{
  const double rows = owners_.sum(graph_.rows, [](int) { return 1.0; });
  if (boxes == Boxes::MayBeClipped && LinearSystem<D>::isLarge(static_cast<int>(rows)))
  {
    byProducts_ = choice != SolverChoice::Direct && Multigrid::available() && !resistances_.haveBranches() &&
                  spanSeveralCells(state);
    boxes_ = clipBoxes(state, byProducts_ ? Clipping::ToOneCell : Clipping::LittleBeyondCells);
  }
  connect(state, resistances_, Couplings::All, boxes_, owners_, graph_);
  const bool joins = std::any_of(resistances_.forces.begin(), resistances_.forces.end(),
                                 [](const auto& force) { return force->joinsPieces(); });
  if (joins)
  {
    RowGraph apart = graph_;
    connect(state, resistances_, Couplings::WithoutJoins, boxes_, owners_, apart);
    std::tie(apart_, piecesApart_) = findPieces(apart, owners_);
  }
  if (state.cracks.growth.area > 0.0)
  {
    RowGraph solid = graph_;
    connect(state, resistances_, Couplings::OfMaterial, boxes_, owners_, solid);
    std::tie(solid_, solidPieces_) = findPieces(solid, owners_);
  }
  position_ = rowPositions(state, graph_);
  mass_ = rowMasses(state, graph_);
  held_ = findHeld(state, graph_);
  findFreeMotions(state);
  // Free pieces are held at as few unknowns as their motions take: what they exert there is rounding, for the
  // loads on a free piece balance.
  Held solved = held_;
  for (const int k : unknownsOfMotions(modes_, pieceOf_, position_, mass_, owners_))
    solved.is[k] = 1;
  if (earlier && earlier->fits(graph_, solved))
    system_ = std::move(earlier);
  else
  {
    system_ = std::make_shared<LinearSystem<D>>(graph_, owners_, position_, solved);
    if (earlier)
      system_->adopt(*earlier);
  }
  system_->choose(choice);
  const int n = D * graph_.rows;
  for (Values* values : {&load_, &displacement_, &residual_, &reaction_, &diagonal_})
    *values = Values("rhegma::equilibrium::values", n);
}

template <int D>
bool NewtonStep<D>::residual(const State<D>& state, const Values& u, const Values& r) const
{
  Kokkos::deep_copy(r, load_);
  std::vector<Vector<D>> now = position_;
  if (!modes_.empty())
  {
    for (int k = 0; k < D * graph_.rows; ++k)
      now[k / D][k % D] += u(k);
    removeResultants(modes_, pieceOf_, now, mass_, owners_, r);
  }
  for (int k = 0; k < D * graph_.rows; ++k) // loads count once
    r(k) = owners_.owns(k / D) ? r(k) : 0.0;
  for (const SlopeJump& jump : resistances_.jumps)
    for (int d = 0; d < D; ++d)
    {
      const double force = jump.weight * jumpOf<D>(jump, u, d);
      for (std::size_t a = 0; a < jump.row.size(); ++a)
        r(D * jump.row[a] + d) -= force * jump.coefficient[a];
    }
  for (const auto& force : resistances_.forces)
    force->add(u, r);
  const bool inverted = !subtractInternalForce(state, graph_, u, r);
  const bool good = owners_.ranks().max(inverted ? 1.0 : 0.0) == 0.0;
  addOverRanks(state, graph_, r);
  // Shear strain at the cells' centres is that of the cells' axes at the start of the step: as the body
  // deforms and turns, the torque of its internal forces is of the order of the strain that varies in a cell,
  // times strain.
  // The same holds where corrected broken cells at the edge of a body resist a rotation.
  const bool turnsFreely = state.method.shear == ShearStrain::AtParticles && state.cracks.dualField;
  if (good && !modes_.empty() && !turnsFreely)
    removeResultants(modes_, pieceOf_, now, mass_, owners_, r);
  return good;
}

template <int D>
bool NewtonStep<D>::assemble(const State<D>& state)
{
  product_.reset();
  if (byProducts_)
  {
    product_ = std::make_unique<TangentProduct<D>>(state, owners_, graph_, resistances_, displacement_);
    diagonal_ = product_->diagonal();
  }
  else
  {
    const bool symmetricOnly = resistances_.haveBranches() && !system_->takesUnsymmetric();
    stiffness_ =
        equilibrium::assemble(state, resistances_, displacement_, boxes_, owners_, graph_, symmetricOnly);
    for (int row = 0; row < graph_.rows; ++row)
      for (int d = 0; d < D; ++d)
        diagonal_(D * row + d) =
            stiffness_.blocks(D * D * static_cast<std::size_t>(graph_.find(row, row)) + (D + 1) * d);
  }
  for (int k = 0; k < D * graph_.rows; ++k)
    diagonal_(k) = owners_.owns(k / D) ? std::fabs(diagonal_(k)) : 0.0;
  return byProducts_ ? product_->exists() : stiffness_.exists;
}

template <int D>
LinearAnswer NewtonStep<D>::solveWithLast(const State<D>& state, const Values& right, const LinearGoal& goal,
                                          bool again, const Values& change)
{
  if (again && !byProducts_)
    return system_->solveAgain(right, goal, change);
  if (!byProducts_)
    return system_->solve(std::exchange(stiffness_.blocks, {}), stiffness_.symmetric, right, goal, change);
  const MakeBlocks approximate = [&] {
    return equilibrium::assemble(state, resistances_, displacement_, boxes_, owners_, graph_, false).blocks;
  };
  return system_->solve(*product_, approximate, right, goal, change);
}

template <int D>
bool NewtonStep<D>::isRounding(const State<D>& state, double residual, double forces) const
{
  if (residual <= roundingOfForces * forces)
    return true;
  // Strain is known to rounding of 1 and of the displacements of nodes over the size of a cell.
  double sum = 0.0;
  for (int k = 0; k < D * graph_.rows; ++k)
    if (const double force = diagonal_(k) * (state.mesh.grid.spacing + std::fabs(displacement_(k)));
        owners_.owns(k / D))
      sum += force * force;
  const double rounding = roundingOfSums * std::sqrt(owners_.ranks().sum(sum));
  return residual <= rounding &&
         (residual <= enoughForResults * forces || forces <= forcesOfNoStress * rounding);
}

template <int D>
void NewtonStep<D>::updateForces(const State<D>& state)
{
  bool changed = false;
  for (const auto& force : resistances_.forces)
    changed = force->update() || changed;
  if (owners_.ranks().max(changed ? 1.0 : 0.0) > 0.0)
    residual(state, displacement_, residual_);
}

template <int D>
void NewtonStep<D>::removeRigidMotion(const Values& change) const
{
  if (modes_.empty())
    return;
  const Values momentum("rhegma::equilibrium::momentum", change.extent(0));
  for (std::size_t k = 0; k < change.extent(0); ++k)
    momentum(k) = mass_[k / D] * change(k);
  removeResultants(modes_, pieceOf_, position_, mass_, owners_, momentum);
  // A free motion leaves in place what supports hold: what it has there is rounding.
  for (std::size_t k = 0; k < change.extent(0); ++k)
    if (held_.is[k] == 0 && mass_[k / D] > 0.0)
      change(k) = momentum(k) / mass_[k / D];
}

template <int D>
SecantMixing NewtonStep<D>::mixingOfFreeMotions() const
{
  constexpr int most = 6; // secants: the rotations of two bodies in 3D
  const auto product = [this](const Values& a, const Values& b)
  {
    double sum = 0.0;
    for (int k = 0; k < D * graph_.rows; ++k)
      if (owners_.owns(k / D))
        sum += a(k) * b(k);
    return owners_.ranks().sum(sum);
  };
  return {std::min(static_cast<int>(modes_.size()), most), product};
}

template <int D>
double NewtonStep<D>::norm(const Values& r, bool held) const
{
  double sum = 0.0;
  for (int k = 0; k < D * graph_.rows; ++k)
    if ((held_.is[k] != 0) == held && owners_.owns(k / D))
      sum += r(k) * r(k);
  return std::sqrt(owners_.ranks().sum(sum));
}

template <int D>
double NewtonStep<D>::slopeAlong(const Values& change) const
{
  double sum = 0.0;
  for (int k = 0; k < D * graph_.rows; ++k)
    if (held_.is[k] == 0 && owners_.owns(k / D))
      sum += residual_(k) * change(k);
  return owners_.ranks().sum(sum);
}

template <int D>
bool NewtonStep<D>::search(const State<D>& state, const Values& change, double before, double enough)
{
  const Values start("rhegma::equilibrium::start", displacement_.extent(0));
  Kokkos::deep_copy(start, displacement_);
  const bool hasEnergy = !resistances_.haveBranches() && !state.particles.has(fields::history);
  const double slope = hasEnergy && std::isfinite(before) ? slopeAlong(change) : 0.0;
  double fraction = 1.0;
  for (int k = 0; k <= mostHalvings; ++k, fraction *= 0.5)
  {
    for (std::size_t i = 0; i < start.extent(0); ++i)
      displacement_(i) = start(i) + fraction * change(i);
    if (!residual(state, displacement_, residual_))
      continue;
    const double now = norm(residual_, false);
    if (now < before || now <= enough || (slope > 0.0 && std::fabs(slopeAlong(change)) < leastFall * slope))
      return true;
  }
  Kokkos::deep_copy(displacement_, start);
  residual(state, displacement_, residual_);
  return false;
}

template <int D>
bool NewtonStep<D>::searchWith(SecantMixing* mixing, const State<D>& state, const Values& change,
                               double before, double enough)
{
  if (mixing == nullptr)
    return search(state, change, before, enough);
  const Values plain("rhegma::equilibrium::plainChange", change.extent(0));
  Kokkos::deep_copy(plain, change);
  mixing->improve(displacement_, change);
  if (search(state, change, before, enough))
    return true;
  *mixing = mixingOfFreeMotions(); // secants mean nothing where the law changes, as when material yields
  return search(state, plain, before, enough);
}

template <int D>
int NewtonStep<D>::iterationsFor(int most) const
{
  return most > 1 && resistances_.haveBranches() ? std::max(most, mostIterationsWithBranches) : most;
}

template <int D>
bool NewtonStep<D>::supportsAreInPlace() const
{
  double apart = 0.0;
  for (int i = 0; i < D * graph_.rows; ++i)
    if (held_.is[i] != 0 &&
        std::fabs(held_.change[i] - displacement_(i)) > 1e-12 * std::fabs(held_.change[i]))
      apart = 1.0;
  return owners_.ranks().max(apart) == 0.0;
}

template <int D>
bool NewtonStep<D>::keepsStiffness(double before, double now, double forces) const
{
  if (resistances_.haveBranches())
    return false;
  const double fraction = now / before;
  return fraction * now <= forceTolerance * forces || (boxes_.any() && fraction <= usefulFraction);
}

template <int D>
void NewtonStep<D>::explain(const State<D>& state, StepReport& report) const
{
  report.freeMotion = report.reason = motionsBetweenPieces(state);
  for (const auto& force : resistances_.forces)
    if (const std::string one = force->reason(); !one.empty())
      report.reason += (report.reason.empty() ? "" : "; ") + one;
}

template <int D>
double NewtonStep<D>::takeLoads(const State<D>& state)
{
  for (int k = 0; k < D * graph_.rows; ++k)
    load_(k) = state.mesh.nodes.sums(graph_.nodeOf(k / D), Nodes<D>::forceAt + k % D);
  double idle = 0.0;
  for (const int r : unsupported_)
  {
    double square = 0.0;
    for (int d = 0; d < D && owners_.owns(r); ++d)
      square += load_(D * r + d) * load_(D * r + d);
    idle += std::sqrt(square);
  }
  return owners_.ranks().sum(idle);
}

template <int D>
LinearAnswer NewtonStep<D>::solveLinear(const State<D>& state, const LinearGoal& goal, bool keeps,
                                        const Values& change)
{
  for (int i = 0; i < D * graph_.rows; ++i)
    change(i) = held_.is[i] != 0 ? held_.change[i] - displacement_(i) : 0.0;
  LinearAnswer answer = solveWithLast(state, residual_, goal, keeps, change);
  copyFromOwners(state, graph_, owners_, change);
  removeRigidMotion(change);
  return answer;
}

template <int D>
StepReport NewtonStep<D>::solve(const State<D>& state, double largestForces, int most, double enoughAtStart)
{
  StepReport report;
  report.forces = largestForces;
  const int n = D * graph_.rows;
  report.unsupportedLoad = takeLoads(state);
  Kokkos::deep_copy(displacement_, 0.0);
  if (!residual(state, displacement_, residual_))
    return report;
  Values atStart("rhegma::equilibrium::atStart", n), change("rhegma::equilibrium::change", n);
  Kokkos::deep_copy(atStart, residual_);
  // A free body that heat strains has no other forces.
  report.forces = std::max(report.forces, norm(atStart, false));
  bool keeps = false; // the last stiffness
  SecantMixing mixing = mixingOfFreeMotions();
  bool moved = !supportsAreInPlace();
  double ofStiffness = mostLinearFraction; // see LinearGoal::fraction
  most = iterationsFor(hasClippedStiffness() ? std::min(most, mostClippedIterations) : most);
  for (int k = 0; k <= most; ++k)
  {
    stopTogetherIfRequested(owners_.ranks());
    // A body that is unloaded has forces of its own size no longer.
    report.forces = std::max({report.forces, norm(load_, false), norm(residual_, true)});
    const double forces = report.forces, now = norm(residual_, false);
    report.residuals.push_back(forces > 0.0 ? now / forces : 0.0);
    if (onIteration_)
      onIteration_(k, report.residuals.back());
    const bool falls = k == 0 || report.residuals[k] < 0.5 * report.residuals[k - 1];
    report.converged =
        !moved && (report.residuals[k] <= std::max(forceTolerance, k == 0 ? enoughAtStart : 0.0) ||
                   (k == most && !falls && isRounding(state, now, forces)));
    if (report.converged || k == most || !std::isfinite(forces) || (!keeps && !assemble(state)))
      break;
    const LinearGoal goal{linearFraction * forceTolerance * forces, boxes_.any() ? ofStiffness : 0.0};
    const LinearAnswer answer = solveLinear(state, goal, keeps, change);
    report.linearIterations += answer.iterations;
    report.negativeEigenvalues = answer.negativeEigenvalues;
    report.unsolvable = answer.failure;
    // Before the supports have moved there is no residual to compare with.
    const double bound =
        moved ? std::numeric_limits<double>::infinity() : mostResidual(state, k, modes_.size(), now);
    const bool mixes = !modes_.empty() && !moved && k > 0;
    if (!answer.solved ||
        !searchWith(mixes ? &mixing : nullptr, state, change, bound, forceTolerance * forces))
    {
      report.converged = answer.solved && !moved && isRounding(state, now, forces);
      break;
    }
    const double left = norm(residual_, false);
    report.bends = report.bends || left > std::max(bound, forceTolerance * forces);
    ofStiffness = std::min(mostLinearFraction, linearFractionOfStiffness * left / (moved ? forces : now));
    keeps = keepsStiffness(moved ? forces : now, left, forces);
    moved = !supportsAreInPlace();
    keeps = keeps && !moved;
    updateForces(state);
  }
  explain(state, report);
  report.freePieces = freePieces(state, report.converged);
  if (most > 0)
    findWork(state, atStart);
  return report;
}

template class NewtonStep<2>;
template class NewtonStep<3>;

} // namespace Rhegma::equilibrium
