#include "measure/Pieces.hpp"

#include "equilibrium/RowOwners.hpp"
#include "equilibrium/Unknowns.hpp"
#include "state/ParticlePlace.hpp"
#include "transfer/ParticleViews.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace Rhegma::measure
{

namespace
{

/// The piece of the first node of each particle, which is that of all its nodes; -1 where it has none.
template <int D>
std::vector<int> pieceOfParticles(const State<D>& state, const equilibrium::RowGraph& graph,
                                  const std::vector<int>& pieceOfRow)
{
  std::vector<int> piece(state.particles.size(), -1);
  withStraining(state,
                [&](const auto& connect)
                {
                  for (int p = 0; p < state.particles.size(); ++p)
                    connect.visitStraining(p,
                                           [&](int node, double weight, const auto&)
                                           {
                                             const int row = graph.rowOf(node);
                                             if (piece[p] < 0 && row >= 0 && weight > 0.0)
                                               piece[p] = pieceOfRow[row];
                                           });
                });
  return piece;
}

/// Sums of a piece: its mass, D first moments, particles of each body.
template <int D>
int widthOf(const State<D>& state)
{
  return 1 + D + static_cast<int>(state.bodies.info.size());
}

/// Mass and first moment of mass of each piece, and the particles of each body in it: `width` sums a piece.
template <int D>
std::vector<double> sumsOf(const State<D>& state, const std::vector<int>& piece, int count, int width)
{
  const auto mass = onHost(state.particles.scalar(fields::mass));
  const auto position = onHost(state.particles.template real<D>(fields::position));
  const auto body = onHost(state.particles.integer(fields::body));
  const bool undeformed = state.particles.has(fields::displacement);
  const auto moved =
      undeformed ? onHost(state.particles.template real<D>(fields::displacement)) : decltype(position)();
  std::vector<double> sums(static_cast<std::size_t>(count) * width, 0.0);
  for (std::size_t p = 0; p < piece.size(); ++p)
  {
    if (piece[p] < 0)
      continue;
    double* const of = &sums[static_cast<std::size_t>(piece[p]) * width];
    of[0] += mass(p);
    for (int d = 0; d < D; ++d)
      of[1 + d] += mass(p) * (position(p, d) + (undeformed ? moved(p, d) : 0.0));
    of[1 + D + body(p)] += 1.0;
  }
  state.ranks.sum(sums.data(), static_cast<int>(sums.size()));
  return sums;
}

} // namespace

template <int D>
void numberPieces(const State<D>& state)
{
  const equilibrium::RowGraph graph = equilibrium::numberRows(state);
  const equilibrium::RowOwners owners = equilibrium::findOwners(state, graph);
  const auto [pieceOfRow, count] = equilibrium::findPieces(state, {}, owners, graph);
  const std::vector<int> piece = pieceOfParticles(state, graph, pieceOfRow);
  const int width = widthOf(state);
  const std::vector<double> sums = sumsOf(state, piece, count, width);
  std::vector<int> order(count), numberOf(count);
  std::iota(order.begin(), order.end(), 0);
  // Rows of particles that have left may form a piece without mass; it comes last.
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return sums[std::size_t(a) * width] > sums[std::size_t(b) * width]; });
  for (int k = 0; k < count; ++k)
    numberOf[order[k]] = k;
  const auto field = state.particles.integer(pieceField);
  const auto host = Kokkos::create_mirror_view(field);
  for (std::size_t p = 0; p < piece.size(); ++p)
    host(p) = piece[p] < 0 ? -1 : numberOf[piece[p]];
  Kokkos::deep_copy(field, host);
}

template <int D>
std::vector<Piece<D>> piecesOf(const State<D>& state)
{
  const auto field = onHost(state.particles.integer(pieceField));
  const std::vector<int> piece(field.data(), field.data() + state.particles.size());
  double most = -1.0;
  for (const int number : piece)
    most = std::max(most, double(number));
  const int count = static_cast<int>(state.ranks.max(most)) + 1, width = widthOf(state);
  const std::vector<double> sums = sumsOf(state, piece, count, width);
  std::vector<Piece<D>> pieces;
  for (int k = 0; k < count; ++k)
  {
    const double* const of = &sums[static_cast<std::size_t>(k) * width];
    if (!(of[0] > 0.0))
      continue;
    Piece<D> next;
    next.mass = of[0];
    for (int d = 0; d < D; ++d)
      next.centre[d] = of[1 + d] / of[0];
    for (int b = 0; b < width - 1 - D; ++b)
      if (of[1 + D + b] > 0.0)
        next.bodies.push_back(b);
    pieces.push_back(next);
  }
  return pieces;
}

template void numberPieces(const State<2>&);
template void numberPieces(const State<3>&);
template std::vector<Piece<2>> piecesOf(const State<2>&);
template std::vector<Piece<3>> piecesOf(const State<3>&);

} // namespace Rhegma::measure
