#include "rigid_tools/ToolSection.hpp"

#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "geometry/Shape.hpp"
#include "geometry/SurfacePoints.hpp"
#include "scene/BondedGroups.hpp"
#include "scene/CoreBodies.hpp"
#include "scene/FrictionSection.hpp"
#include "scene/NearestName.hpp"
#include "scene/RoundBodies.hpp"
#include "scene/SectionChecks.hpp"
#include "scene/TimeFunction.hpp"

#include <algorithm>
#include <set>

namespace Rhegma::rigid_tools
{

namespace
{

using Teuchos::ParameterList;

void refuseCombinations(Section& s)
{
  const Condition self = when::present("Rigid Tools");
  s.refuse({self, when::equilibrium()},
           "tools press on bodies in motion only; write Time > Analysis = Dynamic, or replace the tools by "
           "Boundaries of Type = Velocity");
  s.refuse({self, when::isNot("Time", "Initial State", {"Unloaded"})},
           "the equilibrium at the start does not include contact with tools; write Time > Initial State = "
           "Unloaded");
  s.refuse({self, when::is("Domain", "Formulation", {"Total Lagrangian"})},
           "cells that lie in the undeformed body do not see tools; write Domain > Formulation = Updated "
           "Lagrangian");
  s.refuse({self, when::isNot("Time", "Update Scheme", {"MUSL"})},
           "bodies that touch a tool strain by the velocity that MUSL projects at the end of a step; write "
           "MUSL");
  s.refuse({self, when::above("Time", "PIC Fraction", 0.0)},
           "a PIC fraction smooths velocities after contact, and its loss would be recorded as contact; "
           "write 0");
  s.refuse({self, when::isNot("Mass Matrix", "Type", {"Lumped"})},
           "impulses at a node need a lumped mass; write Mass Matrix > Type = Lumped or remove one of the "
           "two sections");
  s.refuse({self, when::isNot("Mass Matrix", "Velocity Update", {"FLIP"})},
           "the energy of contact needs Mass Matrix > Velocity Update = FLIP; write that");
  s.refuse({self, when::present("Sub-Cycling")},
           "tools act once in a step, and nodes of fine cells would take several; remove one of the two "
           "sections");
  s.refuse({self, when::isNot("Cracks", "Formulation", {"Dual Field"})},
           "tools press on cracked bodies at nodes with a field for each side of the crack; write Cracks > "
           "Formulation = Dual Field");
  s.refuse({self, when::present("Combustion")},
           "gas that leaves a crack does not see a tool that covers its open end; remove one of the two "
           "sections");
  s.refuse({self, when::is("Thermal", "Mechanics", {"false"})},
           "bodies that do not move do not press on tools; write Thermal > Mechanics = true or remove this "
           "section");
  s.refuse({when::given("Rigid Tools > *", "Friction Heat Fraction"), when::unprovided(capability::heat)},
           "bodies have no temperature; add the section Thermal, or leave it out");
}

void addMotion(Section& tool)
{
  tool.realArray("Velocity")
      .unit("m/s")
      .perAxis()
      .byDefaultZeros()
      .meaning("Prescribed velocity, to be multiplied by History; zero: a wall at rest. With Mass: the "
               "velocity at the start, or at Release Time.");
  tool.realArray("Angular Velocity")
      .unit("rad/s")
      .perRotationAxis()
      .byDefaultZeros()
      .meaning("Prescribed angular velocity about Pivot, to be multiplied by History; counter-clockwise in "
               "2D.");
  tool.realArray("Pivot")
      .unit("m")
      .perAxis()
      .optional("the middle of the shape's bounding box")
      .meaning(
          "Centre of the rotation at the start; it moves with Velocity. Its position is in the history.");
  tool.timeFunction("History")
      .optional("1")
      .meaning("Factor on Velocity and Angular Velocity as a function of time: an expression of t or a "
               "table \"0:0, 1e-3:5\".")
      .scalesRate("Velocity");
  tool.real("Mass").unit("kg").positive().optional().meaning(
      "Mass of the tool, which then moves by the forces on it, without rotation. In 2D that of the thickness "
      "of the scene. Without it the motion is prescribed.");
  tool.realArray("Force").unit("N").perAxis().optional().meaning(
      "Force on a tool with Mass, for example its weight.");
  tool.timeFunction("Force History").optional("1").meaning("Factor on Force as a function of time.");
  tool.text("Components")
      .notEmpty()
      .optional("all axes")
      .meaning("Axes along which a tool with Mass moves, such as \"y\". It is held along the others.");
  tool.real("Release Time")
      .unit("s")
      .notNegative()
      .optional("0")
      .meaning("Until then a tool with Mass is held at rest.");
}

} // namespace

Section toolSection()
{
  Section s("Rigid Tools",
            "Rigid tools: shapes without particles that press and slide on bodies, such as walls, rollers, "
            "punches and drop weights.");
  refuseAxisymmetric(s, "tools move in the plane, and do not press around a circle");
  Section tool("tool", "A tool: its shape, how it moves and how bodies slide on it.");
  describeShape(tool);
  addMotion(tool);
  tool.text("Bodies")
      .notEmpty()
      .optional("all bodies")
      .meaning("Names, separated by commas, of the bodies that it touches; others pass through it.");
  addFrictionLaw(tool);
  tool.real("Friction Heat Fraction")
      .range(0.0, 1.0)
      .optional("1")
      .meaning("Fraction of the energy of friction that heats the bodies, with the section Thermal; the tool "
               "takes the rest.");
  s.namedByUser(tool);
  refuseCombinations(s);
  return s;
}

namespace
{

/// Checks one tool.
class ToolChecks
{
public:
  ToolChecks(SectionChecks& checks, const ParameterList& tool, std::string where)
      : checks_(checks), tool_(tool), where_(std::move(where))
  {
  }

  void all()
  {
    motion();
    components();
    history("History");
    history("Force History");
    bodies();
    if (!checks_.isWhole(where_, ""))
      return;
    if (checks_.dimension() == 2)
      shape<2>();
    else if (checks_.dimension() == 3)
      shape<3>();
  }

private:
  void report(const std::string& parameter, const std::string& message)
  {
    checks_.report(scenePath(where_, parameter), message);
  }

  bool isZero(const std::string& name) const
  {
    const auto values = SceneValues::reals(tool_, name);
    return !values || std::all_of(values->begin(), values->end(), [](double v) { return v == 0.0; });
  }

  void motion()
  {
    if (tool_.isParameter("Mass"))
    {
      if (tool_.isParameter("History"))
        report("History", "is a factor on a prescribed velocity, but this tool has a Mass and moves by "
                          "forces; remove Mass, or write Force History for a factor on Force.");
      if (!isZero("Angular Velocity"))
        report("Angular Velocity",
               "is given, but a tool with Mass does not rotate; remove Mass or Angular Velocity.");
    }
    else
      for (const char* const name : {"Force", "Force History", "Components", "Release Time"})
        if (tool_.isParameter(name))
          report(name, "is given without Mass, so the motion of the tool is prescribed by Velocity and "
                       "History; write Mass too, or leave it out.");
    if (tool_.isParameter("Mass") && tool_.isParameter("Force History") && !tool_.isParameter("Force"))
      report("Force History", "is given without Force; write Force too.");
  }

  void components()
  {
    const std::string given = SceneValues::text(tool_, "Components");
    const std::string axes = checks_.dimension() == 2 ? "xy" : "xyz";
    std::set<char> seen;
    if (!std::all_of(given.begin(), given.end(),
                     [&](char letter)
                     { return axes.find(letter) != std::string::npos && seen.insert(letter).second; }))
      report("Components", "is \"" + given + "\"; write each axis once, such as \"" + axes + "\" or \"y\".");
  }

  void history(const std::string& name)
  {
    const auto& scene = checks_.scene();
    const auto end =
        scene.isSublist("Time") ? SceneValues::real(scene.sublist("Time"), "Final Time") : std::nullopt;
    const std::string given = SceneValues::text(tool_, name);
    if (!end || given.empty())
      return;
    if (const auto message = messageIfNotFinite(given, *end))
      report(name, *message);
  }

  void bodies()
  {
    const std::string given = SceneValues::text(tool_, "Bodies");
    if (given.empty() || !checks_.scene().isSublist("Bodies"))
      return;
    const std::vector<std::string> known = sublistNames(checks_.scene().sublist("Bodies"));
    for (const std::string& name : splitNames(given))
      if (std::find(known.begin(), known.end(), name) == known.end())
        report("Bodies", "there is no body \"" + name + "\"; " + suggestion(name, known));
  }

  template <int D>
  void shape()
  {
    try
    {
      const Shape<D> whole = makeShape<D>(tool_);
      insideDomain<D>(whole.bounds());
      if (!hasSurface(whole))
        checks_.report(where_,
                       tool_.isSublist("Operations")
                           ? "is fully cut away by its Operations, so nothing is left that could "
                             "press; cut less."
                           : "has no surface, as its size is less than rounding; write a larger one.");
    }
    catch (const std::invalid_argument& error)
    {
      checks_.report(where_, error);
    }
  }

  template <int D>
  static bool hasSurface(const Shape<D>& whole)
  {
    const double spacing = norm(whole.bounds().upper - whole.bounds().lower) / 32.0;
    for (std::size_t part = 0; part < whole.parts().size(); ++part)
      if (!Geometry::surfacePoints(whole, part, spacing).empty())
        return true;
    return false;
  }

  template <int D>
  void insideDomain(const Geometry::Bounds<D>& bounds)
  {
    const auto& scene = checks_.scene();
    if (!scene.isSublist("Domain"))
      return;
    const auto lower = SceneValues::reals(scene.sublist("Domain"), "Lower Corner"),
               upper = SceneValues::reals(scene.sublist("Domain"), "Upper Corner");
    if (!lower || !upper || lower->size() != D || upper->size() != D)
      return;
    for (int d = 0; d < D; ++d)
      if (bounds.lower[d] > (*upper)[d] || bounds.upper[d] < (*lower)[d])
        return checks_.report(where_, "lies from " + formatReal(bounds.lower[d]) + " to " +
                                          formatReal(bounds.upper[d]) + " m along " + "xyz"[d] +
                                          ", outside of the domain's " + formatReal((*lower)[d]) + " to " +
                                          formatReal((*upper)[d]) +
                                          " m, so no body can meet it; move the tool or enlarge the domain.");
  }

  SectionChecks& checks_;
  const ParameterList& tool_;
  std::string where_;
};

} // namespace

void checkTools(const ParameterList& scene, std::vector<SceneError>& errors)
{
  SectionChecks checks(scene, errors);
  if (sublistNames(scene.sublist("Rigid Tools")).empty())
    checks.report("Rigid Tools", "has no tool; add a list of any name with a Shape, or remove the section.");
  checks.forEach("Rigid Tools", [&](const ParameterList& tool, const std::string& where)
                 { ToolChecks(checks, tool, where).all(); });
  checks.forEach("Rigid Tools", [&](const ParameterList& tool, const std::string& where)
                 { checkFrictionLaw(tool, where, errors); });
}

} // namespace Rhegma::rigid_tools
