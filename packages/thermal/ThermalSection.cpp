#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "plan/BoundaryType.hpp"
#include "scene/HeatParameters.hpp"
#include "scene/TimeFunction.hpp"
#include "thermal/Thermal.hpp"

#include "material/ThermoMaterials.hpp"
#include "scene/RoundBodies.hpp"

#include <algorithm>
#include <stdexcept>

namespace Rhegma::thermal
{

namespace
{

Section sources()
{
  Section source("source", "A heat source. You choose its name.");
  source.chosenBy("Type").meaning("Shape of the heated region.");
  Section box("Box", "Uniform heat source in a fixed box.");
  box.realArray("Lower Corner")
      .unit("m")
      .perAxis()
      .meaning("Corner of the box with the smallest coordinates.");
  box.realArray("Upper Corner")
      .unit("m")
      .perAxis()
      .meaning("Corner of the box with the largest coordinates.");
  box.real("Power Density").unit("W/m3").meaning("Power per undeformed volume of the material in the box.");
  Section ball("Ball", "Uniform heat source in a disk (2D) or ball (3D) that may move.");
  ball.realArray("Centre").unit("m").perAxis().meaning("Its centre at time 0.");
  ball.realArray("Velocity").unit("m/s").perAxis().byDefaultZeros().meaning("Velocity of its centre.");
  ball.real("Radius").unit("m").positive().meaning("Its radius.");
  ball.real("Power").unit("W").meaning(
      "Total power, released in the part of the ball that lies in material; in 2D for Domain > Thickness.");
  for (Section* kind : {&box, &ball})
    kind->timeFunction("History").byDefault("1").meaning(
        "Factor on the power as a function of time: an expression of t or a table \"0:0, 1e-3:5\".");
  source.variant(box);
  source.variant(ball);
  Section s("Sources", "Heat sources inside the bodies.");
  s.namedByUser(source);
  return s;
}

Section probes()
{
  Section probe("probe", "A temperature probe. You choose its name.");
  probe.realArray("Point").unit("m").perAxis().meaning(
      "Position of the probe. It is fixed; material may move through it.");
  Section s("Probes",
            "Temperature probes. Their values are in history.csv as NAME.temperature and in summary.json.");
  s.namedByUser(probe);
  return s;
}

Section crackFaces()
{
  Section faces("crack", "Faces of one crack. The sublist has the name of the crack.");
  faces.choice("Conduction", {"Insulating", "When Closed", "Always"})
      .byDefault("Insulating")
      .meaning("Heat conduction across the crack: never, where the faces touch, or always.");
  faces.real("Conductance")
      .unit("W/(m2 K)")
      .positive()
      .optional("perfect contact")
      .meaning("Thermal contact conductance: heat flux per temperature jump between the faces.");
  Section s("Crack Faces", "Cracks that conduct heat across their faces. All others insulate.");
  s.namedByUser(faces);
  s.namesOf = "Cracks";
  return s;
}

std::string text(const Teuchos::ParameterList& list, const std::string& name)
{
  return list.isType<std::string>(name) ? list.get<std::string>(name) : std::string();
}

/// Calls work(list, path) for every sublist of a section.
template <class Work>
void forEach(const Teuchos::ParameterList& scene, const std::string& section, const Work& work)
{
  if (!scene.isSublist(section))
    return;
  const Teuchos::ParameterList& list = scene.sublist(section);
  for (const std::string& name : sublistNames(list))
    work(list.sublist(name), std::string(section).append(" > ").append(name));
}

const char* const nothingMoves =
    "it can't be combined with Thermal > Mechanics = false; remove one of the two";

void checkAlone(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors)
{
  forEach(scene, "Boundaries",
          [&](const Teuchos::ParameterList& list, const std::string& where)
          {
            const bool isGiven = list.isParameter("Type") && !list.getEntry("Type").isDefault();
            if (isGiven && text(list, "Type") != "" &&
                boundaryType(text(list, "Type")).capability != capability::heat)
              errors.push_back({where, nothingMoves});
          });
  forEach(scene, "Bodies",
          [&](const Teuchos::ParameterList& list, const std::string& where)
          {
            for (const char* name : {"Velocity", "Angular Velocity"})
              if (list.isType<Teuchos::Array<double>>(name))
              {
                const auto& values = list.get<Teuchos::Array<double>>(name);
                if (std::any_of(values.begin(), values.end(), [](double v) { return v != 0.0; }))
                  errors.push_back({where + " > " + name, nothingMoves});
              }
          });
}

bool strainsByHeat(const Teuchos::ParameterList& material)
{
  static const std::vector<std::string> moduli = {"Young Modulus", "Poisson Ratio", "C10", "C01",
                                                  "Bulk Modulus"};
  const bool table = std::any_of(moduli.begin(), moduli.end(),
                                 [&](const std::string& m) { return material.isType<std::string>(m); });
  return table || material.isParameter("Thermal Expansion") ||
         (material.isType<bool>("Entropic") && material.get<bool>("Entropic"));
}

void checkCoupled(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors)
{
  forEach(scene, "Materials",
          [&](const Teuchos::ParameterList& list, const std::string& where)
          {
            if (text(list, "Model") == "Rigid")
              errors.push_back({where + " > Model", "Rigid is for scenes with heat only; choose a law with "
                                                    "stress, or write Thermal > Mechanics = false"});
          });
}

} // namespace

namespace
{

void addRules(Section& s)
{
  const Condition alone = when::is("Thermal", "Mechanics", {"false"});
  for (const Condition& other :
       {when::present("Contact"), when::present("Damping"), when::present("Energy Release"),
        when::present("Face Pressure"), when::present("Mass Matrix"), when::present("Propagation"),
        when::present("Sub-Cycling")})
    s.refuse({alone, other}, nothingMoves, 1);
  s.refuse({alone, when::given("Adaptivity", "Velocity Change")},
           "it can't be combined with Thermal > Mechanics = false; write Temperature Change", 1);
  // The opening in crack closure is inaccurate where thermal strain differs between the faces (a fifth of G
  // around an insulating crack). With propagation it is not used.
  s.refuse({when::is("Thermal", "Mechanics", {"true"}), when::is("Energy Release", "Crack Closure", {"true"}),
            when::absent("Propagation"),
            when::satisfies("Materials > *", "with thermal strain or moduli that change with temperature",
                            strainsByHeat)},
           "crack closure does not include temperature-dependent stress; set it to false and use J", 1);
  s.refuse({when::present("Thermal > Crack Faces"), when::absent("Cracks")},
           "there are no cracks; add the section Cracks or leave this section out");
  s.refuse({when::isNot("Thermal > Crack Faces > *", "Conduction", {"Insulating"}),
            when::isNot("Cracks", "Formulation", {"Dual Field"})},
           "conducting faces need Cracks > Formulation = Dual Field; write that, or let them insulate");
  s.refuse({when::isNot("Thermal > Crack Faces > *", "Conduction", {"Insulating"}),
            when::is("Thermal", "Conduction", {"Super Time Stepping"})},
           "super time stepping does not include what passes through faces; write Thermal > Conduction = "
           "Implicit or Explicit, or let them insulate");
  s.refuse({when::above("Thermal", "Front Heat Fraction", 0.0), when::absent("Propagation")},
           "it needs the section Propagation; add it or leave this parameter out");
  s.provide(capability::heat);
}

} // namespace

Section thermalSection()
{
  Section s("Thermal", "Heat conduction, heat sources, thermal strain and thermomechanical heating.");
  s.refuse(
      {when::isNot("Thermal", "Mechanics", {"false"}), when::axisymmetric()},
      std::string("thermal strain does not reach the hoop; write Mechanics = false for temperatures alone") +
          orInSpace);
  s.refuse({when::present("Thermal"), when::axisymmetric(), when::present("Cracks")},
           std::string("heat crosses cracks per thickness, not around a circle") + orInSpace);
  s.refuse({when::isNot("Thermal", "Conduction", {"Steady"}), when::is("Time", "Analysis", {"Static"})},
           "heat conduction needs time, which a static analysis does not have; write Conduction = Steady, or "
           "Analysis = "
           "Quasi-Static");
  s.refuse({when::is("Thermal", "Conduction", {"Steady"}), when::is("Time", "Analysis", {"Dynamic"})},
           "steady conduction belongs to an equilibrium; write Analysis = Static or Quasi-Static, or another "
           "Conduction");
  s.refuse(
      {when::is("Thermal", "Conduction", {"Steady"}), when::above("Thermal", "Front Heat Fraction", 0.0)},
      "the heat of a growing front passes with time; write Conduction = Implicit");
  s.refuse({when::present("Thermal"), when::isNot("Time", "Initial State", {"Unloaded"})},
           "the equilibrium at the start does not include thermal stress; write Initial State = Unloaded");
  s.refuse({when::is("Thermal", "Mechanics", {"false"}), when::equilibrium()},
           "without mechanics there is no equilibrium to solve for; write Analysis = Dynamic");
  s.real("Initial Temperature")
      .unit("K")
      .positive()
      .meaning("Initial temperature of all bodies without a temperature of their own.");
  s.boolean("Mechanics")
      .byDefault(true)
      .meaning("If false, heat only: no motion, no stress, and the time step is that of conduction.");
  s.real("Diffusion Number")
      .above(0.0)
      .atMost(0.5)
      .byDefault(0.35)
      .meaning("Largest conduction time step, as k dt / (rho c h^2) with h the edge of the finest cells.");
  s.choice("Conduction", {"Explicit", "Super Time Stepping", "Implicit", "Steady"})
      .byDefault("Explicit")
      .meaning("Time integration of conduction: explicit; RKL2 super time stepping, stable for much larger "
               "steps; or backward Euler with conjugate gradients. Steady: no time integration, but the "
               "steady state "
               "of each load step, with the boundary values at its end (Static: at Final Time).");
  s.real("Step Ratio")
      .atLeast(1.0)
      .byDefault(20.0)
      .meaning("For Super Time Stepping and Implicit: largest time step over the largest explicit one.");
  s.real("Front Heat Fraction")
      .range(0.0, 1.0)
      .byDefault(0.0)
      .meaning("Fraction of the fracture energy of growing cracks that becomes heat around their fronts.");
  s.real("Front Radius")
      .unit("m")
      .positive()
      .optional()
      .meaning("Radius of the disk (2D) or ball (3D) around a front point in which this heat is released.");
  s.subsection(sources());
  s.subsection(probes());
  s.subsection(crackFaces());
  addRules(s);
  return s;
}

namespace
{

/// Sources must have a power at any time of the run.
void checkHistories(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors)
{
  const Teuchos::ParameterList& list = scene.sublist("Thermal");
  if (!list.isSublist("Sources") || !scene.isSublist("Time") ||
      !scene.sublist("Time").isType<double>("Final Time"))
    return;
  for (const std::string& name : sublistNames(list.sublist("Sources")))
  {
    const Teuchos::ParameterList& source = list.sublist("Sources").sublist(name);
    if (!source.isType<std::string>("History"))
      continue;
    if (const auto message = messageIfNotFinite(source.get<std::string>("History"),
                                                scene.sublist("Time").get<double>("Final Time")))
      errors.push_back({"Thermal > Sources > " + name + " > History", *message});
  }
}

/// A steady state without a prescribed temperature is only known up to a constant.
void checkSteady(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors)
{
  if (text(scene.sublist("Thermal"), "Conduction") != "Steady")
    return;
  bool prescribed = false;
  forEach(scene, "Boundaries",
          [&](const Teuchos::ParameterList& list, const std::string&)
          {
            const std::string type = text(list, "Type");
            prescribed = prescribed || type == "Temperature" || type == "Convection";
          });
  if (!prescribed)
    errors.push_back({"Thermal > Conduction",
                      "a steady state without a prescribed temperature is known only up to a constant; add a "
                      "boundary of type Temperature or Convection (Boundaries), or write Implicit and Time > "
                      "Analysis = Quasi-Static"});
}

void checkCrackFaces(const Teuchos::ParameterList& list, std::vector<SceneError>& errors)
{
  if (!list.isSublist("Crack Faces"))
    return;
  for (const std::string& name : sublistNames(list.sublist("Crack Faces")))
  {
    const std::string where = "Thermal > Crack Faces > " + name;
    const Teuchos::ParameterList& faces = list.sublist("Crack Faces").sublist(name);
    const bool conducts =
        faces.isType<std::string>("Conduction") && faces.get<std::string>("Conduction") != "Insulating";
    if (!conducts && faces.isParameter("Conductance"))
      errors.push_back(
          {where + " > Conductance",
           "the faces insulate; write Conduction = Always or When Closed, or leave this parameter out"});
  }
}

/// Surfaces must not prescribe a temperature at or below absolute zero: the first of 200 times of the run.
void checkSurfaces(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors)
{
  if (!scene.isSublist("Time") || !scene.sublist("Time").isType<double>("Final Time"))
    return;
  const double end = scene.sublist("Time").get<double>("Final Time");
  forEach(scene, "Boundaries",
          [&](const Teuchos::ParameterList& list, const std::string& where)
          {
            const std::string name =
                text(list, "Type") == "Convection" ? "Ambient Temperature" : "Temperature";
            const bool held = text(list, "Type") == "Temperature" || text(list, "Type") == "Convection";
            if (!held || !list.isType<double>(name) || !list.isType<std::string>("History"))
              return;
            try
            {
              const TimeFunction history = TimeFunction::parse(list.get<std::string>("History"));
              for (int k = 0; k <= 200; ++k)
                if (const double T = list.get<double>(name) * history(end * k / 200); !(T > 0.0))
                {
                  errors.push_back({where + " > History",
                                    "times " + name + " it is " + formatReal(T) + " K at " +
                                        formatReal(end * k / 200) +
                                        " s; temperatures are absolute, write values that stay above zero"});
                  return;
                }
            }
            catch (const std::invalid_argument&)
            {
              // Invalid functions are reported elsewhere.
            }
          });
}

} // namespace

void checkThermal(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors)
{
  const Teuchos::ParameterList& list = scene.sublist("Thermal");
  checkHistories(scene, errors);
  checkSurfaces(scene, errors);
  checkSteady(scene, errors);
  checkCrackFaces(list, errors);
  if (list.isType<bool>("Mechanics") && !list.get<bool>("Mechanics"))
    checkAlone(scene, errors);
  else
    checkCoupled(scene, errors);
  if (list.isType<double>("Front Heat Fraction") && list.get<double>("Front Heat Fraction") > 0.0)
    if (!list.isParameter("Front Radius"))
      errors.push_back({"Thermal > Front Radius", "is missing; Front Heat Fraction above 0 needs it"});
}

} // namespace Rhegma::thermal
