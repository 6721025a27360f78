#include "measure/FrontShape.hpp"

#include "geometry/Cross.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace Rhegma::measure
{

namespace
{

constexpr double off = 0.05; ///< how far a front node of a circle may lie off it, in radii

/// Distances from the axis of a circle and from its plane.
std::array<double, 2> seenFrom(const Circle& circle, const Vector<3>& x)
{
  const Vector<3> from = x - circle.centre;
  const double above = dot(from, circle.normal);
  return {norm(from - above * circle.normal), above};
}

} // namespace

Circle circleOf(const CrackFront<3>& front)
{
  Circle circle;
  const double count = static_cast<double>(front.nodes.size());
  if (count < 5.0)
    return circle;
  Vector<3> middle{0.0, 0.0, 0.0}, normal{0.0, 0.0, 0.0};
  for (const FrontNode<3>& frontNode : front.nodes)
  {
    middle = middle + (1.0 / count) * frontNode.position;
    normal = normal + frontNode.normal;
  }
  if (!(norm(normal) > 0.0))
    return circle;
  normal = (1.0 / norm(normal)) * normal;
  Vector<3> a = front.nodes[0].direction;
  a = a - dot(a, normal) * normal;
  if (!(norm(a) > 0.0))
    return circle;
  a = (1.0 / norm(a)) * a;
  const Vector<3> b = cross(normal, a);
  // p^2 + q^2 = 2 p P + 2 q Q + c with the centre at (P, Q); sums about the middle.
  double pp = 0.0, pq = 0.0, qq = 0.0, p3 = 0.0, q3 = 0.0;
  for (const FrontNode<3>& frontNode : front.nodes)
  {
    const double p = dot(frontNode.position - middle, a), q = dot(frontNode.position - middle, b);
    pp += p * p;
    pq += p * q;
    qq += q * q;
    p3 += p * (p * p + q * q);
    q3 += q * (p * p + q * q);
  }
  const double determinant = pp * qq - pq * pq;
  if (!(determinant > 1e-6 * (pp + qq) * (pp + qq))) // a straight front
    return circle;
  const double P = 0.5 * (p3 * qq - q3 * pq) / determinant, Q = 0.5 * (q3 * pp - p3 * pq) / determinant;
  circle.centre = middle + P * a + Q * b;
  circle.normal = normal;
  circle.radius = std::sqrt(P * P + Q * Q + (pp + qq) / count);
  for (const FrontNode<3>& frontNode : front.nodes)
  {
    const auto [distance, above] = seenFrom(circle, frontNode.position);
    if (std::fabs(distance - circle.radius) > off * circle.radius || std::fabs(above) > off * circle.radius)
      return {};
  }
  return circle;
}

Shape shapeOf(const CrackFront<3>& front, const Circle& circle)
{
  Shape shape;
  double length = 0.0;
  for (const FrontNode<3>& frontNode : front.nodes)
  {
    shape.radius += frontNode.tributaryLength * seenFrom(circle, frontNode.position)[0];
    length += frontNode.tributaryLength;
  }
  if (!(length > 0.0))
    return shape;
  shape.radius /= length;
  double uneven = 0.0, outside = 0.0;
  for (const FrontNode<3>& frontNode : front.nodes)
  {
    const auto [distance, above] = seenFrom(circle, frontNode.position);
    uneven = std::max(uneven, std::fabs(distance - shape.radius));
    outside = std::max(outside, std::fabs(above));
  }
  shape.roundness = 1.0 - uneven / shape.radius;
  shape.flatness = 1.0 - outside / shape.radius;
  return shape;
}

} // namespace Rhegma::measure
