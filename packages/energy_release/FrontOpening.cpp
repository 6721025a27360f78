#include "energy_release/FrontOpening.hpp"

#include "geometry/Cross.hpp"
#include "material/LawStiffness.hpp"
#include "transfer/LocalSpacing.hpp"
#include "transfer/NearestMaterial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace Rhegma::energy_release
{

namespace
{

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Range of distances behind the front at which openings are evaluated [cells].
constexpr double nearest = 1.0, furthest = 3.0;

/// Pieces into which an edge of a triangle is cut.
constexpr int pieces = 4;

/// A part of a crack's faces behind a front.
struct Part
{
  double area;       ///< [m2]
  double behind;     ///< distance from the front [m]
  int line;          ///< of the front's nearest point
  double arc;        ///< of that point [m]
  double opening[3]; ///< along the front's direction, normal and third axis there [m]
};

/// A crack's vertices and faces on the host.
class Faces
{
public:
  explicit Faces(const CrackSet<3>& cracks)
      : vertex_(onHost(cracks.vertex)),
        face_(onHost(cracks.face)),
        simplex_(onHost(cracks.simplex)),
        normal_(onHost(cracks.normal))
  {
  }
  Vector<3> normal(int s) const { return {normal_(s, 0), normal_(s, 1), normal_(s, 2)}; }
  Vector<3> corner(int s, int i) const
  {
    const int v = simplex_(s, i);
    return {vertex_(v, 0), vertex_(v, 1), vertex_(v, 2)};
  }
  Vector<3> opening(int s, int i) const
  {
    const int v = simplex_(s, i);
    return {face_(v, 1, 0) - face_(v, 0, 0), face_(v, 1, 1) - face_(v, 0, 1),
            face_(v, 1, 2) - face_(v, 0, 2)};
  }

private:
  View<double* [3]>::HostMirror vertex_;
  View<double* [2][3]>::HostMirror face_;
  View<int* [3]>::HostMirror simplex_;
  View<double* [3]>::HostMirror normal_;
};

/// Middles of the equal triangles into which a triangle is cut, by weights of its corners.
std::vector<Vector<3>> middlesOfPieces()
{
  std::vector<Vector<3>> middles;
  const auto add = [&](double i, double j) {
    middles.push_back({i / pieces, j / pieces, 1.0 - (i + j) / pieces});
  };
  for (int i = 0; i < pieces; ++i)
    for (int j = 0; i + j < pieces; ++j)
    {
      add(i + 1.0 / 3.0, j + 1.0 / 3.0);
      if (i + j + 1 < pieces)
        add(i + 2.0 / 3.0, j + 2.0 / 3.0);
    }
  return middles;
}

/// The part of a crack that is evaluated.
struct Patch
{
  Vector<3> x[3], opening[3], normal;
};

/// An opening along the direction of a front's nearest point, the normal and the axis across both.
Vector<3> inOwnFrame(const Vector<3>& opening, const FrontFoot& foot)
{
  return {dot(opening, foot.direction), dot(opening, foot.normal),
          dot(opening, cross(foot.direction, foot.normal))};
}

/// The same in the frame that is turned by half of what the faces have turned. On a curved crack the faces
/// have turned from the front's frame at this distance from it. K_I and K_II of an arc of a circle are those
/// of the openings in a frame that turns by half of that, without an error of the first order in the distance
/// (of Muskhelishvili's solution, for every angle of the arc).
Vector<3> inTurnedFrame(const Vector<3>& opening, const FrontFoot& foot, const Vector<3>& face)
{
  const Vector<3> middle = foot.normal + face;
  if (!(norm(middle) > 0.1)) // a face that has turned by more than 174 degrees: no face of this front
    return inOwnFrame(opening, foot);
  const Vector<3> normal = 1.0 / norm(middle) * middle;
  const Vector<3> along = foot.direction - dot(foot.direction, normal) * normal;
  const double length = norm(along);
  const Vector<3> ahead = length > 0.0 ? 1.0 / length * along : foot.direction;
  return {dot(opening, ahead), dot(opening, normal), dot(opening, cross(ahead, normal))};
}

std::vector<Patch> patchesBehind(const CrackSet<3>& cracks, const CrackFront<3>& front,
                                 const FrontSight& sight, double reach)
{
  const Faces faces(cracks);
  const Crack<3>& crack = cracks.cracks[front.crack];
  std::vector<Patch> patches;
  for (int s = crack.firstSimplex; s < crack.firstSimplex + crack.numSimplices; ++s)
  {
    Patch patch;
    patch.normal = faces.normal(s);
    bool near = false;
    for (int i = 0; i < 3; ++i)
    {
      patch.x[i] = faces.corner(s, i);
      patch.opening[i] = faces.opening(s, i);
      near = near || sight.locate(patch.x[i]).distance < reach;
    }
    if (near)
      patches.push_back(patch);
  }
  return patches;
}

} // namespace

double releaseOf(const Intensities& K, const Elasticity& e)
{
  return (K.modeI * K.modeI + K.modeII * K.modeII) / e.effectiveModulus +
         K.modeIII * K.modeIII / (2.0 * e.shear);
}

std::vector<Intensities> openingsBehind(const CrackSet<3>& cracks, const CrackFront<3>& front,
                                        const FrontLine& line, const Elasticity& e, double cell,
                                        double halfWidth)
{
  const FrontSight sight(line, 0.0);
  const std::vector<Vector<3>> middles = middlesOfPieces();
  std::vector<Part> parts;
  for (const Patch& patch : patchesBehind(cracks, front, sight, furthest * cell))
  {
    const double area = 0.5 * norm(cross(patch.x[1] - patch.x[0], patch.x[2] - patch.x[0])) /
                        static_cast<double>(middles.size());
    for (const Vector<3>& w : middles)
    {
      const FrontFoot foot = sight.locate(w[0] * patch.x[0] + w[1] * patch.x[1] + w[2] * patch.x[2]);
      const Vector<3> opening = w[0] * patch.opening[0] + w[1] * patch.opening[1] + w[2] * patch.opening[2];
      // A front that has grown may have kinked: its own frame is kept.
      const Vector<3> split =
          front.grown ? inOwnFrame(opening, foot) : inTurnedFrame(opening, foot, patch.normal);
      parts.push_back({area, foot.distance, foot.line, foot.arc, {split[0], split[1], split[2]}});
    }
  }
  // All of a crack that is shorter than that.
  const double deepest = std::accumulate(parts.begin(), parts.end(), 0.0,
                                         [](double most, const Part& p) { return std::max(most, p.behind); });
  const double from = std::min(nearest * cell, 0.5 * deepest);
  std::vector<Intensities> all;
  for (int frontNode = 0; frontNode < static_cast<int>(line.nodes.size()); ++frontNode)
  {
    double sums[3] = {}, squares = 0.0;
    for (const Part& p : parts)
    {
      const double hat = hatOf(sight, p.line, p.arc, frontNode, halfWidth);
      if (hat <= 0.0 || p.behind < from || p.behind > furthest * cell)
        continue;
      const double shape = std::sqrt(p.behind / (2.0 * std::acos(-1.0))), weight = p.area * hat * shape;
      squares += weight * shape;
      for (int i = 0; i < 3; ++i)
        sums[i] += weight * p.opening[i];
    }
    Intensities K;
    if (squares > 0.0)
      K = {e.effectiveModulus / 8.0 * sums[1] / squares, e.effectiveModulus / 8.0 * sums[0] / squares,
           e.shear / 4.0 * sums[2] / squares};
    all.push_back(K);
  }
  return all;
}

Intensities scaleTo(const Intensities& K, double J, const Elasticity& e)
{
  const double release = releaseOf(K, e);
  if (!(J > 0.0) || !(release > 0.0))
    return {};
  const double factor = std::sqrt(J / release);
  return {factor * K.modeI, factor * K.modeII, factor * K.modeIII};
}

std::vector<Intensities> intensitiesAlong(const State<3>& state, const CrackFront<3>& front, double halfWidth,
                                          const std::vector<double>& J)
{
  const Properties& material = state.materials.properties[materialAt(state, front.position)];
  if (isAnisotropic(material)) // whose openings are not those of an isotropic body
    return std::vector<Intensities>(J.size(), Intensities{unknown, unknown, unknown});
  const Elasticity e = elasticity(material);
  std::vector<Intensities> K =
      openingsBehind(state.cracks, front, lineOf(front), e, spacingAt(state, front.position), halfWidth);
  for (std::size_t k = 0; k < K.size(); ++k)
    K[k] = std::isnan(J[k]) ? Intensities{J[k], J[k], J[k]} : scaleTo(K[k], J[k], e);
  return K;
}

} // namespace Rhegma::energy_release
