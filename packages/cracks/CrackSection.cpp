#include "cracks/CrackSection.hpp"

#include "base/EntryValue.hpp"
#include "base/ReadList.hpp"
#include "scene/ErrorIndex.hpp"
#include "scene/RoundBodies.hpp"

#include <string>
#include <vector>

namespace Rhegma::cracks
{

namespace
{

/// Checks that a crack has one shape with all of its parameters.
void checkShape(const Teuchos::ParameterList& crack, const std::string& where, bool flat,
                std::vector<SceneError>& errors)
{
  const auto has = [&](const char* name) { return crack.isParameter(name); };
  const int shapes = (has("Points") ? 1 : 0) + (has("Radius") ? 1 : 0) + (has("Surface File") ? 1 : 0);
  if (shapes == 0 && flat)
    errors.push_back({where + " > Points", "is missing; write the crack as a polyline, point after point"});
  else if (shapes == 0)
    errors.push_back({where + " > Points",
                      "is missing; write the corners of a polygon, or Centre, Normal and Radius of a disk, "
                      "or a Surface File"});
  else if (shapes > 1)
    errors.push_back({where, "it has more than one shape; keep only one of Points, Radius and Surface File"});
  if (shapes == 0)
    return;
  for (const char* name : {"Centre", "Normal"})
    if (has("Radius") && !has(name))
      errors.push_back({where + " > " + name, "is missing; a disk has Centre, Normal and Radius"});
  for (const char* name : {"Centre", "Normal", "Second Radius", "Radius Direction"})
    if (!has("Radius") && has(name))
      errors.push_back({where + " > " + name, "belongs to a disk; write its Radius too, or leave this out"});
  if (has("Front Edges") && !has("Points"))
    errors.push_back({where + " > Front Edges", "is for polygons, which have Points; leave it out"});
}

void checkShapes(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors)
{
  if (!scene.isSublist("Domain") || !scene.sublist("Domain").isType<int>("Dimension"))
    return;
  const bool flat = scene.sublist("Domain").get<int>("Dimension") == 2;
  const ErrorIndex found(errors);
  for (const auto& entry : scene.sublist("Cracks"))
    if (const auto* crack = valueIf<Teuchos::ParameterList>(entry.second))
    {
      const std::string where = "Cracks > " + entry.first;
      if (!found.hasBelow(where, "")) // otherwise further checks are meaningless
        checkShape(*crack, where, flat, errors);
    }
}

/// What is available for dual fields only.
void refuseOtherFormulations(Section& s)
{
  s.refuse(
      {when::is("Cracks", "Formulation", {"Broken Cell", "Corrected Broken Cell"}),
       when::is("Domain", "Shear Strain", {"At Cell Centres"})},
      "shear strain at cell centres is available for dual fields only; write Dual Field or At Particles");
  const auto brokenCells = when::is("Cracks", "Formulation", {"Broken Cell", "Corrected Broken Cell"});
  const char* const verified =
      "in equilibrium it has been verified with dual fields only; write Formulation = Dual Field";
  s.refuse({when::present("Contact"), brokenCells, when::equilibrium()}, verified);
  s.refuse({when::present("Propagation"), brokenCells, when::equilibrium()}, verified);
  s.refuse({when::is("Cracks", "Formulation", {"Corrected Broken Cell"}), when::axisymmetric()},
           "extrapolated cells have no hoop strain; write Formulation = Dual Field");
  s.refuse({brokenCells}, "broken cells are available in 2D only; write Dual Field", 0, 3);
  // N^T m N / M of the projection has eigenvalues up to 1 if no weight is negative, and above it else.
  const auto negative = when::is("Cracks", "Formulation", {"Corrected Broken Cell"});
  s.refuse(
      {negative, when::is("Mass Matrix", "Velocity Update", {"PIC", "XPIC", "FMPM"})},
      "weights of corrected cells may be negative, with which projections of the velocity grow from step "
      "to step; write Velocity Update = FLIP, or Formulation = Dual Field");
  s.refuse(
      {negative, when::above("Time", "PIC Fraction", 0.0)},
      "weights of corrected cells may be negative, with which projections of the velocity grow from step "
      "to step; remove PIC Fraction, or write Formulation = Dual Field");
}

} // namespace

Section crackSection()
{
  Section s("Cracks",
            "Explicit cracks: polylines (2D) or surfaces (3D) that cut bodies independently of the grid.");
  s.choice("Formulation", {"Dual Field", "Broken Cell", "Corrected Broken Cell"})
      .byDefault("Dual Field")
      .meaning("How cracked cells are treated. Dual Field: one velocity field on each side of the crack. "
               "Broken Cell: shape functions truncated by visibility. Corrected Broken Cell: the same, made "
               "linearly complete by extrapolation.");
  s.provide(capability::cracks);
  refuseOtherFormulations(s);
  s.boolean("Front Springs")
      .formerly("Front Ties")
      .byDefault(true)
      .meaning("Penalty springs between the two fields of nodes within a cell of a front, so that the crack "
               "on the grid ends at its front and not at the next column of nodes. Dual Field only.");
  Section crack("crack", "A crack. You choose its name.");
  crack.realArray("Points")
      .unit("m")
      .perPoint(2)
      .optional("absent (in 3D Radius or Surface File may replace it)")
      .meaning("2D: points of a polyline. 3D: at least three corners of a plane polygon, convex or not, in "
               "order around it. Parts outside the bodies are cut off.");
  crack.realArray("Centre").unit("m").perAxis().optional().onlyIn(3).meaning(
      "Centre of a disk-shaped or elliptical crack.");
  crack.realArray("Normal").perAxis().optional().onlyIn(3).meaning(
      "Normal of the disk, of any non-zero length, from side -1 to side +1 of the crack.");
  crack.real("Radius")
      .unit("m")
      .positive()
      .optional("absent (Points or Surface File may replace it)")
      .onlyIn(3)
      .meaning("Radius of the disk, or one semi-axis of an ellipse.");
  crack.real("Second Radius")
      .unit("m")
      .positive()
      .optional("Radius")
      .onlyIn(3)
      .meaning("Other semi-axis of the ellipse, normal to Radius Direction.");
  crack.realArray("Radius Direction")
      .perAxis()
      .optional("the coordinate axis farthest from Normal")
      .onlyIn(3)
      .meaning("Direction of Radius. Its component normal to the crack plane is ignored.");
  crack.text("Surface File")
      .notEmpty()
      .optional("absent (Points or Radius may replace it)")
      .onlyIn(3)
      .meaning("Path (relative to the scene) of an STL or OBJ file with the crack as a triangulated surface "
               "in metres. Its edges inside material are crack fronts.");
  crack.choice("Fronts", {"Automatic", "First", "Last", "Both", "None"})
      .byDefault("Automatic")
      .onlyIn(2)
      .meaning("Which ends of the polyline are crack fronts. Automatic: every end inside material.");
  crack.integerArray("Front Edges")
      .optional("edges inside material")
      .onlyIn(3)
      .meaning("Edges of the polygon that are crack fronts; the others are free edges. Edge k goes from "
               "point k to the next, counted from 1.");
  s.namedByUser(crack);
  return s;
}

void checkCracks(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors)
{
  if (sublistNames(scene.sublist("Cracks")).empty())
    errors.push_back({"Cracks",
                      "the section holds no crack; write one as <ParameterList name=\"...\"> or leave "
                      "the section out"});
  checkShapes(scene, errors);
}

} // namespace Rhegma::cracks
