#include "energy_release/FrontLine.hpp"

namespace Rhegma::energy_release
{

FrontLine lineOf(const CrackFront<3>& front)
{
  FrontLine all;
  if (front.ended)
    return all;
  all.nodes = front.nodes;
  const int count = static_cast<int>(front.nodes.size());
  int first = 0; // of the current line
  double along = 0.0;
  for (int k = 0; k < count; ++k)
  {
    all.arc.push_back(along);
    all.line.push_back(static_cast<int>(all.loop.size()));
    const bool ends = front.nodes[k].facet < 0, closes = !ends && k + 1 == count;
    if (!ends)
    {
      const int to = closes ? first : k + 1;
      const double length = norm(front.nodes[to].position - front.nodes[k].position);
      const bool open = !closes;
      all.pieces.push_back({k, to, open && k == first, open && front.nodes[to].facet < 0, length});
      along += length;
    }
    if (ends || closes)
    {
      all.loop.push_back(closes ? along : 0.0);
      all.open.push_back(closes ? 0.0 : along);
      all.length += along;
      along = 0.0;
      first = k + 1;
    }
  }
  if (!all.loop.empty() && all.loop.back() > 0.0) // a closed line has no end where its numbering begins
    for (FrontPiece& piece : all.pieces)
      if (all.line[piece.from] + 1 == static_cast<int>(all.loop.size()))
        piece.begins = piece.ends = false;
  return all;
}

FrontSight::FrontSight(const FrontLine& front, double extension)
    : nodePosition("rhegma::frontNodePosition", front.nodes.size()),
      direction("rhegma::frontDirection", front.nodes.size()),
      normal("rhegma::frontNormal", front.nodes.size()),
      arc("rhegma::frontArc", front.nodes.size()),
      loop("rhegma::frontLoop", front.loop.size()),
      open("rhegma::frontOpen", front.open.size()),
      ends("rhegma::frontEnds", front.open.size()),
      line("rhegma::frontLine", front.nodes.size()),
      piece("rhegma::frontPiece", front.pieces.size()),
      pieceLength("rhegma::frontPieceLength", front.pieces.size()),
      beyond(extension)
{
  const auto positions = Kokkos::create_mirror_view(nodePosition),
             directions = Kokkos::create_mirror_view(direction), normals = Kokkos::create_mirror_view(normal);
  const auto arcs = Kokkos::create_mirror_view(arc), loops = Kokkos::create_mirror_view(loop),
             opens = Kokkos::create_mirror_view(open), lengths = Kokkos::create_mirror_view(pieceLength);
  const auto lines = Kokkos::create_mirror_view(line);
  const auto lineEnds = Kokkos::create_mirror_view(ends);
  const auto pieces = Kokkos::create_mirror_view(piece);
  for (std::size_t k = 0; k < front.nodes.size(); ++k)
  {
    const FrontNode<3>& s = front.nodes[k];
    for (int d = 0; d < 3; ++d)
    {
      positions(k, d) = s.position[d];
      directions(k, d) = s.direction[d];
      normals(k, d) = s.normal[d];
    }
    arcs(k) = front.arc[k];
    lines(k) = front.line[k];
    if (k == 0 || front.line[k] != front.line[k - 1])
      lineEnds(front.line[k], 0) = static_cast<int>(k);
    lineEnds(front.line[k], 1) = static_cast<int>(k);
  }
  for (std::size_t k = 0; k < front.loop.size(); ++k)
  {
    loops(k) = front.loop[k];
    opens(k) = front.open[k];
  }
  for (std::size_t k = 0; k < front.pieces.size(); ++k)
  {
    const FrontPiece& p = front.pieces[k];
    pieces(k, 0) = p.from;
    pieces(k, 1) = p.to;
    pieces(k, 2) = p.begins ? 1 : 0;
    pieces(k, 3) = p.ends ? 1 : 0;
    lengths(k) = p.length;
  }
  Kokkos::deep_copy(nodePosition, positions);
  Kokkos::deep_copy(direction, directions);
  Kokkos::deep_copy(normal, normals);
  Kokkos::deep_copy(arc, arcs);
  Kokkos::deep_copy(loop, loops);
  Kokkos::deep_copy(open, opens);
  Kokkos::deep_copy(ends, lineEnds);
  Kokkos::deep_copy(line, lines);
  Kokkos::deep_copy(piece, pieces);
  Kokkos::deep_copy(pieceLength, lengths);
}

} // namespace Rhegma::energy_release
