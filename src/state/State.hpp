#pragma once
/// Everything that a run holds, handed to every stage.

#include "base/FieldTable.hpp"
#include "grid/Blocks.hpp"
#include "grid/Grid.hpp"
#include "grid/Nodes.hpp"
#include "grid/ShapeFunctions.hpp"
#include "grid/StencilTable.hpp"
#include "grid/Tree.hpp"
#include "material/ThermoTables.hpp"
#include "parallel/Ranks.hpp"
#include "state/CrackSet.hpp"
#include "state/EnergyBalance.hpp"
#include "state/NodeConstraint.hpp"

#include <functional>
#include <limits>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

namespace Rhegma
{

template <int D>
struct State;
template <int D>
struct Subdomain;

enum class UpdateScheme
{
  Musl, ///< last, from velocities projected anew
  Usf,  ///< first
  Usl,  ///< last
  Usavg ///< half first, half last from velocities projected anew
};

/// Whether a step ends with velocities projected anew, which strain and move the particles.
constexpr bool projectsLast(UpdateScheme scheme)
{
  return scheme == UpdateScheme::Musl || scheme == UpdateScheme::Usavg;
}

/// One of the passes in which a step strains its particles: USAVG has two, other schemes one.
struct StrainPass
{
  double share = 1.0;  ///< of the step, that the pass strains over
  bool before = false; ///< the forces of the step
};

/// Points that need stencils: where they are, the half widths of their boxes (zero for points), and the side
/// of a crack from which each looks (CrackSet; 0 away from cracks).
template <int D>
struct ObservedPoints
{
  View<double* [D]> position; ///< [m]
  View<double* [D]> half;     ///< [m]
  View<int*> side;            ///< of a crack
  int count = 0;              ///< how many there are; views may be longer
  /// All ranks list the same points: each has a stencil on the rank that owns its place, and none elsewhere.
  bool onAllRanks = false;
};

/// What cuts the body: decides which particles need stored stencils and edits stencils so that they end at
/// the cut. The core knows no more of cracks than this.
template <int D>
struct StencilEditor
{
  /// Called once a step before any transfer: marks particles (row = 0 where a stored stencil is needed, -1
  /// elsewhere) and sets up second fields of nodes.
  std::function<void(State<D>&, const View<int*>& row)> prepare;
  /// Edits unbroken stencils of points in rows 0 .. points.count - 1.
  std::function<void(const State<D>&, const ObservedPoints<D>& points, const StencilTable<D>& table)> edit;
};

/// Places that short steps within a step give to nodes: `of` each node's row, -1 where a node has none; those
/// of nodes that move in short steps are the first `inner`.
struct NodeSlots
{
  View<int*> of; ///< of each node, or -1
  int inner = 0; ///< how many move in short steps
  KOKKOS_INLINE_FUNCTION bool moves(int node) const { return inner > 0 && of(node) >= 0 && of(node) < inner; }
};

/// What short steps within the step did, for those who reckon work; without effect where there are none.
struct ShortSteps
{
  NodeSlots nodes;     ///< that move in them or beside them
  double length = 0.0; ///< of the shortest ones [s]
  /// Impulses on nodes that move in short steps but for those at the start of the step, times the velocity
  /// that the nodes had before it [J]. Nodes that supports hold don't count.
  double lateWork = 0.0;
};

/// A nodal force that changes where nodes move within a step (contact, ties), for those who move them in
/// short steps. Such forces are also among all others before the solve, as at the start of the step. `force`
/// and `displacement` have a row a slot [N, m].
template <int D>
struct FollowingForce
{
  using Values = View<double* [D]>; ///< a row a slot
  /// Adds the part, as at the start of the step, that does not follow: it acts on a node that does not move
  /// in short steps.
  std::function<void(const State<D>&, const NodeSlots&, const Values& force)> frozen;
  /// Adds the change of the part that follows.
  std::function<void(const State<D>&, const NodeSlots&, const Values& displacement, const Values& force)>
      change;
};

/// The mass of nodes that move in short steps where it couples them, for those who move them. Values have a
/// row a slot [N, m].
template <int D>
struct CoupledSlots
{
  using Values = View<double* [D]>; ///< a row a slot
  /// Once a long step, when nodes have their masses. \param held not 0 where a support holds a slot along an
  /// axis
  std::function<void(const State<D>&, const NodeSlots&, const View<int* [D]>& held)> begin;
  /// Solves M x = right for coupled nodes that move in short steps. \param x on entry given on all other
  /// slots and, where `supports` is set, where these hold
  std::function<void(const Values& right, const Values& x, bool supports)> solve;
};

/// Particles that were just split: whole(i) is now one part, of which the others are in the rows from
/// first + i (2^D - 1) on.
struct SplitParts
{
  View<int*> whole; ///< rows of the first parts
  int first = 0;    ///< row of the others
};

/// One body of the scene as particles made it.
template <int D>
struct BodyInfo
{
  std::string name;  ///< as in the scene
  int material = 0;  ///< its number
  double axes[D][D]; ///< undeformed edge directions of its particles, one a row
};

/// A sampled quantity: a column of the history.
using HistoryRow = std::vector<std::pair<std::string, double>>;

/// The state of a run.
template <int D>
struct State
{
  Plane plane = Plane::Solid;               ///< how 2D treats the third direction
  double thickness = 1.0;                   ///< of 2D scenes [m]
  ShapeKind shape = ShapeKind::Gimp;        ///< shape functions
  UpdateScheme scheme = UpdateScheme::Musl; ///< when stress follows
  StrainPass strainPass;                    ///< that is under way, or the next
  double picFraction = 0.0;                 ///< share of PIC in the velocity update
  double cfl = 0.4;                         ///< share of the stable step that is used
  bool mechanics = true; ///< false: nothing moves, and there is neither velocity nor stress

  Ranks ranks;                                   ///< that share the run
  std::shared_ptr<const Subdomain<D>> subdomain; ///< this rank's; none where there is one rank
  Grid<D> grid;         ///< what this rank's particles can reach; the whole lattice where there is one rank
  Tree<D> tree;         ///< refined cells; empty where none is
  Nodes<D> nodes;       ///< mass, momentum and force
  Blocks<D> blocks;     ///< particles by blocks of cells
  FieldTable particles; ///< of this rank
  int particlesOfAllRanks = 0;            ///< where there are many
  std::vector<BodyInfo<D>> bodies;        ///< in the order of the scene
  View<double* [D][D]> bodyAxes;          ///< axes of the bodies, on the device
  std::vector<std::string> materialNames; ///< in the order of their numbers
  std::vector<Properties> materialList;   ///< on the host
  View<Properties*> materials;            ///< the same on the device
  ThermoTables thermo; ///< how temperature acts on the materials; empty where nobody carries heat

  CrackSet<D> cracks;             ///< empty unless an effect cuts the body
  StencilEditor<D> editor;        ///< empty unless an effect cuts the body
  View<int*> storedRow;           ///< row of each particle in `stored`, or -1; empty without an editor
  View<int*> storedParticle;      ///< particle of each row
  ObservedPoints<D> storedPoints; ///< the particles of the rows as points
  StencilTable<D> stored;         ///< stencils of flagged particles
  int numStored = 0;              ///< how many have one

  std::vector<NodeConstraint<D>> constraints; ///< prescribed motion at the end of this step
  View<double*> coupledReaction; ///< impulse that holds each unknown (row, axis) of coupled nodes [N s]
  View<int*> coupledRow;         ///< of each node, -1 where its mass is lumped; empty where all masses are

  std::vector<FollowingForce<D>> followingForces; ///< of effects that have any
  CoupledSlots<D> coupledSlots;                   ///< empty where all masses are lumped
  /// Called when particles were split, their parts being copies but for place and size.
  std::vector<std::function<void(State<D>&, const SplitParts&)>> afterSplit;

  ShortSteps shortSteps; ///< of this step

  double time = 0.0;                                    ///< at the start of the step [s]
  double dt = 0.0;                                      ///< length of the step [s]
  long step = 0;                                        ///< steps taken
  long maximumSteps = std::numeric_limits<long>::max(); ///< the run ends after them, if not before
  double fastest = 0.0;                                 ///< largest wave speed plus particle speed [m/s]
  bool observing = false;                               ///< a sample is taken at the end of this step
  bool sorted = false;                                  ///< false: sort before the next step
  View<int*>
      indexOf; ///< index of the particle with each id, -1 where another rank has it; renewed by every sort
  double particleSteps = 0.0; ///< particles times steps, summed

  EnergyBalance energy;         ///< of all ranks when a sample is taken; what is booked later is this rank's
  EnergyBalance sampledEnergy;  ///< the same as it was at the last sample
  Vector<D> momentum;           ///< of all particles at the last sample [N s]
  HistoryRow row;               ///< filled by the Observe stage
  bool settled = false;         ///< at rest
  bool stopWhenSettled = false; ///< the scene has the run end there
  /// Edge of the smallest cells [m].
  double smallestSpacing() const { return std::ldexp(grid.spacing, -tree.deepest); }
  int subcycledLevels = 0; ///< how many of the deepest levels take short steps of their own
  /// Edge of the smallest cells that take the whole step [m].
  double stepSpacing() const
  {
    const int own = tree.deepest < subcycledLevels ? tree.deepest : subcycledLevels;
    return std::ldexp(grid.spacing, own - tree.deepest);
  }
  /// Whether the scene has the run end here, before its final time.
  bool ended() const { return (settled && stopWhenSettled) || step >= maximumSteps; }
  std::string trouble;               ///< why the run can't go on; empty while it can
  std::vector<std::string> warnings; ///< sentences for the summary
};

/// Where the nodes of a state are, those of refined cells included.
template <int D>
NodePlaces<D> nodePlaces(const State<D>& state)
{
  return {state.grid, state.tree.finePlace};
}

/// Number of particles, of all ranks.
template <int D>
int allParticles(const State<D>& state)
{
  return state.ranks.many() ? state.particlesOfAllRanks : state.particles.size();
}

/// Index of a body by name, or -1.
template <int D>
int findBody(const State<D>& state, const std::string& name)
{
  for (std::size_t b = 0; b < state.bodies.size(); ++b)
    if (state.bodies[b].name == name)
      return static_cast<int>(b);
  return -1;
}

} // namespace Rhegma
