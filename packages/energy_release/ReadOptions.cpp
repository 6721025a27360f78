#include "energy_release/ReadOptions.hpp"

#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "energy_release/FrontTube.hpp"
#include "plan/Axis.hpp"
#include "scene/FillFromIntensity.hpp"

#include <algorithm>

namespace Rhegma::energy_release
{

namespace
{

const char* const nothingLeft =
    "it must be true if crack closure is not available; set it to true or remove the section Energy Release";

/// With what the cracks are compared that do not grow.
void describeToughness(Section& s)
{
  s.real("Toughness")
      .unit("J/m2")
      .positive()
      .optional("no comparison")
      .meaning("Energy release rate at which the cracks would start. The summary then says how close they "
               "come to it; they do not grow. For cracks that grow see Propagation.");
  describeToughnessByOtherMeans(s);
  s.refuse({when::given("Energy Release", "Toughness"), when::present("Propagation")},
           "the cracks grow by the toughness of the section Propagation; leave Toughness and Toughness From "
           "Library out here");
  s.refuse(
      {when::given("Energy Release", "Toughness"), when::is("Energy Release", "Contour Integral", {"false"})},
      "it is compared with G of the domain integrals; write Contour Integral = true or leave it out");
}

} // namespace

Section energyReleaseSection()
{
  Section s(
      "Energy Release",
      "Energy release rate and stress intensity factors of every crack front, at every history sample.");
  s.real("Inner Radius")
      .unit("m")
      .positive()
      .optional("3 cells in 2D, 2.5 in 3D; at most half of Outer Radius")
      .meaning("Inner radius of the domain integrals: the weight function is 1 up to this distance from the "
               "front. Below two cells in 2D, G and K can be wrong by 10 % or more.");
  s.real("Outer Radius")
      .unit("m")
      .positive()
      .optional("6 cells in 2D, 5 in 3D, or twice a given Inner Radius; reduced if it leaves the body or "
                "reaches another front or crack or, in 3D, the centre of curvature of the front")
      .meaning("Outer radius of the domain integrals: the weight function is 0 from this distance on. A "
               "given radius must stay inside the body and clear of other fronts.");
  s.boolean("Contour Integral")
      .onlyIn(2)
      .byDefault(true)
      .meaning("Computes J and the stress intensity factors by domain integrals. Set it to false where cells "
               "are too large for a domain integral inside the body; crack closure is then used alone.");
  s.boolean("Crack Closure")
      .onlyIn(2)
      .byDefault(true)
      .meaning("Also computes G by crack closure, from the forces ahead of the front and the opening behind "
               "it. Needs a front along a grid direction; not with Cracks > Formulation = Broken Cell, "
               "with Propagation nor in axisymmetric scenes.");
  s.boolean("Lumped Closure")
      .onlyIn(2)
      .byDefault(false)
      .meaning("Also reports crack closure with openings from a lumped projection, for comparison. Its error "
               "is up to 25 % and need not decrease with the cell size.");
  s.integer("Closure Cells")
      .onlyIn(2)
      .range(1, 2)
      .byDefault(1)
      .meaning("Number of cell columns over which crack closure acts.");
  s.choice("Closure Recovery", {"Consistent", "Lumped", "Mass Matrix"})
      .onlyIn(2)
      .byDefault("Consistent")
      .meaning("Mass matrix used to recover nodal displacements for crack closure: consistent, lumped, or "
               "that of the section Mass Matrix (lumped without that section).");
  describeToughness(s);
  s.refuse({when::is("Energy Release", "Contour Integral", {"false"}),
            when::is("Domain", "Plane", {"Axisymmetric"})},
           "crack closure is not available for rings; set it to true or remove the section Energy Release");
  s.needs("Cracks", "there are no cracks; add the section Cracks or remove this section");
  // The opening of Broken Cell is not known.
  s.refuse({when::is("Energy Release", "Contour Integral", {"false"}),
            when::is("Cracks", "Formulation", {"Broken Cell"})},
           nothingLeft);
  return s;
}

namespace
{

bool isThreeDimensional(const Teuchos::ParameterList& scene)
{
  if (!scene.isSublist("Domain"))
    return false;
  const Teuchos::ParameterList& domain = scene.sublist("Domain");
  return domain.isType<int>("Dimension") && domain.get<int>("Dimension") == 3;
}

GivenRadii readRadii(const Teuchos::ParameterList& scene)
{
  const Teuchos::ParameterList& list = scene.sublist("Energy Release");
  GivenRadii given = isThreeDimensional(scene) ? usualCells<3>() : usualCells<2>();
  if (list.isType<double>("Inner Radius"))
    given.inner = list.get<double>("Inner Radius");
  if (list.isType<double>("Outer Radius"))
    given.outer = list.get<double>("Outer Radius");
  return given;
}

} // namespace

void checkEnergyRelease(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors)
{
  const Teuchos::ParameterList& list = scene.sublist("Energy Release");
  const auto refused = [&](const char* name) { return list.isType<bool>(name) && !list.get<bool>(name); };
  const bool contour = !refused("Contour Integral");
  if (!contour && refused("Crack Closure"))
    errors.push_back({"Energy Release > Contour Integral", nothingLeft});
  const GivenRadii given = readRadii(scene);
  if (contour && given.outer > 0.0 && given.outer <= given.inner)
    errors.push_back({"Energy Release > Outer Radius",
                      "it must exceed Inner Radius = " + formatReal(given.inner) +
                          " by at least one cell; write a larger one, or a smaller Inner Radius"});
}

namespace
{

/// What the nodes move with.
RecoveryMatrix matrixOfTheMotion(const NodalMass& mass)
{
  return {std::max(mass.lumpedFraction, consistentMatrix().lumpedFraction),
          mass.smallestNode,
          mass.radius,
          mass.edge,
          mass.terms,
          mass.radiusCells,
          mass.edgeCells};
}

RecoveryMatrix recoveryOf(const std::string& choice, const NodalMass& mass)
{
  return choice == "Mass Matrix" ? matrixOfTheMotion(mass)
         : choice == "Lumped"    ? lumpedMatrix()
                                 : consistentMatrix();
}

} // namespace

Options readOptions(const Teuchos::ParameterList& scene, const RunOptions& run)
{
  const Teuchos::ParameterList& list = scene.sublist("Energy Release");
  Options options;
  options.openingKnown = run.openingKnown;
  options.radii = readRadii(scene);
  options.toughness = list.isParameter("Toughness") ? list.get<double>("Toughness") : 0.0;
  options.criticalIntensity = list.isType<double>("K_Ic") ? list.get<double>("K_Ic") : 0.0;
  if (isThreeDimensional(scene)) // crack closure is 2D only
    return options;
  if (run.growth) // round cracks that run the usual radii are those by which they run
  {
    options.radii.innerCells = run.contours.releaseInner;
    options.radii.outerCells = run.contours.releaseOuter;
  }
  options.contour = list.get<bool>("Contour Integral");
  // The opening behind a front that runs is that of its cohesive zone. Nodes of rings ahead and behind have
  // forces on circles of different lengths.
  options.closure = list.get<bool>("Crack Closure") && !run.growth && !isAxisymmetric(scene);
  options.pushed = run.pressedCracks;
  options.lumped = list.get<bool>("Lumped Closure");
  options.columns = list.get<int>("Closure Cells");
  options.recovery = recoveryOf(list.get<std::string>("Closure Recovery"), run.nodalMass);
  return options;
}

} // namespace Rhegma::energy_release
