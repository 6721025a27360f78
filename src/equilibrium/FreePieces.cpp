#include "equilibrium/FreePieces.hpp"

#include "base/ShortNumber.hpp"

#include <algorithm>

namespace Rhegma::equilibrium
{

namespace
{

/// Mass of a piece that counts, in masses of its heaviest node, which has about that of a cell.
constexpr double leastCells = 2.0;

/// Mass of a body on all ranks [kg].
template <int D>
double massOfBody(const State<D>& state, const RowOwners& owners, int which)
{
  const auto body = state.particles.integer(fields::body);
  const auto mass = state.particles.scalar(fields::mass);
  double sum = 0.0;
  for (int p = 0; p < state.particles.size(); ++p)
    sum += body(p) == which ? mass(p) : 0.0;
  return owners.ranks().sum(sum);
}

/// Mass of the heaviest node of a piece [kg].
double heaviestOf(const RowOwners& owners, const std::vector<int>& pieceOf, int piece,
                  const std::vector<double>& mass)
{
  double heaviest = 0.0;
  for (std::size_t r = 0; r < pieceOf.size(); ++r)
    heaviest = pieceOf[r] == piece ? std::max(heaviest, mass[r]) : heaviest;
  return owners.ranks().max(heaviest);
}

template <int D>
std::string motionsOf(const std::vector<RigidMode<D>>& modes, int piece)
{
  std::string text;
  for (const RigidMode<D>& mode : modes)
    if (mode.piece == piece)
      text += (text.empty() ? "" : " and ") + mode.asText();
  return text;
}

template <int D>
std::string pointAsText(const Vector<D>& x)
{
  std::string text;
  for (int d = 0; d < D; ++d)
    text += (d > 0 ? ", " : "") + formatShort(x[d]);
  return text + " m";
}

} // namespace

std::string FreePiece::name() const
{
  const std::string whole = body.empty() ? "a body" : "Bodies > " + body;
  return isPart ? "a part of " + whole + " (" + formatShort(mass) + " kg around " + centre + ")" : whole;
}

template <int D>
int bodyOfPiece(const State<D>& state, const RowGraph& graph, const RowOwners& owners,
                const std::vector<int>& pieceOf, int piece)
{
  const Grid<D>& grid = state.mesh.grid;
  const auto position = state.particles.template real<D>(fields::position);
  const auto body = state.particles.integer(fields::body);
  std::vector<double> count(state.bodies.info.size(), 0.0);
  for (int p = 0; p < state.particles.size(); ++p)
  {
    int node = 0;
    for (int d = 0; d < D; ++d)
      node += grid.stride[d] * static_cast<int>(grid.inCells(position(p, d), d));
    const int row = graph.rowOf(node);
    if (row >= 0 && pieceOf[row] == piece)
      count[body(p)] += 1.0;
  }
  owners.ranks().sum(count.data(), static_cast<int>(count.size()));
  const auto most = std::max_element(count.begin(), count.end());
  return most == count.end() || *most == 0.0 ? -1 : static_cast<int>(most - count.begin());
}

template <int D>
FreePiece describePiece(const State<D>& state, const RowGraph& graph, const RowOwners& owners,
                        const std::vector<int>& pieceOf, const RigidMode<D>& mode,
                        const std::vector<double>& mass)
{
  FreePiece one;
  one.mass = owners.sum(static_cast<int>(pieceOf.size()),
                        [&](int r) { return pieceOf[r] == mode.piece ? mass[r] : 0.0; });
  const double rounding = leastCells * heaviestOf(owners, pieceOf, mode.piece, mass);
  const int body = bodyOfPiece(state, graph, owners, pieceOf, mode.piece);
  one.body = body < 0 ? std::string() : state.bodies.info[body].name;
  one.isPart = body < 0 || one.mass < massOfBody(state, owners, body) - rounding;
  one.centre = pointAsText(mode.centre);
  return one;
}

template <int D>
std::vector<FreePiece> findFreePieces(const State<D>& state, const RowGraph& graph, const RowOwners& owners,
                                      const std::vector<int>& pieceOf, const std::vector<RigidMode<D>>& modes,
                                      const std::vector<Vector<D>>& position, const std::vector<double>& mass,
                                      const View<double*>& loads)
{
  std::vector<FreePiece> pieces;
  if (modes.empty())
    return pieces;
  for (const Imbalance& imbalance : findImbalances(modes, pieceOf, position, mass, owners, loads))
  {
    const auto ofPiece = [&](const RigidMode<D>& mode) { return mode.piece == imbalance.piece; };
    FreePiece one = describePiece(state, graph, owners, pieceOf,
                                  *std::find_if(modes.begin(), modes.end(), ofPiece), mass);
    if (!(one.mass > leastCells * heaviestOf(owners, pieceOf, imbalance.piece, mass)))
      continue;
    one.imbalance = imbalance;
    one.motions = motionsOf(modes, imbalance.piece);
    pieces.push_back(one);
  }
  return pieces;
}

template int bodyOfPiece(const State<2>&, const RowGraph&, const RowOwners&, const std::vector<int>&, int);
template int bodyOfPiece(const State<3>&, const RowGraph&, const RowOwners&, const std::vector<int>&, int);
template FreePiece describePiece(const State<2>&, const RowGraph&, const RowOwners&, const std::vector<int>&,
                                 const RigidMode<2>&, const std::vector<double>&);
template FreePiece describePiece(const State<3>&, const RowGraph&, const RowOwners&, const std::vector<int>&,
                                 const RigidMode<3>&, const std::vector<double>&);
template std::vector<FreePiece> findFreePieces(const State<2>&, const RowGraph&, const RowOwners&,
                                               const std::vector<int>&, const std::vector<RigidMode<2>>&,
                                               const std::vector<Vector<2>>&, const std::vector<double>&,
                                               const View<double*>&);
template std::vector<FreePiece> findFreePieces(const State<3>&, const RowGraph&, const RowOwners&,
                                               const std::vector<int>&, const std::vector<RigidMode<3>>&,
                                               const std::vector<Vector<3>>&, const std::vector<double>&,
                                               const View<double*>&);

} // namespace Rhegma::equilibrium
