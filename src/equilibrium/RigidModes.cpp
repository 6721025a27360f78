#include "equilibrium/RigidModes.hpp"

#include "base/ShortNumber.hpp"

#include <Teuchos_LAPACK.hpp>
#include <Teuchos_SerialDenseMatrix.hpp>
#include <Teuchos_SerialDenseSolver.hpp>

#include <algorithm>
#include <numeric>

namespace Rhegma::equilibrium
{

namespace
{

/// Part of the largest eigenvalue of the supports' matrix below which a motion counts as free: a support one
/// thousandth of the body's size away from the axis still holds a rotation.
constexpr double leastHold = 1e-9;

/// Motion of a node, of a motion of length one, that is rounding: loads on an axis have no moment about it.
constexpr double roundingOfArm = 1e-6;

/// Fraction of a piece's heaviest node from which a node may hold the piece.
constexpr double leastHeldMass = 0.1;

template <int D>
std::vector<RigidMode<D>> framesOfPieces(const std::vector<int>& pieceOf, int pieces,
                                         const std::vector<Vector<D>>& position,
                                         const std::vector<double>& mass, const RowOwners& owners)
{
  std::vector<RigidMode<D>> frames(pieces);
  std::vector<double> sums(static_cast<std::size_t>(D + 1) * pieces, 0.0), size(pieces, 0.0);
  for (std::size_t r = 0; r < pieceOf.size(); ++r)
    for (int d = 0; d <= D && owners.owns(static_cast<int>(r)); ++d)
      sums[(D + 1) * pieceOf[r] + d] += d < D ? mass[r] * position[r][d] : mass[r];
  owners.ranks().sum(sums.data(), static_cast<int>(sums.size()));
  for (int k = 0; k < pieces; ++k)
  {
    frames[k].piece = k;
    for (int d = 0; d < D; ++d)
      frames[k].centre[d] = (1.0 / sums[(D + 1) * k + D]) * sums[(D + 1) * k + d];
  }
  for (std::size_t r = 0; r < pieceOf.size(); ++r)
    size[pieceOf[r]] = std::max(size[pieceOf[r]], norm(position[r] - frames[pieceOf[r]].centre));
  owners.ranks().max(size.data(), pieces);
  for (int k = 0; k < pieces; ++k)
    frames[k].size = size[k] > 0.0 ? size[k] : 1.0;
  return frames;
}

/// Turns the free motions of a piece, which are orthogonal, among themselves such that those without a
/// rotation come first: a body that can both move and turn is then said to do both.
template <int D>
void separateTranslations(std::vector<RigidMode<D>>& modes, int piece)
{
  constexpr int n = rigidMotions<D>;
  std::size_t first = modes.size();
  while (first > 0 && modes[first - 1].piece == piece)
    --first;
  const int count = static_cast<int>(modes.size() - first);
  if (count < 2)
    return;
  double rotations[n * n], values[n], work[8 * n];
  for (int a = 0; a < count; ++a)
    for (int b = 0; b < count; ++b)
      rotations[a + count * b] =
          std::inner_product(modes[first + a].coefficient + D, modes[first + a].coefficient + n,
                             modes[first + b].coefficient + D, 0.0);
  int info = 0;
  Teuchos::LAPACK<int, double>().SYEV('V', 'U', count, rotations, count, values, work, 8 * n, &info);
  double turned[n][n] = {};
  for (int v = 0; v < count; ++v)
    for (int a = 0; a < count; ++a)
      for (int m = 0; m < n; ++m)
        turned[v][m] += rotations[a + count * v] * modes[first + a].coefficient[m];
  for (int v = 0; v < count; ++v)
    std::copy_n(turned[v], n, modes[first + v].coefficient);
}

/// An unknown: the number of its row among those of all ranks, its axis and position.
template <int D>
struct UnknownAt
{
  long long number = -1;
  int axis = 0;
  Vector<D> position{};
};

/// The unknown of the rank with the largest value, of the first one with it.
template <int D>
UnknownAt<D> largestOfRanks(const Ranks& ranks, double value, const UnknownAt<D>& own)
{
  if (!ranks.many())
    return own;
  const double largest = ranks.max(value); // by all, also by a rank that has none
  const bool has = own.number >= 0 && value == largest;
  const double first = -ranks.max(has ? -static_cast<double>(ranks.rank()) : -ranks.size());
  double sent[2 + D] = {};
  if (first == ranks.rank())
  {
    sent[0] = static_cast<double>(own.number + 1);
    sent[1] = own.axis;
    std::copy_n(own.position.c, D, sent + 2);
  }
  ranks.sum(sent, 2 + D);
  UnknownAt<D> all{static_cast<long long>(sent[0]) - 1, static_cast<int>(sent[1]), {}};
  std::copy_n(sent + 2, D, all.position.c);
  return all;
}

/// The rows of each piece, in their order, so that a look at all pieces is a look at all rows once.
class RowsOfPieces
{
public:
  explicit RowsOfPieces(const std::vector<int>& pieceOf)
  {
    for (const int piece : pieceOf)
      first_.resize(std::max(first_.size(), static_cast<std::size_t>(piece) + 2), 0);
    for (const int piece : pieceOf)
      ++first_[piece + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    row_.resize(pieceOf.size());
    std::vector<std::size_t> next = first_;
    for (std::size_t r = 0; r < pieceOf.size(); ++r)
      row_[next[pieceOf[r]]++] = static_cast<int>(r);
  }

  /// Calls visit(row) for those of a piece, of which a rank may have none.
  template <class Visit>
  void forEach(int piece, const Visit& visit) const
  {
    if (static_cast<std::size_t>(piece) + 1 < first_.size())
      std::for_each(row_.begin() + static_cast<std::ptrdiff_t>(first_[piece]),
                    row_.begin() + static_cast<std::ptrdiff_t>(first_[piece + 1]), visit);
  }

private:
  std::vector<std::size_t> first_;
  std::vector<int> row_;
};

/// The free motions of one piece, what forces do on them, and the accelerations that follow.
template <int D>
struct ModesOfPiece
{
  static constexpr int most = rigidMotions<D>;
  const std::vector<RigidMode<D>>& modes;
  std::size_t first, last;
  double resultant[most] = {}, acceleration[most] = {};

  /// Collective. \param from index of the first mode of the piece
  ModesOfPiece(const std::vector<RigidMode<D>>& all, std::size_t from, const RowsOfPieces& rows,
               const std::vector<Vector<D>>& position, const std::vector<double>& mass,
               const RowOwners& owners, const View<double*>& force)
      : modes(all), first(from), last(from)
  {
    while (last < modes.size() && modes[last].piece == modes[first].piece)
      ++last;
    const int n = static_cast<int>(last - first);
    double sums[most * most + most] = {}; // inertia, resultant
    rows.forEach(modes[first].piece,
                 [&](int r)
                 {
                   for (int a = 0; a < n && owners.owns(r); ++a)
                   {
                     const Vector<D> u = modes[first + a].at(position[r]);
                     for (int b = 0; b < n; ++b)
                       sums[most * a + b] += mass[r] * dot(u, modes[first + b].at(position[r]));
                     for (int d = 0; d < D; ++d)
                       sums[most * most + a] += u[d] * force(D * r + d);
                   }
                 });
    owners.ranks().sum(sums, most * most + most);
    Teuchos::SerialDenseMatrix<int, double> inertia(n, n), right(n, 1), left(n, 1);
    for (int k = 0; k < n * n; ++k)
      inertia(k / n, k % n) = sums[most * (k / n) + k % n];
    std::copy_n(sums + most * most, n, resultant);
    std::copy_n(resultant, n, right.values());
    Teuchos::SerialDenseSolver<int, double> solver;
    solver.setMatrix(Teuchos::rcpFromRef(inertia));
    solver.setVectors(Teuchos::rcpFromRef(left), Teuchos::rcpFromRef(right));
    solver.factorWithEquilibration(true); // masses and moments of inertia are of different size
    solver.solve();
    std::copy_n(left.values(), n, acceleration);
  }

  /// Inertia force on a mass at a position [N].
  Vector<D> inertia(const Vector<D>& at, double mass) const
  {
    Vector<D> sum{};
    for (std::size_t a = first; a < last; ++a)
      sum = sum + (mass * acceleration[a - first]) * modes[a].at(at);
    return sum;
  }

  /// Force along the translations [N], or moment about the axes of the other modes [N m]: a mode does work on
  /// it by its rotation, the norm of its coefficients over the size of the piece.
  double resultantOf(bool turning) const
  {
    double square = 0.0;
    for (std::size_t a = first; a < last; ++a)
      if (modes[a].turns() == turning)
      {
        const double* const c = modes[a].coefficient + (turning ? D : 0);
        const double rate = std::sqrt(std::inner_product(c, c + (turning ? most - D : D), c, 0.0)) /
                            (turning ? modes[a].size : 1.0);
        square += std::pow(resultant[a - first] / rate, 2);
      }
    return std::sqrt(square);
  }
};

} // namespace

template <int D>
std::string RigidMode<D>::asText() const
{
  constexpr double noticeable = 0.3; // of a motion of length one with up to six parts
  const auto isPart = [&](double c) { return std::fabs(c) > noticeable; };
  const bool turns = std::any_of(coefficient + D, coefficient + rigidMotions<D>, isPart);
  std::string text;
  for (int m = turns ? D : 0; m < rigidMotions<D>; ++m)
    if (isPart(coefficient[m]))
      text += std::string(text.empty() ? "can " : " and ") +
              (m < D ? std::string("move along ") + "xyz"[m]
                     : std::string("turn freely about ") + (D == 2 ? 'z' : "xyz"[m - D]));
  return text;
}

template <int D>
std::vector<RigidMode<D>> freeModes(const std::vector<int>& pieceOf, int pieces,
                                    const std::vector<Vector<D>>& position, const std::vector<double>& mass,
                                    const Held& held, const RowOwners& owners,
                                    const std::vector<HeldDirection<D>>& resisted)
{
  constexpr int n = rigidMotions<D>;
  const std::vector<RigidMode<D>> frames = framesOfPieces(pieceOf, pieces, position, mass, owners);
  std::vector<std::array<double, n * n>> hold(pieces, std::array<double, n * n>{});
  const auto add = [&](std::size_t row, const Vector<D>& at, const auto& component)
  {
    double motion[n];
    for (int m = 0; m < n; ++m)
    {
      RigidMode<D> one = frames[pieceOf[row]];
      one.coefficient[m] = 1.0;
      motion[m] = component(one.at(at));
    }
    for (int k = 0; k < n * n; ++k)
      hold[pieceOf[row]][k] += motion[k / n] * motion[k % n];
  };
  for (std::size_t r = 0; r < pieceOf.size(); ++r)
    for (int d = 0; d < D; ++d)
      if (held.is[D * r + d] != 0 && owners.owns(static_cast<int>(r)))
        add(r, position[r], [d](const Vector<D>& u) { return u[d]; });
  for (const HeldDirection<D>& by : resisted)
    add(by.row, by.position, [&by](const Vector<D>& u) { return dot(u, by.direction); });
  for (std::array<double, n * n>& of : hold)
    owners.ranks().sum(of.data(), n * n);
  std::vector<RigidMode<D>> modes;
  Teuchos::LAPACK<int, double> lapack;
  for (int k = 0; k < pieces; ++k)
  {
    double values[n], work[8 * n];
    int info = 0;
    lapack.SYEV('V', 'U', n, hold[k].data(), n, values, work, 8 * n, &info);
    for (int v = 0; v < n; ++v)
      if (!(values[v] > leastHold * values[n - 1]) || !(values[n - 1] > 0.0))
      {
        modes.push_back(frames[k]);
        std::copy_n(hold[k].data() + v * n, n, modes.back().coefficient);
      }
    separateTranslations<D>(modes, k);
  }
  return modes;
}

template <int D>
void removeResultants(const std::vector<RigidMode<D>>& modes, const std::vector<int>& pieceOf,
                      const std::vector<Vector<D>>& position, const std::vector<double>& mass,
                      const RowOwners& owners, const View<double*>& force)
{
  const RowsOfPieces rows(pieceOf);
  for (std::size_t first = 0; first < modes.size();)
  {
    const ModesOfPiece<D> of(modes, first, rows, position, mass, owners, force);
    rows.forEach(modes[first].piece,
                 [&](int r)
                 {
                   const Vector<D> taken = of.inertia(position[r], mass[r]);
                   for (int d = 0; d < D; ++d)
                     force(D * r + d) -= taken[d];
                 });
    first = of.last;
  }
}

template <int D>
std::vector<Imbalance> findImbalances(const std::vector<RigidMode<D>>& modes, const std::vector<int>& pieceOf,
                                      const std::vector<Vector<D>>& position, const std::vector<double>& mass,
                                      const RowOwners& owners, const View<double*>& force)
{
  std::vector<Imbalance> all;
  const RowsOfPieces rows(pieceOf);
  for (std::size_t first = 0; first < modes.size();)
  {
    const ModesOfPiece<D> of(modes, first, rows, position, mass, owners, force);
    double most[ModesOfPiece<D>::most] = {};
    rows.forEach(modes[first].piece,
                 [&](int r)
                 {
                   double square = 0.0;
                   for (int d = 0; d < D; ++d)
                     square += force(D * r + d) * force(D * r + d);
                   for (std::size_t a = first; a < of.last && owners.owns(r); ++a)
                     most[a - first] += std::sqrt(square) * (norm(modes[a].at(position[r])) + roundingOfArm);
                 });
    owners.ranks().sum(most, ModesOfPiece<D>::most);
    Imbalance one;
    one.piece = modes[first].piece;
    one.force = of.resultantOf(false);
    one.moment = of.resultantOf(true);
    for (std::size_t a = first; a < of.last; ++a)
    {
      double& fraction = modes[a].turns() ? one.fractionOfMoment : one.fractionOfForce;
      if (most[a - first] > 0.0)
        fraction = std::max(fraction, std::fabs(of.resultant[a - first]) / most[a - first]);
    }
    all.push_back(one);
    first = of.last;
  }
  return all;
}

std::string Imbalance::asText(double least) const
{
  const auto part = [](const char* what, double size, const char* unit, double fraction)
  {
    return std::string(what) + formatShort(size) + unit + " (" + formatShort(100.0 * fraction) +
           " % of the forces on it)";
  };
  std::string text;
  if (fractionOfForce >= least)
    text = part("a force of ", force, " N", fractionOfForce);
  if (fractionOfMoment >= least)
    text += (text.empty() ? "" : " and ") + part("a moment of ", moment, " N m", fractionOfMoment);
  return text;
}

template struct RigidMode<2>;
template struct RigidMode<3>;
template <int D>
std::vector<int> unknownsOfMotions(const std::vector<RigidMode<D>>& modes, const std::vector<int>& pieceOf,
                                   const std::vector<Vector<D>>& position, const std::vector<double>& mass,
                                   const RowOwners& owners)
{
  std::vector<int> chosen;
  const RowsOfPieces rows(pieceOf);
  std::vector<std::pair<RigidMode<D>, UnknownAt<D>>> taken; // modes and the unknowns that hold them
  for (RigidMode<D> mode : modes)
  {
    // A combination that moves no unknown that is held already.
    for (const auto& [other, by] : taken)
      if (other.piece == mode.piece)
      {
        const double ratio = mode.at(by.position)[by.axis] / other.at(by.position)[by.axis];
        for (int m = 0; m < rigidMotions<D>; ++m)
          mode.coefficient[m] -= ratio * other.coefficient[m];
      }
    UnknownAt<D> best;
    double largest = 0.0, heaviest = 0.0;
    rows.forEach(mode.piece, [&](int r) { heaviest = std::max(heaviest, mass[r]); });
    heaviest = owners.ranks().max(heaviest);
    rows.forEach(mode.piece,
                 [&](int r)
                 {
                   for (int d = 0; d < D && mass[r] >= leastHeldMass * heaviest; ++d)
                     if (const double moved = std::fabs(mode.at(position[r])[d]);
                         moved > largest && owners.owns(r))
                     {
                       largest = moved;
                       best = {owners.numberOf(r), d, position[r]};
                     }
                 });
    best = largestOfRanks(owners.ranks(), largest, best);
    if (best.number < 0)
      continue;
    taken.push_back({mode, best});
    if (const int row = owners.find(best.number); row >= 0)
      chosen.push_back(D * row + best.axis);
  }
  return chosen;
}

template std::vector<RigidMode<2>> freeModes(const std::vector<int>&, int, const std::vector<Vector<2>>&,
                                             const std::vector<double>&, const Held&, const RowOwners&,
                                             const std::vector<HeldDirection<2>>&);
template std::vector<RigidMode<3>> freeModes(const std::vector<int>&, int, const std::vector<Vector<3>>&,
                                             const std::vector<double>&, const Held&, const RowOwners&,
                                             const std::vector<HeldDirection<3>>&);
template void removeResultants(const std::vector<RigidMode<2>>&, const std::vector<int>&,
                               const std::vector<Vector<2>>&, const std::vector<double>&, const RowOwners&,
                               const View<double*>&);
template void removeResultants(const std::vector<RigidMode<3>>&, const std::vector<int>&,
                               const std::vector<Vector<3>>&, const std::vector<double>&, const RowOwners&,
                               const View<double*>&);

template std::vector<Imbalance> findImbalances(const std::vector<RigidMode<2>>&, const std::vector<int>&,
                                               const std::vector<Vector<2>>&, const std::vector<double>&,
                                               const RowOwners&, const View<double*>&);
template std::vector<Imbalance> findImbalances(const std::vector<RigidMode<3>>&, const std::vector<int>&,
                                               const std::vector<Vector<3>>&, const std::vector<double>&,
                                               const RowOwners&, const View<double*>&);
template std::vector<int> unknownsOfMotions(const std::vector<RigidMode<2>>&, const std::vector<int>&,
                                            const std::vector<Vector<2>>&, const std::vector<double>&,
                                            const RowOwners&);
template std::vector<int> unknownsOfMotions(const std::vector<RigidMode<3>>&, const std::vector<int>&,
                                            const std::vector<Vector<3>>&, const std::vector<double>&,
                                            const RowOwners&);

} // namespace Rhegma::equilibrium
