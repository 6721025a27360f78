/// What a step of equilibrium reports in addition to the displacement: works and energies, and the pieces of
/// the bodies that can move.

#include "equilibrium/Newton.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>

namespace Rhegma::equilibrium
{

template <int D>
Values NewtonStep<D>::forcesOfStart(const State<D>& state, const Values& atStart) const
{
  Values minusStored("rhegma::equilibrium::stored", D * graph_.rows);
  if (state.materials.thermo.empty())
    return minusStored;
  const Values none("rhegma::equilibrium::none", D * graph_.rows),
      minusLaw("rhegma::equilibrium::law", D * graph_.rows);
  subtractStoredForce(state, graph_, minusStored);
  subtractInternalForce(state, graph_, none, minusLaw);
  addOverRanks(state, graph_, minusStored);
  addOverRanks(state, graph_, minusLaw);
  for (int k = 0; k < D * graph_.rows; ++k)
  {
    atStart(k) += minusStored(k) - minusLaw(k);
    minusStored(k) = -minusStored(k);
  }
  return minusStored;
}

template <int D>
void NewtonStep<D>::findWork(const State<D>& state, const Values& atStart)
{
  const Values ofStress = forcesOfStart(state, atStart);
  workOfSupports_ = workOfStart_ = workOfLoadsOnStart_ = 0.0;
  for (int k = 0; k < D * graph_.rows; ++k)
  {
    const bool held = held_.is[k] != 0;
    reaction_(k) = held ? -residual_(k) : 0.0;
    if (!owners_.owns(k / D))
      continue;
    workOfSupports_ -= held ? 0.5 * (residual_(k) + atStart(k)) * displacement_(k) : 0.0;
    workOfStart_ += held ? 0.0 : 0.5 * ofStress(k) * displacement_(k);
  }
  if (state.clock.step > 0 || state.materials.thermo.empty())
    return;
  splitWork(state, ofStress);
  double works[] = {workOfStart_, workOfLoadsOnStart_, workOfSupports_};
  for (int k = 0; k < D * graph_.rows; ++k)
    works[1] += owners_.owns(k / D) ? 0.5 * load_(k) * displacement_(k) : 0.0;
  owners_.ranks().sum(works, 3);
  const double ofStart = std::fabs(works[0]), all = ofStart + std::fabs(works[1]) + std::fabs(works[2]);
  // Only as much of it: loads follow a path of their own.
  workOfStart_ += all > 0.0 ? ofStart / all * workOfBentPath(state) : 0.0;
}

template <int D>
void NewtonStep<D>::splitWork(const State<D>& state, const Values& ofStress)
{
  const int n = D * graph_.rows;
  const Values right("rhegma::equilibrium::loads", n), ofLoads("rhegma::equilibrium::ofLoads", n);
  double acts = 0.0;
  for (int k = 0; k < n; ++k)
  {
    right(k) = owners_.owns(k / D) ? load_(k) : 0.0; // loads count once
    ofLoads(k) = held_.is[k] != 0 ? displacement_(k) : 0.0;
    acts = right(k) != 0.0 || ofLoads(k) != 0.0 ? 1.0 : acts;
  }
  // Without a misfit at the start there is nothing to divide.
  if (owners_.ranks().max(acts) == 0.0 || owners_.ranks().max(norm(ofStress, false)) == 0.0)
    return;
  if (!modes_.empty())
    removeResultants(modes_, pieceOf_, position_, mass_, owners_, right);
  // Of loads and not of the stress, which may release a hundred times as much: an error of the linear
  // solution is a part of what is divided.
  const LinearGoal goal{forceTolerance * norm(right, false)};
  if (!assemble(state) || !solveWithLast(state, right, goal, false, ofLoads).solved)
    return;
  copyFromOwners(state, graph_, owners_, ofLoads);
  removeRigidMotion(ofLoads);
  for (int k = 0; k < n; ++k)
    workOfLoadsOnStart_ += owners_.owns(k / D) && held_.is[k] == 0 ? 0.5 * ofStress(k) * ofLoads(k) : 0.0;
  workOfStart_ -= workOfLoadsOnStart_;
}

template <int D>
double NewtonStep<D>::workOfBentPath(const State<D>& state) const
{
  const int n = D * graph_.rows;
  const Values at("rhegma::equilibrium::onPath", n);
  // Simpson's rule is exact for a strain energy of the fourth order in the displacement, which that of
  // Green's strain is: (f0 + 4 f1/2 + f1) / 6 - (f0 + f1) / 2.
  double bent = 0.0;
  for (const auto& [part, weight] :
       {std::pair(0.0, -1.0 / 3.0), std::pair(0.5, 2.0 / 3.0), std::pair(1.0, -1.0 / 3.0)})
  {
    for (int k = 0; k < n; ++k)
      at(k) = part * displacement_(k);
    const Values minusForce("rhegma::equilibrium::forceOnPath", n);
    subtractInternalForce(state, graph_, at, minusForce);
    addOverRanks(state, graph_, minusForce);
    for (int k = 0; k < n; ++k)
      bent -= owners_.owns(k / D) ? weight * minusForce(k) * displacement_(k) : 0.0;
  }
  return bent;
}

template <int D>
double NewtonStep<D>::ghostEnergy() const
{
  double energy = 0.0;
  for (const SlopeJump& jump : resistances_.jumps)
    for (int d = 0; d < D; ++d)
    {
      const double difference = jumpOf<D>(jump, displacement_, d);
      energy += 0.5 * jump.weight * difference * difference;
    }
  return energy;
}

template <int D>
std::vector<char> NewtonStep<D>::piecesThatResistRotation(const std::vector<int>& pieceOf, int pieces) const
{
  std::vector<double> resists(pieces, 0.0);
  for (const auto& force : resistances_.forces)
    for (const int row : force->rowsThatResistRotation())
      resists[pieceOf[row]] = 1.0;
  owners_.ranks().max(resists.data(), pieces);
  return {resists.begin(), resists.end()};
}

template <int D>
std::vector<HeldDirection<D>> NewtonStep<D>::resistanceOfHoops(const State<D>& state) const
{
  std::vector<HeldDirection<D>> hoops;
  for (int r = 0; r < graph_.rows && state.method.axisymmetric; ++r)
    if (owners_.owns(r))
    {
      hoops.push_back({r, position_[r], {}});
      hoops.back().direction[0] = 1.0;
    }
  return hoops;
}

template <int D>
void NewtonStep<D>::findFreeMotions(const State<D>& state)
{
  std::tie(pieceOf_, pieces_) = byProducts_
                                    ? findPieces(state, resistances_.coupled(Couplings::All), owners_, graph_)
                                    : findPieces(graph_, owners_);
  const std::vector<int> size = sizesOf(pieceOf_, pieces_);
  std::vector<char> unsupported(pieces_, 0);
  const std::vector<char> resists = piecesThatResistRotation(pieceOf_, pieces_);
  for (const RigidMode<D>& mode :
       freeModes<D>(pieceOf_, pieces_, position_, mass_, held_, owners_, resistanceOfHoops(state)))
    if (resists[mode.piece] != 0 && mode.turns())
      continue;                            // as if springs held it to the axes of the cells
    else if (size[mode.piece] <= (1 << D)) // no more than a cell
      unsupported[mode.piece] = 1;
    else
      modes_.push_back(mode);
  for (int r = 0; r < graph_.rows; ++r)
    if (unsupported[pieceOf_[r]] != 0)
    {
      unsupported_.push_back(r);
      for (int d = 0; d < D; ++d)
        held_.is[D * r + d] = 1;
    }
  unsupportedFields_ =
      static_cast<int>(owners_.sum(graph_.rows, [&](int r) { return unsupported[pieceOf_[r]]; }));
}

template <int D>
std::vector<int> NewtonStep<D>::sizesOf(const std::vector<int>& pieceOf, int pieces) const
{
  std::vector<double> size(pieces, 0.0);
  for (std::size_t r = 0; r < pieceOf.size(); ++r)
    size[pieceOf[r]] += owners_.owns(static_cast<int>(r)) ? 1.0 : 0.0;
  owners_.ranks().sum(size.data(), pieces);
  return {size.begin(), size.end()};
}

template <int D>
FreePiece NewtonStep<D>::pieceOfMotion(const State<D>& state, const RigidMode<D>& mode) const
{
  return describePiece(state, graph_, owners_, pieceOf_, mode, mass_);
}

template <int D>
std::vector<int> NewtonStep<D>::piecesThatStayWhole() const
{
  std::vector<double> whole(piecesApart_, 0.0); // on ranks that have a row of the piece
  const std::vector<int> all = sizesOf(pieceOf_, pieces_), apart = sizesOf(apart_, piecesApart_);
  for (std::size_t r = 0; r < apart_.size(); ++r)
    whole[apart_[r]] = apart[apart_[r]] == all[pieceOf_[r]] ? 1.0 : 0.0;
  owners_.ranks().max(whole.data(), piecesApart_);
  return {whole.begin(), whole.end()};
}

template <int D>
std::string NewtonStep<D>::motionsBetweenPieces(const State<D>& state) const
{
  if (piecesApart_ == 0)
    return {};
  std::vector<HeldDirection<D>> resisted = resistanceOfHoops(state);
  for (const auto& force : resistances_.forces)
  {
    const std::vector<HeldDirection<D>> its = force->heldDirections();
    resisted.insert(resisted.end(), its.begin(), its.end());
  }
  const std::vector<int> size = sizesOf(apart_, piecesApart_);
  std::set<std::string> lines;
  const std::vector<int> whole = piecesThatStayWhole();
  for (const RigidMode<D>& mode :
       freeModes<D>(apart_, piecesApart_, position_, mass_, held_, owners_, resisted))
    if (size[mode.piece] > (1 << D) && whole[mode.piece] == 0)
    {
      FreePiece piece = describePiece(state, graph_, owners_, apart_, mode, mass_);
      piece.isPart = true;
      lines.insert(piece.name() + " " + mode.asText());
    }
  std::string all;
  for (const std::string& line : lines)
    all += (all.empty() ? "" : "; ") + line;
  return all;
}

template <int D>
std::vector<FreePiece> NewtonStep<D>::freePieces(const State<D>& state, bool converged) const
{
  std::vector<Vector<D>> now = position_;
  for (int k = 0; k < D * graph_.rows && converged; ++k)
    now[k / D][k % D] += displacement_(k);
  std::vector<FreePiece> free = findFreePieces(state, graph_, owners_, pieceOf_, modes_, now, mass_, load_);
  if (solidPieces_ == 0)
    return free;
  std::vector<RigidMode<D>> modes =
      freeModes<D>(solid_, solidPieces_, position_, mass_, held_, owners_, resistanceOfHoops(state));
  const std::vector<char> resists = piecesThatResistRotation(solid_, solidPieces_);
  modes.erase(std::remove_if(modes.begin(), modes.end(),
                             [&](const RigidMode<D>& mode)
                             { return resists[mode.piece] != 0 && mode.turns(); }),
              modes.end());
  // A whole body that a support holds only by boxes which reach over a row of nodes was accepted at the
  // start.
  for (FreePiece& piece : findFreePieces(state, graph_, owners_, solid_, modes, now, mass_, load_))
    if (piece.isPart)
      free.push_back(std::move(piece));
  return free;
}

template Values NewtonStep<2>::forcesOfStart(const State<2>&, const Values&) const;
template void NewtonStep<2>::findWork(const State<2>&, const Values&);
template void NewtonStep<2>::splitWork(const State<2>&, const Values&);
template double NewtonStep<2>::workOfBentPath(const State<2>&) const;
template double NewtonStep<2>::ghostEnergy() const;
template Values NewtonStep<3>::forcesOfStart(const State<3>&, const Values&) const;
template void NewtonStep<3>::findWork(const State<3>&, const Values&);
template void NewtonStep<3>::splitWork(const State<3>&, const Values&);
template double NewtonStep<3>::workOfBentPath(const State<3>&) const;
template double NewtonStep<3>::ghostEnergy() const;
template std::vector<char> NewtonStep<2>::piecesThatResistRotation(const std::vector<int>&, int) const;
template std::vector<HeldDirection<2>> NewtonStep<2>::resistanceOfHoops(const State<2>&) const;
template std::vector<HeldDirection<3>> NewtonStep<3>::resistanceOfHoops(const State<3>&) const;
template void NewtonStep<2>::findFreeMotions(const State<2>&);
template std::vector<int> NewtonStep<2>::sizesOf(const std::vector<int>&, int) const;
template FreePiece NewtonStep<2>::pieceOfMotion(const State<2>&, const RigidMode<2>&) const;
template std::vector<int> NewtonStep<2>::piecesThatStayWhole() const;
template std::string NewtonStep<2>::motionsBetweenPieces(const State<2>&) const;
template std::vector<FreePiece> NewtonStep<2>::freePieces(const State<2>&, bool) const;
template std::vector<char> NewtonStep<3>::piecesThatResistRotation(const std::vector<int>&, int) const;
template void NewtonStep<3>::findFreeMotions(const State<3>&);
template std::vector<int> NewtonStep<3>::sizesOf(const std::vector<int>&, int) const;
template FreePiece NewtonStep<3>::pieceOfMotion(const State<3>&, const RigidMode<3>&) const;
template std::vector<int> NewtonStep<3>::piecesThatStayWhole() const;
template std::string NewtonStep<3>::motionsBetweenPieces(const State<3>&) const;
template std::vector<FreePiece> NewtonStep<3>::freePieces(const State<3>&, bool) const;

} // namespace Rhegma::equilibrium
