#include "scene/CoreSections.hpp"

#include "base/EntryValue.hpp"
#include "material/Laws.hpp"
#include "material/MaterialTable.hpp"
#include "scene/CoreBodies.hpp"
#include "scene/HeatParameters.hpp"
#include "scene/NearestName.hpp"
#include "scene/RoundBodies.hpp"
#include "scene/Schema.hpp"

#include <algorithm>

namespace Rhegma
{

namespace
{

/// What is not there for bodies of revolution.
void addRulesOfAxisymmetry(Section& s)
{
  const Condition round = when::axisymmetric();
  s.refuse({round, when::satisfies("Domain", "Thickness that is given",
                                   [](const Teuchos::ParameterList& domain)
                                   {
                                     const auto* thickness = domain.getEntryPtr("Thickness");
                                     return thickness != nullptr && !thickness->isDefault();
                                   })},
           "masses, forces and energies are those of the whole circle; leave Thickness out", 1);
  s.refuse({round, when::is("Domain", "Shear Strain", {"At Cell Centres"})},
           "slopes at cell centres have no hoop strain; write Shear Strain = At Particles", 1);
  const auto firstOf = [](const char* name)
  {
    return [name](const Teuchos::ParameterList& list)
    {
      const auto* values = list.getEntryPtr(name);
      return values != nullptr && values->isType<Teuchos::Array<double>>() &&
             Teuchos::any_cast<Teuchos::Array<double>>(values->getAny())[0] != 0.0;
    };
  };
  s.refuse({round,
            when::satisfies("Bodies > *", "Angular Velocity that is not zero", firstOf("Angular Velocity"))},
           "a body of revolution can't turn out of its axis; leave Angular Velocity out", 1);
  s.refuse(
      {round, when::satisfies("Boundaries > *", "Acceleration along x", firstOf("Acceleration"))},
      "x is the radius, and weight that pulls outwards on all sides does not exist; write 0 for the first "
      "number",
      1);
}

Section domain()
{
  Section s("Domain", "The computational domain: dimension, background grid and shape functions.");
  s.require();
  s.integer("Dimension").range(2, 3).meaning("2 for plane problems, 3 for three-dimensional ones.");
  s.choice("Plane", {"Strain", "Stress", "Axisymmetric"})
      .onlyIn(2)
      .byDefault("Strain")
      .meaning("Plane strain, plane stress, or a body of revolution without torsion: x is the radius, y the "
               "axis, and masses, forces and energies are those of the whole circle "
               "(docs/how-to/axisymmetric.md).");
  s.real("Thickness")
      .unit("m")
      .onlyIn(2)
      .positive()
      .byDefault(1.0)
      .meaning("Thickness normal to the plane. Masses, forces and energies are for this thickness.");
  s.realArray("Lower Corner")
      .unit("m")
      .perAxis()
      .meaning("Corner of the domain with the smallest coordinates.");
  s.realArray("Upper Corner")
      .unit("m")
      .perAxis()
      .meaning("Corner of the domain with the largest coordinates.");
  s.real("Cell Size")
      .unit("m")
      .positive()
      .optional("chosen by Accuracy")
      .meaning(
          "Edge length of the square (2D) or cubic (3D) cells of the background grid, before refinement.");
  s.choice("Accuracy", {"10 %", "3 %", "1 %", "0.3 %"})
      .optional()
      .meaning(
          "Target error of G, K or a temperature rise. The program chooses Cell Size if it is absent, "
          "and adds Adaptivity and Sub-Cycling at crack fronts if the scene has neither. Values given "
          "in the scene are kept. A Cell Size that is too large is rejected if cells can't be refined to the "
          "required size (docs/how-to/accuracy.md).");
  s.choice("Shape Functions", {"Linear", "GIMP"})
      .byDefault("GIMP")
      .meaning("Linear: cheap, but stresses jump when particles cross cell boundaries. GIMP: shape functions "
               "averaged over the particle domain; smoother.");
  s.choice("Shear Strain", {"At Particles", "At Cell Centres"})
      .byDefault("At Particles")
      .meaning("Position at which the shear strain of a particle, and the nodal force of its shear stress, "
               "are evaluated. At Particles: at the particle, like normal strain. At Cell Centres: constant "
               "in each cell, which removes the excess bending stiffness of few cells; use it with Particles "
               "Per Cell = 3. It is for beams and plates within 20 degrees of the grid axes; at larger "
               "angles they become too soft (docs/explanation/verification/beams.md).");
  s.choice("Formulation", {"Updated Lagrangian", "Total Lagrangian"})
      .byDefault("Updated Lagrangian")
      .meaning(
          "Configuration in which the cells lie. Updated Lagrangian: the deformed body, which moves through "
          "the cells; bodies that meet touch. Total Lagrangian: the undeformed body. Particles stay in their "
          "cells, so that stresses do not change when a body moves or turns through the grid, and supports "
          "and loads stay on the material at which they are at the start; bodies do not meet "
          "(docs/explanation/total-lagrangian.md).");
  addRulesOfAxisymmetry(s);
  return s;
}

/// What follows an equilibrium in which cracks grow unstably.
void addUnstableGrowth(Section& s)
{
  s.choice("Unstable Growth", {"Equilibrium", "Dynamic"})
      .byDefault("Equilibrium")
      .meaning(
          "What follows where cracks grow unstably in a quasi-static analysis. Equilibrium: they grow on "
          "under the loads of that time. Dynamic: the run goes on as motion from the equilibrium before "
          "this growth, under loads that go on by their functions of time.");
  const Condition asMotion = when::is("Time", "Unstable Growth", {"Dynamic"});
  s.refuse({asMotion, when::isNot("Time", "Analysis", {"Quasi-Static"})},
           "only a quasi-static analysis finds where growth becomes unstable; write Analysis = Quasi-Static, "
           "or leave it out");
  s.refuse({asMotion, when::absent("Propagation")},
           "there is no section Propagation, so that no crack grows; add it, or leave Unstable Growth out");
  s.refuse(
      {asMotion, when::present("Contact")},
      "closed faces can't be taken over from equilibrium to motion; remove the section Contact, or leave "
      "Unstable Growth out");
  s.refuse(
      {asMotion, when::present("Thermal")},
      "temperatures can't be taken over from equilibrium to motion; remove the section Thermal, or leave "
      "Unstable Growth out");
  s.real("Dynamic Time")
      .unit("s")
      .positive()
      .mayChange()
      .optional("up to Final Time")
      .meaning("With Unstable Growth = Dynamic: the run ends this time after motion has begun, if Final Time "
               "is not earlier.");
  s.refuse({when::given("Time", "Dynamic Time"), when::isNot("Time", "Unstable Growth", {"Dynamic"})},
           "motion follows only with Unstable Growth = Dynamic; write that, or leave Dynamic Time out");
}

/// How equilibrium is solved.
void addStepsOfEquilibrium(Section& s)
{
  s.integer("Load Steps")
      .atLeast(1)
      .mayChange()
      .optional("1 for Static, 20 for Quasi-Static")
      .meaning("Minimum number of load steps of an equilibrium analysis. A load step that does not converge "
               "is halved; the steps grow again after steps that converge.");
  s.choice("Rigid Modes", {"Refuse", "Remove"})
      .byDefault("Refuse")
      .meaning("Treatment of rigid-body modes in an equilibrium analysis. Refuse: a body that can move or "
               "rotate freely is an error. Remove: the body keeps its mean position and orientation, and the "
               "resultant of its loads is balanced by uniform acceleration (inertia relief).");
  s.choice("Linear Solver", {"Automatic", "Direct", "Iterative"})
      .byDefault("Automatic")
      .mayChange()
      .meaning(
          "How linear systems of equilibrium are solved. Automatic: by their size. Direct: by factorisation, "
          "which needs the most memory. Iterative: by conjugate gradients, or by GMRES where friction makes "
          "the matrix unsymmetric, and directly only if they fail.");
}

Section time()
{
  Section s("Time", "Duration, time step and update scheme.");
  s.require();
  s.real("Final Time").unit("s").positive().mayChange().meaning("Physical time at which the run ends.");
  s.choice("Analysis", {"Dynamic", "Static", "Quasi-Static"})
      .byDefault("Dynamic")
      .meaning("Dynamic: motion, by explicit steps. Static: equilibrium under the loads at Final Time, which "
               "are applied in proportion to time. Quasi-Static: equilibrium at each time under the loads of "
               "that time.");
  s.choice("Initial State", {"Unloaded", "Equilibrium", "Equilibrium Without Cracks"})
      .byDefault("Unloaded")
      .meaning("State in which a dynamic run starts. Equilibrium: static equilibrium under the tractions, "
               "loads, gravity and face pressures at time 0, with supported nodes fixed. Equilibrium Without "
               "Cracks: the same for bodies without their cracks, which are cut at time 0.");
  s.refuse({when::isNot("Time", "Initial State", {"Unloaded"}), when::equilibrium()},
           "only a dynamic run has an initial state; leave Initial State out");
  addUnstableGrowth(s);
  addStepsOfEquilibrium(s);
  s.real("CFL").above(0.0).atMost(1.0).byDefault(0.4).mayChange().meaning(
      "Courant number: fraction of a cell that a wave crosses in one time step. Undamped bodies gain energy "
      "in proportion to it: with MUSL at 0.4 up to 1.5 % while a wave crosses 1000 cells.");
  s.integer("Maximum Steps")
      .atLeast(1)
      .mayChange()
      .byDefault(2000000000)
      .meaning("Largest number of time steps. The run ends when it is reached.");
  s.integer("Retries").atLeast(0).mayChange().byDefault(3).meaning(
      "Number of retries after an instability. Each retry returns to the last state in memory whose energy "
      "balance closed, and continues with half the time step. Needs Output > Checkpoints.");
  s.choice("Update Scheme", {"MUSL", "USF", "USL", "USAVG"})
      .byDefault("MUSL")
      .meaning("When stresses are updated within a step. MUSL: at the end, with particle velocities mapped "
               "to the grid again. USF: at the start. USL: at the end; for comparison only. USAVG: half at "
               "the start and half at the end; a step costs more, but the energy of undamped bodies is kept "
               "over many more steps.");
  s.real("PIC Fraction")
      .range(0.0, 1.0)
      .byDefault(0.0)
      .meaning(
          "Fraction of PIC in the velocity update of particles, the rest being FLIP. PIC damps the motion.");
  return s;
}

Section rigid()
{
  Section s("Rigid", "No stress: for scenes with heat only (Thermal > Mechanics = false).");
  describeDensity(s);
  return s;
}

/// Parameters of every material for Thermal.
void heat(Section& s)
{
  s.real("Specific Heat")
      .orTable()
      .unit("J/(kg K)")
      .positive()
      .optional()
      .meaning("Specific heat at constant strain. Required with the section Thermal.");
  s.real("Conductivity")
      .orTable()
      .unit("W/(m K)")
      .notNegative()
      .optional("0: no conduction")
      .meaning("Thermal conductivity.");
  s.realArray("Conductivity Ratios")
      .perAxis()
      .optional("all 1")
      .meaning("Factors on Conductivity along the axes of the body. They rotate with the material.");
  s.real("Thermal Expansion")
      .orTable()
      .unit("1/K")
      .above(-0.1)
      .below(0.1)
      .optional("0")
      .meaning("Coefficient of linear thermal expansion.");
  s.real("Reference Temperature")
      .unit("K")
      .positive()
      .optional("Thermal > Initial Temperature")
      .meaning("Temperature at which the thermal strain is zero.");
}

/// One variant for each law of the list.
template <class... Law>
void addLaws(Section& material, LawList<Law...> /*list*/)
{
  const auto add = [&](auto law)
  {
    Section s(decltype(law)::name, decltype(law)::meaning);
    decltype(law)::describe(s);
    material.variant(s);
  };
  (add(Law{}), ...);
}

/// Where laws that depend on time have no meaning or are not right.
void addRulesOfTime(Section& s)
{
  const Condition shocks = when::is("Materials > *", "Equation Of State", {"Mie-Grueneisen"});
  s.refuse({shocks, when::equilibrium()},
           "its artificial viscosity is for motion; write Equation Of State = Elastic, or Time > Analysis = "
           "Dynamic");
  s.refuse(
      {shocks, when::present("Thermal")},
      "it has an internal energy of its own, which heat would not reach; write Equation Of State = Elastic, "
      "or remove the section Thermal");
  s.refuse({shocks, when::present("Adaptivity")},
           "its artificial viscosity is that of cells of one size; remove one of the two");
  s.refuse({when::given("Materials > *", "Bulk Fractions"), when::present("Thermal")},
           "thermal strain does not reach relaxing bulk moduli; leave Bulk Fractions out, or remove Thermal");
  s.refuse(
      {when::is("Materials > *", "Model", {"Viscoelastic", "High-Rate Solid", "ViscoSCRAM"}),
       when::isNot("Time", "Initial State", {"Unloaded"})},
      "the equilibrium at the start has no time in which it could relax or flow; write Time > Initial State "
      "= Unloaded");
  const Condition shared = when::is("Materials > *", "Model", {SharedLibrary::name});
  s.refuse(
      {shared, when::present("Thermal")},
      "a law of a shared library has one temperature; choose another Model, or remove the section Thermal");
  s.refuse({shared, when::isNot("Time", "Initial State", {"Unloaded"})},
           "the equilibrium at the start has no time, but the law of a shared library is one of steps; write "
           "Time > Initial State = Unloaded");
}

void addRulesOfOrthotropicBodies(Section& s)
{
  const Condition orthotropic = when::is("Materials > *", "Model", {Orthotropic::name});
  s.refuse(
      {orthotropic, when::present("Thermal")},
      "the law Orthotropic has no thermal expansion, which differs from axis to axis; use Linear Elastic, "
      "or remove the section Thermal");
  s.refuse({orthotropic, when::isNot("Propagation", "Direction", {"Straight"})},
           "the rules for turning cracks are those of isotropic bodies; write Propagation > Direction = "
           "Straight, for a crack that keeps its direction, such as along fibres");
}

/// A fluid has no stiffness in shear, and no length but that of its cells.
void addRulesOfFluids(Section& s)
{
  const Condition fluid = when::is("Materials > *", "Model", {Fluid::name});
  s.refuse(
      {fluid, when::equilibrium()},
      "a fluid has no strength in shear, so that its equilibrium has no stiffness to solve for; write Time > "
      "Analysis = Dynamic");
  s.refuse(
      {fluid, when::isNot("Time", "Initial State", {"Unloaded"})},
      "a fluid has no strength in shear, so that its equilibrium has no stiffness to solve for; write Time > "
      "Initial State = Unloaded");
  s.refuse(
      {fluid, when::present("Thermal")},
      "a fluid is adiabatic and has an internal energy of its own, which heat would not reach; remove the "
      "section Thermal");
  s.refuse({fluid, when::present("Cracks")},
           "cracks and fluids are not available in one scene; remove the section Cracks, or the fluid");
  s.refuse({fluid, when::present("Adaptivity")},
           "its viscosities are those of cells of one size; remove one of the two");
  s.refuse({fluid, when::is("Domain", "Plane", {"Stress"})},
           "a fluid is no plate in plane stress; write Domain > Plane = Strain", 0, 2);
}

/// A static analysis has no time: what relaxes or flows would depend on the length of the run.
void addRulesOfStatic(Section& s)
{
  const Condition isStatic = when::is("Time", "Analysis", {"Static"});
  s.refuse(
      {when::is("Materials > *", "Model", {"Viscoelastic", "ViscoSCRAM"}), isStatic},
      "a static analysis has no time in which it could relax; write Time > Analysis = Quasi-Static, with "
      "loads as functions of time");
  s.refuse({when::above("Materials > *", "Johnson-Cook C", 0.0), isStatic},
           "a static analysis has no rate of flow; write Time > Analysis = Quasi-Static, or leave it out");
}

Section materials()
{
  Section material("material", "A material.");
  material.chosenBy("Model").meaning("Constitutive law.");
  material.fromLibrary("Material From Library")
      .meaning("Name of a material of the library, such as PMMA, whose constants stand for the parameters "
               "that are not given here (docs/reference/materials.md). rhegma --materials lists them. Heat "
               "constants "
               "are used with the section Thermal.");
  heat(material);
  addLaws(material, Laws{});
  material.variant(rigid());

  Section s("Materials", "The materials of the bodies.");
  s.require();
  s.namedByUser(material);
  addRulesOfTime(s);
  addRulesOfStatic(s);
  addRulesOfOrthotropicBodies(s);
  addRulesOfFluids(s);
  return s;
}

Section boundaries(const std::vector<Section>& types)
{
  Section boundary("boundary", "A load or a support.");
  boundary.chosenBy("Type").meaning("Kind of load or support.");
  for (const Section& type : types)
    boundary.variant(type);

  Section s("Boundaries", "Loads and supports.");
  s.namedByUser(boundary);
  return s;
}

/// Whether no material of the section has one of some laws.
bool haveNone(const Teuchos::ParameterList& materials, const std::vector<std::string>& laws)
{
  for (const auto& entry : materials)
    if (const auto* material = valueIf<Teuchos::ParameterList>(entry.second))
      if (const auto* model = valueIf<std::string>(*material, "Model"))
        if (std::find(laws.begin(), laws.end(), *model) != laws.end())
          return false;
  return true;
}

bool haveNoDamage(const Teuchos::ParameterList& materials) { return haveNone(materials, lawsWithDamage()); }

bool haveNoSharedLaw(const Teuchos::ParameterList& materials)
{
  return haveNone(materials, {SharedLibrary::name});
}

Section output()
{
  Section s("Output", "Which results are written, and how often.");
  s.fill().mayChange();
  s.real("History Interval")
      .unit("s")
      .positive()
      .optional("1/200 of Final Time")
      .meaning("Time between two rows of history.csv.");
  s.real("Field Interval")
      .unit("s")
      .positive()
      .optional("fields at the end only")
      .meaning("Time between two outputs of the fields (fields.h5, fields.xdmf).");
  s.boolean("Fields").byDefault(true).meaning("Whether fields.h5 and fields.xdmf are written.");
  s.boolean("Principal Stress")
      .byDefault(false)
      .meaning(
          "Whether the fields have the largest principal Cauchy stress of each particle, principal_stress, "
          "in 2D including that across the plane [Pa].");
  s.boolean("Energy Density")
      .byDefault(false)
      .meaning("Whether the fields have the elastic energy of each particle per undeformed volume, "
               "energy_density [J/m3].");
  s.boolean("Damage").byDefault(false).meaning(
      "Whether the fields have the damage of each particle, damage: from 0 of a whole to 1 of a "
      "broken material, 0 where the law has none. Needs a law that has one.");
  s.refuse({when::is("Output", "Damage", {"true"}),
            when::satisfies("Materials", "without a law that has a damage", haveNoDamage)},
           "no material has a damage; write Materials > NAME > Model = " + asText(lawsWithDamage()) +
               ", or Damage = false");
  s.boolean("State Variables")
      .byDefault(false)
      .meaning("Whether the fields have the state variables of each particle with a law of a shared library, "
               "state_1, state_2 and so on.");
  s.refuse({when::is("Output", "State Variables", {"true"}),
            when::satisfies("Materials", "without a law of a shared library", haveNoSharedLaw)},
           std::string("no material has state variables; write Materials > NAME > Model = ") +
               SharedLibrary::name + ", or State Variables = false");
  s.choice("Front Values", {"With Fields", "With History", "None"})
      .onlyIn(3)
      .byDefault("With Fields")
      .meaning(
          "When G, K and speed at all nodes of crack fronts are written to fronts.h5 and fronts.csv: at the "
          "times of the fields, at each row of history.csv, or never. Needs Energy Release.");
  s.boolean("Checkpoints")
      .byDefault(true)
      .meaning("Whether checkpoint.h5 is written for --restart: at the intervals below, and when a signal or "
               "a failure stops the run.");
  s.real("Checkpoint Interval")
      .unit("s")
      .positive()
      .optional("only by Checkpoint Minutes")
      .meaning("Physical time between two checkpoints. One more is written at the end of the run.");
  s.real("Checkpoint Minutes")
      .unit("min")
      .notNegative()
      .byDefault(15.0)
      .meaning("Wall-clock minutes after which a checkpoint is written if none was written since. 0 switches "
               "this off.");
  return s;
}

Section reference()
{
  Section entry("reference", "A value that a result is compared with at the end of the run.");
  entry.text("Quantity")
      .notEmpty()
      .meaning("Path of the result in summary.json, such as cracks.Notch.fronts.0.G_J or energy.kinetic. An "
               "entry of a list is given by its number, from 0, or its name.");
  entry.real("Value").meaning("Expected value, in the unit of the quantity.");
  entry.real("Tolerance").positive().meaning("Largest allowed relative error; absolute error if Value is 0.");
  entry.text("Source").notEmpty().meaning("Source of the value, such as a paper.");

  Section s("Reference", "Expected results. At the end the run is compared with them; exit status 4 means "
                         "that one is outside its tolerance.");
  s.mayChange();
  s.namedByUser(entry);
  return s;
}

} // namespace

std::vector<Section> coreSections(const std::vector<Section>& boundaryTypes)
{
  std::vector<Section> sections = {domain(), time(),     materials(), bodies(), boundaries(boundaryTypes),
                                   output(), reference()};
  addHeatRules(sections);
  return sections;
}

std::vector<Section> coreSections() { return coreSections({}); }

} // namespace Rhegma
