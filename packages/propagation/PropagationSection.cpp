/// The parameters of growth, and what they do not go together with.

#include "propagation/Options.hpp"
#include "scene/FillFromIntensity.hpp"

namespace Rhegma::propagation
{

namespace
{

/// Least increment [cells], and that of motion.
constexpr double leastIncrement = 0.02, leastWhileRunning = 0.5;

/// What growth in equilibrium needs, and what has no meaning in it.
void addRulesOfEquilibrium(Section& s)
{
  const Condition self = when::present("Propagation");
  s.refuse(
      {self, when::isNot("Time", "Analysis", {"Dynamic", "Quasi-Static"})},
      "cracks grow in dynamic and quasi-static analyses only; write Time > Analysis = Quasi-Static, or, to "
      "compare G with a toughness only, Energy Release > Toughness instead of this section");
  s.refuse(
      {when::below("Propagation", "Increment", leastWhileRunning), when::is("Time", "Analysis", {"Dynamic"})},
      "increments below half a cell are for equilibrium only; write at least 0.5");
  s.refuse({when::is("Propagation", "Load Control", {"Functions of Time"}),
            when::is("Time", "Analysis", {"Dynamic"})},
           "it is for quasi-static analyses only; write Time > Analysis = Quasi-Static or leave it out");
  const Condition atRest = when::isNot("Time", "Unstable Growth", {"Dynamic"});
  s.refuse({when::given("Propagation", "Speed Limit"), when::equilibrium(), atRest},
           "in equilibrium fronts have no speed; leave it out");
  s.refuse({when::given("Propagation", "Sampling Interval"), when::equilibrium(), atRest},
           "in equilibrium G is evaluated once in each solution; leave it out");
  s.refuse({when::given("Propagation", "Arrest Toughness"), when::equilibrium(), atRest},
           "in equilibrium fronts do not run, so they are not arrested; leave it out");
  const Condition factor = when::is("Propagation", "Load Control", {"Load Factor"});
  s.refuse(
      {factor, when::is("Time", "Unstable Growth", {"Dynamic"})},
      "with Load Control = Load Factor loads are no functions of time, in which motion could go on; write "
      "Functions of Time");
  s.refuse(
      {when::below("Propagation", "Increment", leastWhileRunning),
       when::is("Time", "Unstable Growth", {"Dynamic"})},
      "increments below half a cell are for equilibrium only, and motion follows; write at least 0.5, or "
      "leave it out");
  s.refuse({factor, when::present("Thermal"), when::equilibrium()},
           "temperatures do not scale with the load factor; write Functions of Time");
  const char* const byTrial =
      "the load factor is found by trials, each of which would leave plastic or relaxed "
      "strain; write Functions of Time";
  s.refuse({factor, when::is("Materials > *", "Model", {"J2 Plastic", "Viscoelastic", "ViscoSCRAM"}),
            when::equilibrium()},
           byTrial);
  s.refuse({factor, when::given("Materials > *", "Johnson-Cook A"), when::equilibrium()}, byTrial);
  s.refuse({self, when::above("Adaptivity", "Front Cells", 0.0), when::equilibrium()},
           "in equilibrium cells are refined at the start only, and a front would leave the fine cells; "
           "refine its path with a box, and write Adaptivity > Front Cells = 0");
  s.refuse({when::above("Propagation", "Start Time", 0.0), factor, when::equilibrium()},
           "with Load Control = Load Factor there is no physical time; leave it out");
  s.keep(
      {"Time",
       "Final Time",
       {factor, when::equilibrium()},
       "with Propagation > Load Control = Load Factor the factor multiplies the loads and displacements of "
       "Time > Final Time, which must stay that of the checkpoint; write that one, or start anew with "
       "more Time > Load Steps for a longer path"});
}

/// What growing cracks need, and what excludes them.
void addRules(Section& s)
{
  const Condition self = when::present("Propagation");
  s.needs("Cracks", "there are no cracks; add the section Cracks or remove this section");
  s.needs("Energy Release", "it needs the section Energy Release, which may be empty; add it");
  s.refuse({self, when::isNot("Cracks", "Formulation", {"Dual Field"})},
           "it needs Cracks > Formulation = Dual Field; write that or remove this section");
  s.refuse({self, when::is("Cracks", "Front Springs", {"false"})},
           "it needs Cracks > Front Springs = true; write that");
  s.refuse({self, when::is("Mass Matrix", "Type", {"FMPM"})},
           "it can't be combined with Mass Matrix > Type = FMPM, with which cracks run too fast; write "
           "Partial or Full");
  s.refuse({self, when::isNot("Mass Matrix", "Type", {"Partial"})},
           "in 3D it can only be combined with Mass Matrix > Type = Partial; write that or remove one of the "
           "two sections",
           0, 3);
  // Cells that follow a front position the points of its faces anew, and faces that open gain contact energy.
  s.refuse({self, when::present("Contact"), when::present("Adaptivity")},
           "in 3D it can't be combined with both Contact and Adaptivity; remove one of the two", 0, 3);
  addRulesOfEquilibrium(s);
  Condition temperature = when::given("Propagation", "Toughness");
  temperature.text = " of the temperature T";
  temperature.holds = [](const Teuchos::ParameterList& list)
  {
    return list.isType<std::string>("Toughness") &&
           Toughness::namesTemperature(list.get<std::string>("Toughness"));
  };
  s.refuse({temperature, when::unprovided(capability::heat)},
           "it depends on the temperature T, but the scene has no section Thermal; add the section or write "
           "the toughness without T");
}

void addToughness(Section& s)
{
  s.text("Toughness")
      .unit("J/m2")
      .notEmpty()
      .meaning("Fracture energy per area Gc as a function of the front speed v [m/s], that of a single "
               "increment: a number, an "
               "expression such as \"100*(1 + v/500)\", or a table of speed:energy such as \"0:100, "
               "500:200\". With Thermal the expression may contain the temperature T [K].");
  describeToughnessByOtherMeans(s);
  s.real("Initiation Toughness")
      .unit("J/m2")
      .positive()
      .optional("Toughness at v = 0")
      .meaning("Energy release rate at which a stationary front starts to advance.");
  s.real("Arrest Toughness")
      .unit("J/m2")
      .positive()
      .optional("Toughness at v = 0")
      .meaning("Energy release rate below which a slow front is arrested. It starts again at Initiation "
               "Toughness.");
}

void addToughnessRatio(Section& s)
{
  s.text("Toughness Ratio")
      .onlyIn(2)
      .notEmpty()
      .optional("1")
      .meaning(
          "Toughness in a direction over Toughness, for a toughness that depends on the direction of growth: "
          "an expression of its angle a [rad] from the x axis, from -pi to pi, such as \"1 + 0.5*sin(a - "
          "30*pi/180)^2\". "
          "Cracks grow where G of a short kink over the toughness in its direction is largest.");
  Condition other = when::given("Propagation", "Toughness Ratio");
  other.text = " with a Direction other than Maximum Energy Release";
  other.holds = [](const Teuchos::ParameterList& list)
  {
    return list.isParameter("Toughness Ratio") &&
           !(list.isType<std::string>("Direction") &&
             list.get<std::string>("Direction") == "Maximum Energy Release");
  };
  s.refuse({other},
           "the direction is that of the largest G of a short kink over its toughness; write Direction = "
           "Maximum Energy Release");
}

void addLoadControlAndStart(Section& s)
{
  s.choice("Load Control", {"Load Factor", "Functions of Time"})
      .byDefault("Load Factor")
      .meaning("For Quasi-Static analyses. Load Factor: in each load step the crack grows by one increment, "
               "and all loads and prescribed displacements of Final Time are multiplied by the factor at "
               "which G equals the toughness. The factor may fall. Functions of Time: the loads follow their "
               "functions of time, and in each load step cracks grow until G is below the toughness. With "
               "Load Factor, Final Time must not change on restart.");
  s.real("Start Time")
      .unit("s")
      .notNegative()
      .byDefault(0.0)
      .meaning("No front advances before this time. In equilibrium cracks grow at the end of a load step.");
}

void addSampling(Section& s)
{
  s.real("Sampling Interval")
      .range(0.0, 4.0)
      .optional("0.5")
      .meaning("Cells at the front that a Rayleigh wave travels between two evaluations of G of a "
               "front, in a dynamic analysis. A front whose G would reach the toughness by extrapolation is "
               "evaluated in each step. 0: every step.");
}

} // namespace

Section propagationSection()
{
  Section s("Propagation",
            "Crack propagation: fronts advance when the energy release rate reaches the toughness.");
  addToughness(s);
  addToughnessRatio(s);
  s.choice("Direction", {"Maximum Hoop Stress", "Maximum Energy Release", "Straight"})
      .byDefault("Maximum Hoop Stress")
      .meaning("Direction of growth: of maximum hoop stress, of maximum energy release rate of a short kink, "
               "or straight ahead.");
  s.real("Increment")
      .range(leastIncrement, 4.0)
      .optional("1, in equilibrium 0.25")
      .meaning("Length of one crack increment, in cells at the front. At least 0.5 in a dynamic analysis.");
  addLoadControlAndStart(s);
  s.real("Speed Limit")
      .unit("m/s")
      .positive()
      .optional("Rayleigh wave speed")
      .meaning("Upper limit of the front speed.");
  addSampling(s);
  s.choice("On Stop", {"Stop", "Continue"})
      .byDefault("Stop")
      .mayChange()
      .meaning("What happens after a numerical stop: a front, or a node of a 3D front, with G at its "
               "toughness can't advance, because other crack faces are too close for the cells or because "
               "its J integral can't be computed. Stop: the run ends with exit status 2. Continue: the run "
               "goes on; this front or node stays where it is, and the front gets the status \"stopped\".");
  s.realArray("Release Contour")
      .onlyIn(2)
      .length(2)
      .byDefault(std::vector<double>{5.0, 10.0})
      .meaning("Inner and outer radius of the domain integral for the energy release rate, in cells at the "
               "front. Below 5 cells it overlaps the cohesive zone.");
  s.realArray("Direction Contour")
      .onlyIn(2)
      .length(2)
      .byDefault(std::vector<double>{3.0, 6.0})
      .meaning("Inner and outer radius of the domain integral for the stress intensity factors that "
               "determine the direction, in cells at the front.");
  addRules(s);
  return s;
}

} // namespace Rhegma::propagation
