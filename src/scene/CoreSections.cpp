#include "scene/CoreBodies.hpp"
#include "scene/CoreBoundaries.hpp"
#include "scene/HeatWords.hpp"
#include "scene/Schema.hpp"

namespace Rhegma
{

namespace
{

Section domain()
{
  Section s("Domain", "The box of cells in which everything happens.");
  s.require();
  s.integer("Dimension").range(2, 3).meaning("2 for a plane, 3 for space.");
  s.choice("Plane", {"Strain", "Stress"})
      .onlyIn(2)
      .byDefault("Strain")
      .meaning("What is zero out of the plane: strain, or stress.");
  s.real("Thickness")
      .unit("m")
      .onlyIn(2)
      .positive()
      .byDefault(1.0)
      .meaning("Out of the plane; masses and loads are for it.");
  s.realArray("Lower Corner").unit("m").perAxis().meaning("The corner with the smallest coordinates.");
  s.realArray("Upper Corner").unit("m").perAxis().meaning("The corner with the largest coordinates.");
  s.real("Cell Size")
      .unit("m")
      .positive()
      .optional("what Accuracy chooses")
      .meaning("Edge of the square or cubic cells.");
  s.choice("Accuracy", {"10 %", "3 %", "1 %", "0.3 %"})
      .optional()
      .meaning(
          "Error of G, K or a rise of temperature that cells are chosen for: Cell Size where that is absent, "
          "and Adaptivity with Sub-Cycling at fronts where neither is in the scene "
          "(docs/accuracy-and-cost.md). What the scene gives itself stays.");
  s.choice("Shape Functions", {"Linear", "GIMP"})
      .byDefault("GIMP")
      .meaning("Linear: cheap, noisy when particles change cell. GIMP: every particle is a box of its own.");
  return s;
}

Section time()
{
  Section s("Time", "How long and how finely the run steps.");
  s.require();
  s.real("Final Time").unit("s").positive().mayChange().meaning("The run ends here.");
  s.real("CFL").above(0.0).atMost(1.0).byDefault(0.4).mayChange().meaning(
      "Share of a cell that a wave may cross in one step. Undamped bodies gain energy in "
      "proportion to it: at 0.4 up to 1.5 % while a wave crosses a thousand cells (Update Scheme, MUSL).");
  s.integer("Maximum Steps")
      .atLeast(1)
      .mayChange()
      .byDefault(2000000000)
      .meaning("The run ends after so many steps, if not before.");
  s.integer("Retries").atLeast(0).mayChange().byDefault(3).meaning(
      "How often a run that can't go on goes back to the last state in memory with a balanced ledger, "
      "and on from there with steps of half the length. With Output > Checkpoints.");
  s.choice("Update Scheme", {"MUSL", "USF", "USL", "USAVG"})
      .byDefault("MUSL")
      .meaning(
          "When stresses are updated. MUSL: last, with velocities mapped anew. USF: first. USL: last, for "
          "comparison only. USAVG: half first and half last, with velocities mapped anew; a step costs more, "
          "and keeps the energy of undamped bodies over far more steps.");
  s.real("PIC Fraction")
      .range(0.0, 1.0)
      .byDefault(0.0)
      .meaning("Share of the grid's velocity, against its change, that particles take over; it damps.");
  return s;
}

void elasticConstants(Section& s)
{
  s.real("Density").unit("kg/m3").positive().meaning("Of the undeformed material.");
  s.real("Young Modulus").orTable().unit("Pa").positive().meaning("Stiffness in tension at small strain.");
  s.real("Poisson Ratio")
      .orTable()
      .above(-1.0)
      .below(0.5)
      .meaning("Contraction over stretch at small strain.");
}

Section linearElastic()
{
  Section s("Linear Elastic", "Stress follows small strain; rotations may be large.");
  elasticConstants(s);
  return s;
}

void entropic(Section& s)
{
  s.boolean("Entropic")
      .byDefault(false)
      .meaning("With Thermal: the shear modulus goes with the absolute temperature, as that of ideal rubber, "
               "which "
               "warms when it is stretched.");
}

Section rigid()
{
  Section s("Rigid", "No stress at all: for scenes of heat alone (Thermal > Mechanics = false).");
  s.real("Density").unit("kg/m3").positive().meaning("Of the undeformed material.");
  return s;
}

/// What Thermal wants to know of every material.
void heat(Section& s)
{
  s.real("Specific Heat")
      .orTable()
      .unit("J/(kg K)")
      .positive()
      .optional()
      .meaning("Heat capacity at constant strain; Thermal needs it.");
  s.real("Conductivity")
      .orTable()
      .unit("W/(m K)")
      .notNegative()
      .optional("no heat flows")
      .meaning("How well it conducts heat.");
  s.realArray("Conductivity Ratios")
      .perAxis()
      .optional("all 1")
      .meaning("Factors of Conductivity along the axes of the body, which turn with it.");
  s.real("Thermal Expansion")
      .orTable()
      .unit("1/K")
      .above(-0.1)
      .below(0.1)
      .optional("none")
      .meaning("Linear expansion per kelvin.");
  s.real("Reference Temperature")
      .unit("K")
      .positive()
      .optional("Thermal > Initial Temperature")
      .meaning("Temperature of no thermal strain.");
}

Section neoHookean()
{
  Section s("Neo-Hookean", "Compressible rubber-like solid for large strain.");
  elasticConstants(s);
  entropic(s);
  return s;
}

Section mooneyRivlin()
{
  Section s("Mooney-Rivlin",
            "Rubber with two shear constants; nearly incompressible if the bulk modulus is large.");
  s.real("Density").unit("kg/m3").positive().meaning("Of the undeformed material.");
  s.real("C10").orTable().unit("Pa").notNegative().meaning(
      "Constant of the first invariant; C10 and C01 are not both zero.");
  s.real("C01").orTable().unit("Pa").notNegative().meaning("Constant of the second invariant.");
  s.real("Bulk Modulus").orTable().unit("Pa").positive().meaning("Stiffness against a change of volume.");
  entropic(s);
  return s;
}

Section j2Plastic()
{
  Section s("J2 Plastic", "Metal: elastic up to the yield stress of von Mises, then hardening plastic flow.");
  elasticConstants(s);
  s.real("Yield Stress")
      .orTable()
      .unit("Pa")
      .positive()
      .meaning("Stress in tension at which plastic flow begins.");
  s.real("Hardening Modulus")
      .orTable()
      .unit("Pa")
      .notNegative()
      .byDefault(0.0)
      .meaning("Rise of the yield stress per plastic strain.");
  s.real("Saturation Stress")
      .orTable()
      .unit("Pa")
      .positive()
      .optional()
      .meaning(
          "Yield stress that Voce hardening ends at; Hardening Modulus comes on top. At least Yield Stress.");
  s.real("Saturation Rate")
      .orTable()
      .positive()
      .optional()
      .meaning("How fast: the yield stress is Yield Stress + (Saturation Stress - Yield Stress) (1 - "
               "exp(-Saturation Rate x "
               "plastic strain)) + Hardening Modulus x plastic strain.");
  s.allOrNoneOf({"Saturation Stress", "Saturation Rate"});
  s.real("Plastic Heat Fraction")
      .range(0.0, 1.0)
      .byDefault(0.9)
      .meaning("With Thermal: share of the plastic work that becomes heat (Taylor and Quinney).");
  return s;
}

Section materials()
{
  Section material("material", "One material.");
  material.chosenBy("Model").meaning("The constitutive law.");
  heat(material);
  material.variant(linearElastic());
  material.variant(neoHookean());
  material.variant(mooneyRivlin());
  material.variant(j2Plastic());
  material.variant(rigid());

  Section s("Materials", "What the bodies are made of.");
  s.require();
  s.namedByUser(material);
  return s;
}

Section output()
{
  Section s("Output", "What the run writes, and how often.");
  s.fill().mayChange();
  s.real("History Interval")
      .unit("s")
      .positive()
      .optional("1/200 of Final Time")
      .meaning("Time between the rows of history.csv.");
  s.real("Field Interval")
      .unit("s")
      .positive()
      .optional("only the last fields")
      .meaning("Time between the fields of particles.");
  s.boolean("Fields").byDefault(true).meaning("Whether fields.h5 and fields.xdmf are written at all.");
  s.boolean("Checkpoints")
      .byDefault(true)
      .meaning(
          "Whether checkpoint.h5 is written, from which --restart goes on: at the intervals below, and where "
          "a signal or trouble stops the run.");
  s.real("Checkpoint Interval")
      .unit("s")
      .positive()
      .optional("by the clock alone")
      .meaning("Simulated time between checkpoints; the end of the run gets one too.");
  s.real("Checkpoint Minutes")
      .unit("min")
      .notNegative()
      .byDefault(15.0)
      .meaning(
          "Minutes by the clock after which a checkpoint is written, if none was; 0: none by the clock.");
  return s;
}

Section reference()
{
  Section entry("reference", "One value that the run is compared with at its end.");
  entry.text("Quantity")
      .notEmpty()
      .meaning("Path in summary.json, such as cracks.0.fronts.0.G_J or energy.kinetic.");
  entry.real("Value").meaning("What it should be, in the unit of the quantity.");
  entry.real("Tolerance")
      .positive()
      .meaning("Largest relative difference; where Value is 0, the largest absolute one.");
  entry.text("Source").notEmpty().meaning("Where the value comes from.");

  Section s("Reference", "Values with which the run is compared at its end, so that a scene tests itself.");
  s.mayChange();
  s.namedByUser(entry);
  return s;
}

} // namespace

std::vector<Section> coreSections()
{
  std::vector<Section> sections = {domain(),     time(),   materials(), bodies(),
                                   boundaries(), output(), reference()};
  addHeatRules(sections);
  return sections;
}

} // namespace Rhegma
