#include "energy_release/FrontCurvature.hpp"

#include <algorithm>

namespace Rhegma::energy_release
{

namespace
{

/// Divergence of the directions of two front nodes, over the distance between them.
double divergence(const FrontNode<3>& from, const FrontNode<3>& to)
{
  const Vector<3> along = to.position - from.position;
  const double square = dot(along, along);
  return square > 0.0 ? dot(to.direction - from.direction, along) / square : 0.0;
}

} // namespace

FrontCurvature::FrontCurvature(const FrontLine& line) : lines_(line.loop.size()), loop_(line.loop)
{
  const int count = static_cast<int>(line.nodes.size());
  std::vector<double> sum(count, 0.0), pieces(count, 0.0);
  // The ends of an open line point along the surface: its last pieces say nothing.
  for (const FrontPiece& piece : line.pieces)
    for (const int k : {piece.from, piece.to})
      if (!piece.begins && !piece.ends)
      {
        sum[k] += divergence(line.nodes[piece.from], line.nodes[piece.to]);
        pieces[k] += 1.0;
      }
  for (int k = 0; k < count; ++k)
    lines_[line.line[k]].push_back({line.arc[k], pieces[k] > 0.0 ? sum[k] / pieces[k] : 0.0});
  for (std::vector<Node>& nodes : lines_) // an end takes the curvature next to it
    if (nodes.size() > 2 && !(loop_[&nodes - lines_.data()] > 0.0))
    {
      nodes.front().curvature = nodes[1].curvature;
      nodes.back().curvature = nodes[nodes.size() - 2].curvature;
    }
}

double FrontCurvature::at(int onLine, double arc) const
{
  const std::vector<Node>& nodes = lines_[onLine];
  const auto after = std::find_if(nodes.begin(), nodes.end(), [arc](const Node& n) { return n.arc > arc; });
  if (after == nodes.begin()) // beyond the end of an open line
    return nodes.front().curvature;
  const Node& before = *(after - 1);
  const bool last = after == nodes.end();
  if (last && !(loop_[onLine] > 0.0))
    return before.curvature;
  const Node& next = last ? nodes.front() : *after;
  const double end = last ? loop_[onLine] : next.arc;
  const double t = end > before.arc ? std::min(1.0, (arc - before.arc) / (end - before.arc)) : 0.0;
  return (1.0 - t) * before.curvature + t * next.curvature;
}

} // namespace Rhegma::energy_release
