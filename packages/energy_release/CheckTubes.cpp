#include "energy_release/CheckTubes.hpp"

#include "base/Attempts.hpp"
#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "energy_release/ClearOfCracks.hpp"
#include "energy_release/FrontTube.hpp"
#include "energy_release/OtherMaterials.hpp"
#include "transfer/LocalSpacing.hpp"

#include <stdexcept>
#include <string>

namespace Rhegma::energy_release
{

namespace
{

/// A node may come to lie this fraction of a cell inside of the tube as the body moves.
constexpr double slack = 1e-6;

void refuseContour(const State<2>& state, const CrackFront<2>& front, const std::string& where,
                   const std::string& contour, const std::string& advice)
{
  throw std::invalid_argument("Energy Release > " + where + ": the domain integral of radius " + contour +
                              " m around " + frontName(state.cracks, front) +
                              " leaves the body, or reaches the other end of its crack or another " + advice +
                              ", or use smaller cells (Domain > Cell Size)");
}

/// Refuses radii of the scene between which no cell fits. \param cell at the front [m]
void refuseThinRing(const GivenRadii& given, double cell)
{
  const auto [inner, outer] = usualRadii(given, cell);
  if (outer < inner + (1.0 - slack) * cell)
    throw std::invalid_argument("Energy Release > Outer Radius: it must exceed Inner Radius by at least one "
                                "cell of " +
                                formatReal(cell) + " m; write at least " + formatReal(inner + cell) +
                                ", or a smaller Inner Radius");
}

/// Cells in the outer radius from which on G and K depend on it by less than 1 %
/// (docs/reference/warnings-of-cracks-and-runs.md).
constexpr double enoughCells = 4.0;

/// Warns of a contour of the scene that meets a crack.
void warnOfCracks(State<2>& state, const CrackFront<2>& front, double outer, double cell)
{
  const double clear = clearOfCracks(state.cracks, front, outer, cell);
  if (clear < outer - slack * cell)
    state.warnings.push_back(
        "Energy Release > Outer Radius: the domain integral of radius " + formatReal(outer) + " m around " +
        frontName(state.cracks, front) +
        " reaches the cells of another crack or of another part of its own, so G and K can have "
        "any value; write at most " +
        formatReal(clear));
}

/// Refuses radii of the scene that do not fit; reports the radii used where the default ones do not.
void checkTube(State<2>& state, const CrackFront<2>& front, const Options& options)
{
  const double cell = spacingAt(state, front.position);
  const GivenRadii& given = options.radii;
  if (given.outer > 0.0)
  {
    refuseThinRing(given, cell);
    const double clear = largestContour(state, front, given.outer);
    if (clear < given.outer - slack * cell)
      refuseContour(state, front, "Outer Radius", formatReal(given.outer),
                    "front; write at most " + formatReal(clear));
    warnOfCracks(state, front, given.outer, cell);
    return;
  }
  const double usual = usualRadii(given, cell).outer, capacity = clearAround(state, front, usual);
  const double least = smallestOuter(given, cell);
  if (capacity < least - slack * cell)
    refuseContour(state, front, given.inner > 0.0 ? "Inner Radius" : "Outer Radius", formatReal(least),
                  "front, another crack or another part of its own; at most " + formatReal(capacity) +
                      " m fit: " + (given.inner > 0.0 ? "write a smaller Inner Radius" : "write both radii"));
  if (capacity < usual - slack * cell)
  {
    const ContourRadii radii = fittingTube(state, front, given).radii;
    if (radii.outer >= (enoughCells - slack) * cell)
      return;
    state.warnings.push_back(
        "Energy Release: for " + frontName(state.cracks, front) +
        ", the domain integral is reduced to radii of " + readableLength(radii.inner) + " to " +
        readableLength(radii.outer) + " (" + formatShort(radii.outer / cell) +
        " cells), because of a surface, another front, another crack or another part of its "
        "own; G can be wrong by 2 % with less than four cells and by 5 % with two, K by half "
        "of it, next to another crack by 12 %: use smaller cells (Domain > Cell Size)");
  }
}

/// Warns where not even the smallest tube fits.
void warnOfSmallestTube(State<3>& state, const CrackFront<3>& front, const Options& options)
{
  const double cell = spacingAt(state, front.position), least = smallestOuter(options.radii, cell);
  const double clear = clearAround(state, front, least);
  if (clear < least - slack * cell)
    state.warnings.push_back("Energy Release: for " + frontName(state.cracks, front) +
                             ", the integration tube of " + readableLength(least) +
                             " meets a surface, another front, another crack or another part of its own, " +
                             readableLength(clear) +
                             " away, or exceeds the radius of curvature of the front; " +
                             "G and K can be wrong there: use smaller cells (Domain > Cell Size)");
}

/// Refuses an outer radius that the scene gives and that does not fit.
void checkTube(State<3>& state, const CrackFront<3>& front, const Options& options)
{
  if (front.numFacets == 0)
    return;
  if (options.radii.outer == 0.0)
    return warnOfSmallestTube(state, front, options);
  refuseThinRing(options.radii, spacingAt(state, front.position));
  const double clear = clearAround(state, front, options.radii.outer);
  if (clear < options.radii.outer - slack * spacingAt(state, front.position))
    throw std::invalid_argument(
        "Energy Release > Outer Radius: the integration tube of " + formatReal(options.radii.outer) +
        " m around " + frontName(state.cracks, front) +
        " leaves the body, reaches another front or crack, or exceeds the radius of curvature of the front; "
        "write at most " +
        formatReal(clear) + ", or use smaller cells (Domain > Cell Size)");
}

/// Warns of a material in the domain integral that is not that of the front. Particles lie up to half their
/// box inside of its border.
template <int D>
void warnOfMaterials(State<D>& state, const OtherMaterials<D>& others, const CrackFront<D>& front,
                     const ContourRadii& radii, const GivenRadii& given)
{
  const OtherMaterial other = others.nearest(front, radii.outer);
  if (other.material < 0)
    return;
  state.warnings.push_back(
      "Energy Release: the domain integral around " + frontName(state.cracks, front) + ", from " +
      readableLength(radii.inner) + " to " + readableLength(radii.outer) + ", contains Materials > " +
      state.materials.names[other.material] + ", " + readableLength(other.distance) +
      " from the front, and K assumes the moduli at the front; so does G_J unless the "
      "border of the materials is "
      "parallel to the crack: " +
      (other.distance > smallestOuter(given, spacingAt(state, front.position))
           ? "write an Outer Radius of less than this distance, or use smaller cells "
             "(Domain > Cell Size)"
           : "no domain integral fits between; if the crack is meant to lie on the border, use G "
             "and not K, else use smaller cells (Domain > Cell Size)"));
}

/// Warns of a material in the contour by whose G cracks grow.
void warnOfDrivingContour(State<2>& state, const OtherMaterials<2>& others, const CrackFront<2>& front,
                          const DrivingContours& driving)
{
  const double cell = spacingAt(state, front.position), outer = driving.releaseOuter * cell;
  const OtherMaterial other = others.nearest(front, outer);
  if (other.material < 0)
    return;
  state.warnings.push_back(
      "Propagation > Release Contour: " + frontName(state.cracks, front) +
      " grows by G of a domain integral of radius " + readableLength(outer) + " (" +
      formatReal(driving.releaseOuter) + " cells), which contains Materials > " +
      state.materials.names[other.material] + ", " + readableLength(other.distance) +
      " from the front: unless the border of the materials is parallel to the crack, this G is not the "
      "energy "
      "release rate, and the crack grows at a wrong load; use smaller cells (Domain > Cell Size)");
}

void warnOfDrivingContour(State<3>&, const OtherMaterials<3>&, const CrackFront<3>&, const DrivingContours&)
{
  // In 3D the contour is that of Energy Release.
}

/// Closer contours contain the inaccurate cells at the tip.
constexpr double leastInnerCells = 2.0;

} // namespace

template <int D>
void checkTubes(State<D>& state, const Options& options, const DrivingContours* driving)
{
  if (state.cracks.fronts.empty())
    throw std::invalid_argument(
        std::string("Energy Release: no crack has a front inside a body; end a crack inside material, choose "
                    "its front with Cracks > NAME > ") +
        (D == 2 ? "Fronts" : "Front Edges") + ", or remove this section");
  if (!options.contour)
    return;
  Attempts attempts;
  for (const CrackFront<D>& front : state.cracks.fronts)
    attempts.attempt([&] { checkTube(state, front, options); });
  attempts.throwIfAny();
  const OtherMaterials<D> others(state);
  for (const CrackFront<D>& front : state.cracks.fronts)
    if (others.any() && front.numFacets > 0)
    {
      warnOfMaterials(state, others, front, fittingTube(state, front, options.radii).radii, options.radii);
      if (driving != nullptr)
        warnOfDrivingContour(state, others, front, *driving);
    }
  const double cell = spacingAt(state, state.cracks.fronts.front().position);
  if (D == 2 && options.radii.inner > 0.0 && options.radii.inner < (leastInnerCells - slack) * cell)
    state.warnings.push_back(
        "Energy Release > Inner Radius is " + formatReal(options.radii.inner / cell) +
        " cells: below two cells the domain integral uses the inaccurate cells at the front, and G and K "
        "can be wrong by 10 % or more; use smaller cells or a larger radius");
}

template void checkTubes(State<2>&, const Options&, const DrivingContours*);
template void checkTubes(State<3>&, const Options&, const DrivingContours*);

} // namespace Rhegma::energy_release
