#include "surface/GrowingPolyline.hpp"

#include "surface/Polyline.hpp"

#include <cmath>
#include <numeric>

namespace Rhegma::surface
{

void GrowingPolyline::prepare()
{
  order_.resize(vertices.size());
  std::iota(order_.begin(), order_.end(), 0);
}

double GrowingPolyline::advance(FrontLines<2>& lines, std::size_t k, const Vector<2>& x, double length)
{
  const int added = static_cast<int>(vertices.size());
  order_.insert(isFirst(lines[k].vertex) ? order_.begin() : order_.end(), added);
  vertices.push_back(x);
  faces.push_back({x, x});
  lines[k].vertex = added;
  return length;
}

double GrowingPolyline::openingBehind(int vertex, double distance) const
{
  const int count = static_cast<int>(order_.size());
  const bool first = isFirst(vertex);
  double behind = 0.0, before = 0.0;
  for (int k = 1; k < count; ++k)
  {
    const int from = order_[first ? k - 1 : count - k], to = order_[first ? k : count - 1 - k];
    const double length = norm(vertices[to] - vertices[from]), opening = norm(faces[to][1] - faces[to][0]);
    if (behind + length >= distance)
      return k == 1 ? opening * std::sqrt(distance / length)
                    : before + (opening - before) * (distance - behind) / length;
    behind += length;
    before = opening;
  }
  return before;
}

void GrowingPolyline::tidy(const std::vector<FrontLines<2>*>& lines)
{
  std::vector<int> number(vertices.size());
  std::vector<Vector<2>> ordered;
  std::vector<std::array<Vector<2>, 2>> orderedFaces;
  for (const int v : order_)
  {
    number[v] = static_cast<int>(ordered.size());
    ordered.push_back(vertices[v]);
    orderedFaces.push_back(faces[v]);
  }
  vertices = ordered;
  faces = orderedFaces;
  for (FrontLines<2>* line : lines)
    for (FrontPoint<2>& point : *line)
      point.vertex = number[point.vertex];
  prepare();
}

CrackMesh<2> GrowingPolyline::mesh(const std::vector<const FrontLines<2>*>& lines) const
{
  std::array<int, 2> beyond;
  for (int end = 0; end < 2; ++end)
    beyond[end] = joined[end] ? facet::joined : facet::surfaceBreaking;
  for (const FrontLines<2>* line : lines)
    for (const FrontPoint<2>& point : *line)
      beyond[isFirst(point.vertex) ? 0 : 1] = facet::front;
  std::vector<Vector<2>> points;
  points.reserve(order_.size());
  for (const int v : order_)
    points.push_back(vertices[v]);
  return polylineMesh(points, beyond);
}

} // namespace Rhegma::surface
