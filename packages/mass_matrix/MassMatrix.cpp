#include "mass_matrix/MassMatrix.hpp"

#include "archive/Archive.hpp"
#include "base/MemoryNeed.hpp"
#include "mass_matrix/AngularMomentum.hpp"
#include "mass_matrix/MassRows.hpp"
#include "mass_matrix/MatrixMemory.hpp"
#include "mass_matrix/NodalSolve.hpp"
#include "mass_matrix/Series.hpp"
#include "mass_matrix/SlotSolve.hpp"
#include "scene/RoundBodies.hpp"

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

namespace Rhegma::mass_matrix
{

namespace
{

/// The update of the particle velocity from the nodes.
enum class VelocityUpdate
{
  Flip, ///< the acceleration
  Pic,  ///< the velocity itself
  Xpic, ///< the velocity with the momentum filtered by a series, and the acceleration
  Fmpm  ///< the velocity of a series of momentum and impulse
};

struct Options
{
  std::string type;
  int order = 2;       ///< of the series of the type FMPM
  int updateOrder = 2; ///< of the series of the velocity update
  VelocityUpdate update = VelocityUpdate::Flip;
  Unlumping unlumping;
  double radius = 0.0, edge = -1.0; ///< of Partial; 0 and below 0: from the cells
  double tolerance = 1e-7;
  int iterations = 200;

  bool coupled() const { return type == "Full" || type == "Partial"; }
  bool series() const { return type == "FMPM"; }
  bool filtered() const { return update == VelocityUpdate::Xpic || update == VelocityUpdate::Fmpm; }
};

constexpr double radiusCells = 3.0, edgeCells = 1.0;

/// Largest CFL number of a coupled matrix. In substeps at 0.4 the impulses of coarser cells excite the
/// coupled nodes: a bar with a crack gained 8 % of energy in 6,000 steps of three levels, and none at 0.3.
constexpr double largestCoupledCfl = 0.4, largestInSubsteps = 0.3;

template <int D>
double coupledTimeStep(const State<D>& state)
{
  const double largest = state.mesh.subcycledLevels > 0 ? largestInSubsteps : largestCoupledCfl;
  return std::min(state.method.cfl, largest) * state.mesh.stepSpacing() / state.clock.fastestSpeed;
}

void addSolverParameters(Section& s)
{
  s.real("Lumped Fraction")
      .formerly("Lumped Share")
      .atLeast(0.0)
      .below(1.0)
      .byDefault(0.1)
      .meaning("Fraction eps of lumping in the matrix (1 - eps) M + eps lumped(M). With 0 the matrix can be "
               "singular, and the stable time step much smaller where a boundary cuts cells.");
  s.real("Minimum Node Mass")
      .formerly("Smallest Node")
      .range(0.0, 1.0)
      .byDefault(0.1)
      .meaning("The mass of a particle is lumped if one of its nodes has less than this fraction of the mass "
               "of a node inside the body.");
  s.real("Solver Tolerance")
      .above(0.0)
      .below(1.0)
      .byDefault(1e-7)
      .meaning("Conjugate gradients stop when the residual is below this fraction of the right-hand side "
               "without its uniform motion. The energy error of a run is at most about this value times the "
               "number of steps.");
  s.integer("Maximum Iterations")
      .atLeast(1)
      .byDefault(200)
      .meaning("Largest number of iterations of one solve; the run stops if it is not enough.");
}

Section section()
{
  Section s("Mass Matrix", "Mass matrix of the grid. Without this section it is lumped.");
  s.refuse(
      {when::is("Mass Matrix", "Type", {"Full", "Partial"}), when::axisymmetric()},
      "the least mass of coupled nodes is that of a thickness; write Type = Lumped or leave the section out");
  s.refuse({when::present("Mass Matrix"), when::equilibrium()},
           "an equilibrium analysis does not use mass; remove this section");
  s.chosenBy("Type").meaning("Kind of mass matrix, or a series for its inverse (FMPM).");
  s.choice("Velocity Update", {"FLIP", "PIC", "XPIC", "FMPM"})
      .byDefault("FLIP")
      .meaning("Velocity update of particles: from accelerations (FLIP), from velocities (PIC), from "
               "velocities with filtered momentum (XPIC), or from the series of momentum and impulse (FMPM). "
               "With Type = Full, PIC is the limit of FMPM.");
  s.integer("Update Order")
      .atLeast(1)
      .byDefault(2)
      .meaning("Number of terms of the series in XPIC and FMPM updates.");
  s.variant(Section("Lumped", "Diagonal matrix of row sums; no linear solve."));
  Section full("Full", "Consistent mass matrix, the sum of m N N^T over all particles, solved by conjugate "
                       "gradients. The CFL number is limited to 0.4.");
  addSolverParameters(full);
  s.variant(full);
  Section partial("Partial", "Consistent mass around crack fronts, lumped mass elsewhere.");
  partial.real("Radius").unit("m").positive().optional("3 cells").meaning(
      "The mass is consistent up to this distance from a front. The default is 3 times the cell size at the "
      "front.");
  partial.real("Transition Width")
      .formerly("Edge Width")
      .unit("m")
      .notNegative()
      .optional("1 cell")
      .meaning("Width beyond Radius over which the matrix changes from consistent to lumped.");
  addSolverParameters(partial);
  s.variant(partial);
  Section fmpm("FMPM", "Inverse of the consistent matrix as a series about the lumped one (FMPM).");
  fmpm.integer("Order").atLeast(1).byDefault(2).meaning(
      "Number of terms of the series; 1 is the lumped matrix.");
  s.variant(fmpm);
  s.refuse(
      {when::is("Mass Matrix", "Type", {"Partial"}), when::absent("Cracks")},
      "Partial uses consistent mass around crack fronts, and there are no cracks; add the section Cracks or "
      "choose another type");
  s.refuse({when::is("Mass Matrix", "Velocity Update", {"PIC", "XPIC", "FMPM"}),
            when::above("Time", "PIC Fraction", 0.0)},
           "it can't be combined with Time > PIC Fraction; remove one of them");
  s.refuse({when::is("Mass Matrix", "Velocity Update", {"XPIC", "FMPM"}),
            when::is("Mass Matrix", "Type", {"Full", "Partial"})},
           "it is a series about the lumped mass; write FLIP or PIC, or another Type");
  return s;
}

Options readOptions(const Teuchos::ParameterList& scene)
{
  const Teuchos::ParameterList& list = scene.sublist("Mass Matrix");
  Options o;
  o.type = list.get<std::string>("Type");
  const auto update = list.get<std::string>("Velocity Update");
  o.update = update == "PIC"    ? VelocityUpdate::Pic
             : update == "XPIC" ? VelocityUpdate::Xpic
             : update == "FMPM" ? VelocityUpdate::Fmpm
                                : VelocityUpdate::Flip;
  o.updateOrder = list.get<int>("Update Order");
  if (o.series())
    o.order = list.get<int>("Order");
  if (o.coupled())
  {
    o.unlumping.lumpedFraction = list.get<double>("Lumped Fraction");
    o.unlumping.smallestNode = list.get<double>("Minimum Node Mass");
    o.tolerance = list.get<double>("Solver Tolerance");
    o.iterations = list.get<int>("Maximum Iterations");
  }
  if (o.type == "Partial")
  {
    o.unlumping.everywhere = false;
    if (list.isParameter("Radius"))
      o.radius = list.get<double>("Radius");
    if (list.isParameter("Transition Width"))
      o.edge = list.get<double>("Transition Width");
  }
  return o;
}

/// Declares the nodal mass to effects that use the motion of nodes.
void declareMass(const Teuchos::ParameterList& list, RunOptions& options)
{
  const auto type = list.get<std::string>("Type");
  if (type == "Lumped")
    return;
  NodalMass& mass = options.nodalMass;
  mass.lumpedFraction = 0.0;
  if (type == "FMPM")
  {
    mass.terms = list.get<int>("Order");
    return;
  }
  mass.lumpedFraction = list.get<double>("Lumped Fraction");
  mass.smallestNode = list.get<double>("Minimum Node Mass");
  if (type != "Partial")
    return;
  const auto length = [&](const char* name, double& metres, double& cells, double usual)
  {
    metres = list.isParameter(name) ? list.get<double>(name) : 0.0;
    cells = list.isParameter(name) ? 0.0 : usual;
  };
  length("Radius", mass.radius, mass.radiusCells, radiusCells);
  length("Transition Width", mass.edge, mass.edgeCells, edgeCells);
}

/// The data of a run that its calls have in common.
template <int D>
struct MatrixRun
{
  explicit MatrixRun(const Options& o)
      : options(o),
        solve(o.tolerance, o.iterations, o.unlumping.lumpedFraction),
        slots(o.unlumping.lumpedFraction, o.tolerance),
        series(o.order),
        filter(o.updateOrder)
  {
  }

  Unlumping unlumping(const State<D>& state) const
  {
    Unlumping u = options.unlumping;
    u.radiusShrinks = !(options.radius > 0.0);
    u.edgeShrinks = !(options.edge >= 0.0);
    u.radius = u.radiusShrinks ? radiusCells * state.mesh.grid.spacing : options.radius;
    u.edge = u.edgeShrinks ? edgeCells * state.mesh.grid.spacing : options.edge;
    return u;
  }

  void prepare(State<D>& state)
  {
    assemble(state, unlumping(state), coupled);
    state.motion.coupledRow = coupled.rowOf;
    solve.begin(state, coupled);
  }

  void motion(State<D>& state)
  {
    if (options.coupled() && coupled.numCoupled > 0)
      solve.solveMotion(state, coupled);
    if (options.series())
      series.motion(state);
    if (options.filtered())
      filter.updateVelocity(state, options.update == VelocityUpdate::Fmpm);
  }

  void projection(State<D>& state)
  {
    if (options.coupled() && coupled.numCoupled > 0)
      solve.solveProjection(state, coupled);
    if (options.series())
      series.projection(state);
  }

  void report(const State<D>& state, nlohmann::json& summary) const
  {
    nlohmann::json& entry = summary["mass_matrix"];
    entry["type"] = options.type;
    if (options.series())
      entry["order"] = options.order;
    if (options.coupled())
    {
      const SolveCount& count = solve.count();
      entry["coupled_nodes"] = coupled.numCoupled;
      entry["solves"] = count.solves;
      entry["cg_iterations_mean"] =
          count.solves > 0 ? static_cast<double>(count.iterations) / static_cast<double>(count.solves) : 0.0;
      entry["cg_iterations_max"] = count.mostIterations;
      entry["worst_residual"] = count.worstResidual;
    }
    const Vector<3> now = angularMomentum(state);
    for (int d = D == 2 ? 2 : 0; d < 3; ++d)
    {
      entry["angular_momentum"]["start"].push_back(start[d]);
      entry["angular_momentum"]["end"].push_back(now[d]);
    }
  }

  Options options;
  MassSystem<D> coupled;
  NodalSolve<D> solve;
  SlotSolve<D> slots;
  Series<D> series, filter;
  Vector<3> start{{0.0, 0.0, 0.0}};
};

/// Offers solves for subcycled nodes.
template <int D>
void offerSlots(State<D>& state, const std::shared_ptr<MatrixRun<D>>& run)
{
  const auto none = [run] { return run->coupled.numCoupled == 0; };
  state.motion.coupledSlots.begin =
      [=](const State<D>& now, const NodeSlots& slots, const View<int* [D]>& held)
  {
    if (!none())
      run->slots.begin(now, run->coupled, slots, held);
  };
  state.motion.coupledSlots.solve =
      [=](const View<double* [D]>& right, const View<double* [D]>& x, bool supports)
  {
    if (!none())
      run->slots.solve(right, x, supports);
  };
}

std::string nameOf(const Options& o)
{
  if (o.series())
    return "FMPM(" + std::to_string(o.order) + ")";
  return o.type == "Full" ? "full mass matrix" : o.type == "Partial" ? "partial mass matrix" : "lumped mass";
}

template <int D>
void begin(State<D>& state, const std::shared_ptr<MatrixRun<D>>& run)
{
  run->start = angularMomentum(state);
  if (run->options.coupled())
  {
    const Unlumping unlumping = run->unlumping(state);
    refuseLargeMatrix(largestRows(state, unlumping),
                      bytesPerRow<D>(state.method.shape, !unlumping.everywhere || state.mesh.tree.refined(),
                                     state.mesh.tree.refined()),
                      freeMemoryBytes(),
                      unlumping.everywhere
                          ? "Lumped, FMPM or Partial, larger cells or a smaller body"
                          : "Lumped or FMPM, a smaller Mass Matrix > Radius or larger cells");
  }
  if (run->options.update != VelocityUpdate::Flip)
    state.method.picFraction = 1.0;
  if (run->options.coupled())
    offerSlots(state, run);
}

template <int D>
Effect<D> make(const Teuchos::ParameterList& scene)
{
  const auto run = std::make_shared<MatrixRun<D>>(readOptions(scene));
  const Options& options = run->options;
  Effect<D> effect;
  effect.name = "Mass Matrix";
  effect.atStart = [run](State<D>& state) { begin(state, run); };
  effect.report = [run](const State<D>& state, nlohmann::json& summary) { run->report(state, summary); };
  const auto addGuess = [&](const std::string& name, const char* unit) {
    effect.addsNodal.push_back({{name, D, unit, "where the next solve starts"}, OnRemesh::Drop, true});
  };
  if (options.coupled())
  {
    addGuess(velocityGuess, "m/s");
    addGuess(accelerationGuess, "m/s2");
  }
  if (options.coupled())
    effect.memory = [run](State<D>&, Archive& archive)
    {
      if (archive.sameOrder())
      {
        archive("rows", run->coupled.rowCapacity);
        archive("list_capacity", run->coupled.listCapacity);
        archive("hashed", run->coupled.hashed);
      }
      archive("coupled_nodes", run->coupled.numCoupled);
      run->solve.serialize(archive);
    };
  if (!options.coupled() && !options.series() && !options.filtered())
    return effect;
  // A coupled matrix is lighter in waves of two cells than its row sums: with a tenth of lumped mass blended
  // in, prototypes on cut grids were stable to CFL numbers of 0.44 and more, without it of far less.
  if (options.coupled())
    effect.timeStepLimit = coupledTimeStep<D>;
  if (options.coupled())
    effect.call(Stage::Scatter, "assemble the mass matrix", {quantity::nodalMass, quantity::enrichedFields},
                {quantity::massMatrix}, {}, [run](State<D>& s) { run->prepare(s); });
  effect.call(Stage::Solve, options.filtered() ? "filtered velocity" : "solve with the " + nameOf(options),
              {quantity::nodalMotion, ifWritten(quantity::massMatrix)}, {quantity::nodalMotion}, {},
              [run](State<D>& s) { run->motion(s); });
  if (options.coupled() || options.series())
    effect.call(
        Stage::AfterProjection, "project with the " + nameOf(options), {ifWritten(quantity::projection)},
        {quantity::projection}, {}, [run](State<D>& s) { run->projection(s); }, true);
  return effect;
}

} // namespace

EffectEntry massMatrixEntry()
{
  EffectEntry entry{section(), {}, make<2>, make<3>, true};
  entry.declare = declareMass;
  entry.cells.addNeeds = [](const auto&, CellNeeds& needs, auto&) { needs.equal = true; };
  return entry;
}

} // namespace Rhegma::mass_matrix
