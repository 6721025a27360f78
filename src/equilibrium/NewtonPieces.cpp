/// The pieces of the bodies and how they may move without strain.

#include "equilibrium/Newton.hpp"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

namespace Rhegma::equilibrium
{

template <int D>
std::vector<char> NewtonStep<D>::piecesThatResistRotation(const std::vector<int>& pieceOf, int pieces) const
{
  std::vector<double> resists(pieces, 0.0);
  for (const auto& force : forces_)
    for (const int row : force->rowsThatResistRotation())
      resists[pieceOf[row]] = 1.0;
  owners_.ranks().max(resists.data(), pieces);
  return {resists.begin(), resists.end()};
}

template <int D>
void NewtonStep<D>::findFreeMotions()
{
  std::tie(pieceOf_, pieces_) = findPieces(graph_, owners_);
  const std::vector<int> size = sizesOf(pieceOf_, pieces_);
  std::vector<char> unsupported(pieces_, 0);
  const std::vector<char> resists = piecesThatResistRotation(pieceOf_, pieces_);
  for (const RigidMode<D>& mode : freeModes<D>(pieceOf_, pieces_, position_, mass_, held_, owners_))
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
  std::vector<int> whole(piecesApart_, 0);
  const std::vector<int> all = sizesOf(pieceOf_, pieces_), apart = sizesOf(apart_, piecesApart_);
  for (std::size_t r = 0; r < apart_.size(); ++r)
    whole[apart_[r]] = apart[apart_[r]] == all[pieceOf_[r]] ? 1 : 0;
  return whole;
}

template <int D>
std::string NewtonStep<D>::motionsBetweenPieces(const State<D>& state) const
{
  if (piecesApart_ == 0)
    return {};
  std::vector<HeldDirection<D>> resisted;
  for (const auto& force : forces_)
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
  std::vector<RigidMode<D>> modes = freeModes<D>(solid_, solidPieces_, position_, mass_, held_, owners_);
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

template std::vector<char> NewtonStep<2>::piecesThatResistRotation(const std::vector<int>&, int) const;
template void NewtonStep<2>::findFreeMotions();
template std::vector<int> NewtonStep<2>::sizesOf(const std::vector<int>&, int) const;
template FreePiece NewtonStep<2>::pieceOfMotion(const State<2>&, const RigidMode<2>&) const;
template std::vector<int> NewtonStep<2>::piecesThatStayWhole() const;
template std::string NewtonStep<2>::motionsBetweenPieces(const State<2>&) const;
template std::vector<FreePiece> NewtonStep<2>::freePieces(const State<2>&, bool) const;
template std::vector<char> NewtonStep<3>::piecesThatResistRotation(const std::vector<int>&, int) const;
template void NewtonStep<3>::findFreeMotions();
template std::vector<int> NewtonStep<3>::sizesOf(const std::vector<int>&, int) const;
template FreePiece NewtonStep<3>::pieceOfMotion(const State<3>&, const RigidMode<3>&) const;
template std::vector<int> NewtonStep<3>::piecesThatStayWhole() const;
template std::string NewtonStep<3>::motionsBetweenPieces(const State<3>&) const;
template std::vector<FreePiece> NewtonStep<3>::freePieces(const State<3>&, bool) const;

} // namespace Rhegma::equilibrium
