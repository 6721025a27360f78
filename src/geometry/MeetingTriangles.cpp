#include "geometry/MeetingTriangles.hpp"

#include "geometry/Cross.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace Rhegma::Geometry
{

namespace
{

using Corners = Vector<3>[3];

/// A triangle with its unit normal; none if it has no height.
struct Face
{
  Corners corner;
  Vector<3> normal;
  bool flat;
  bool atFlat; ///< a face without height has one of its corners
};

/// Whether x, in the plane of a face, is in it.
bool contains(const Face& face, const Vector<3>& x, double slack)
{
  for (int i = 0; i < 3; ++i)
  {
    const Vector<3> edge = face.corner[(i + 1) % 3] - face.corner[i];
    if (dot(cross(edge, x - face.corner[i]), face.normal) < -slack * norm(edge))
      return false;
  }
  return true;
}

/// Whether a segment in the plane of a face meets it: no line along the edges of the two parts them.
bool meetInPlane(const Vector<3>& p, const Vector<3>& q, const Face& face, double slack)
{
  for (int i = 0; i < 4; ++i)
  {
    const Vector<3> along = i < 3 ? face.corner[(i + 1) % 3] - face.corner[i] : q - p;
    const Vector<3> across = (1.0 / norm(along)) * cross(along, face.normal);
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Vector<3>& x : face.corner)
    {
      low = std::min(low, dot(across, x - p));
      high = std::max(high, dot(across, x - p));
    }
    const double other = dot(across, q - p);
    if (low > std::max(0.0, other) + slack || high < std::min(0.0, other) - slack)
      return false;
  }
  return true;
}

/// Whether the segment from p to q meets a face. \param slack of the distance from its plane \param inPlane
/// of the distance from its edges; below zero they have to overlap by as much
bool meets(const Vector<3>& p, const Vector<3>& q, const Face& face, double slack, double inPlane)
{
  const double first = dot(face.normal, p - face.corner[0]), last = dot(face.normal, q - face.corner[0]);
  if ((first > slack && last > slack) || (first < -slack && last < -slack))
    return false;
  if (std::abs(first) <= slack && std::abs(last) <= slack)
    return meetInPlane(p, q, face, inPlane);
  return contains(face, p + std::clamp(first / (first - last), 0.0, 1.0) * (q - p), inPlane);
}

/// Whether all corners of one face but those that are common are on one side of the other.
bool isOnOneSide(const Face& one, unsigned common, const Face& other, double slack)
{
  int above = 0, below = 0, all = 0;
  for (int i = 0; i < 3; ++i)
    if ((common >> i & 1u) == 0)
    {
      const double height = dot(other.normal, one.corner[i] - other.corner[0]);
      above += height > slack ? 1 : 0;
      below += height < -slack ? 1 : 0;
      ++all;
    }
  return above == all || below == all;
}

class Meetings
{
public:
  Meetings(const Simplices<3>& surface, double resolution)
      : surface_(surface), tree_(surface), slack_(1e-5 * resolution)
  {
    faces_.reserve(surface.items.size());
    for (int t = 0; t < static_cast<int>(surface.items.size()); ++t)
    {
      Face face{};
      surface.corners(t, face.corner);
      const Vector<3> normal = surface.normalOf(t);
      const double size = norm(normal);
      double longest = 0.0;
      for (int i = 0; i < 3; ++i)
        longest = std::max(longest, norm(face.corner[(i + 1) % 3] - face.corner[i]));
      face.flat = !(size > resolution * longest);
      if (!face.flat)
        face.normal = (1.0 / size) * normal;
      faces_.push_back(face);
    }
    markNeighboursOfFlat(resolution);
  }

  /// Calls visit(t, u) for pairs that meet, until it returns false.
  template <class Visit>
  void forEach(const Visit& visit) const
  {
    bool on = true;
    for (int t = 0; t < static_cast<int>(faces_.size()) && on; ++t)
    {
      if (faces_[t].flat)
        continue;
      const Bounds<3> own = surface_.boundsOf(t);
      const auto isNear = [&](const Bounds<3>& other)
      {
        for (int d = 0; d < 3; ++d)
          if (own.lower[d] > other.upper[d] + slack_ || other.lower[d] > own.upper[d] + slack_)
            return false;
        return true;
      };
      tree_.boxes().forEach(isNear,
                            [&](int u)
                            {
                              if (u > t && on && !faces_[u].flat && meet(t, u))
                                on = visit(t, u);
                            });
    }
  }

private:
  /// Of a face without height the neighbours touch, or overlap by rounding.
  void markNeighboursOfFlat(double resolution)
  {
    overlap_ = 2.0 * resolution;
    std::vector<char> isAtFlat(surface_.points.size(), 0);
    for (std::size_t t = 0; t < faces_.size(); ++t)
      for (const int point : surface_.items[t])
        isAtFlat[point] |= faces_[t].flat ? 1 : 0;
    for (std::size_t t = 0; t < faces_.size(); ++t)
      for (const int point : surface_.items[t])
        faces_[t].atFlat = faces_[t].atFlat || isAtFlat[point] != 0;
  }

  bool meet(int t, int u) const
  {
    unsigned ofT = 0, ofU = 0; // common corners
    int common = 0;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (surface_.items[t][i] == surface_.items[u][j])
        {
          ofT |= 1u << i;
          ofU |= 1u << j;
          ++common;
        }
    const Face &a = faces_[t], &b = faces_[u];
    if (common == 3 || isOnOneSide(a, ofT, b, slack_) || isOnOneSide(b, ofU, a, slack_))
      return false;
    if (common == 2)
      return isFolded(a, ofT, b, ofU);
    return sidesMeet(a, ofT, b) || sidesMeet(b, ofU, a);
  }

  /// Whether two faces in one plane lie on the same side of their common edge.
  static bool isFolded(const Face& a, unsigned ofA, const Face& b, unsigned ofB)
  {
    int i = 0, j = 0;
    while ((ofA >> i & 1u) != 0)
      ++i;
    while ((ofB >> j & 1u) != 0)
      ++j;
    const Vector<3>&p = a.corner[(i + 1) % 3], &q = a.corner[(i + 2) % 3];
    return dot(cross(cross(q - p, a.corner[i] - p), q - p), b.corner[j] - p) > 0.0;
  }

  /// Whether an edge of a without a common corner meets b.
  bool sidesMeet(const Face& a, unsigned common, const Face& b) const
  {
    const double inPlane = a.atFlat && b.atFlat ? -overlap_ : slack_;
    for (int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3;
      if ((common >> i & 1u) == 0 && (common >> j & 1u) == 0 &&
          meets(a.corner[i], a.corner[j], b, slack_, inPlane))
        return true;
    }
    return false;
  }

  const Simplices<3>& surface_;
  SimplexTree<3> tree_;
  double slack_;
  double overlap_ = 0.0; ///< that is rounding next to faces without height
  std::vector<Face> faces_;
};

} // namespace

void refuseMeetings(const Simplices<3>& surface, const Shells& shells, double resolution)
{
  constexpr int most = 1000; // more says no more
  int pairs = 0;
  bool ofShells = false;
  Vector<3> at{};
  Meetings(surface, resolution)
      .forEach(
          [&](int t, int u)
          {
            const bool differ = shells.of[t] != shells.of[u];
            if (pairs == 0 || (differ && !ofShells))
            {
              const Bounds<3> a = surface.boundsOf(t), b = surface.boundsOf(u);
              for (int d = 0; d < 3; ++d)
                at[d] = 0.5 * (std::max(a.lower[d], b.lower[d]) + std::min(a.upper[d], b.upper[d]));
            }
            ofShells = ofShells || differ;
            return ++pairs < most;
          });
  if (pairs == 0)
    return;
  throw std::invalid_argument(
      (ofShells ? "two of its shells touch or overlap: " : "the surface intersects itself: ") +
      std::to_string(pairs) + (pairs == most ? " or more" : "") + (pairs == 1 ? " pair" : " pairs") +
      " of triangles meet, such as near " + placeInFile(at) +
      (ofShells ? "; unite the parts in the program that made the file, or write each "
                  "as a file and a body of its own"
                : "; repair it in the program that made the file"));
}

} // namespace Rhegma::Geometry
