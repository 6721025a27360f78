#pragma once
/// The state of a run, passed to every stage.

#include "material/ThermoTables.hpp"
#include "parallel/Ranks.hpp"
#include "state/Clock.hpp"
#include "state/CrackSet.hpp"
#include "state/EnergyBalance.hpp"
#include "state/FrontValues.hpp"
#include "state/Mesh.hpp"
#include "state/Method.hpp"
#include "state/NodalMotion.hpp"
#include "state/Particles.hpp"
#include "state/StoredStencils.hpp"
#include "state/ToolOutline.hpp"

#include <string>
#include <utility>
#include <vector>

namespace Rhegma
{

/// One body of the scene.
template <int D>
struct BodyInfo
{
  std::string name;  ///< as in the scene
  int material = 0;  ///< its number
  double axes[D][D]; ///< undeformed edge directions of its particles, one a row
  Vector<D> edge{};  ///< edges of a cell of its lattice, of which a whole particle fills one [m]
};

/// The bodies of the scene.
template <int D>
struct Bodies
{
  std::vector<BodyInfo<D>> info; ///< in the order of the scene
  View<double* [D][D]> axes;     ///< their axes, on the device
};

/// The materials of the scene.
struct MaterialSet
{
  std::vector<std::string> names;     ///< in the order of their numbers
  std::vector<Properties> properties; ///< on the host
  View<Properties*> device;           ///< the same on the device
  ThermoTables thermo;                ///< how temperature acts on them; empty without heat
};

/// A sampled quantity: a column of the history.
using HistoryRow = std::vector<std::pair<std::string, double>>;

/// The last sample.
template <int D>
struct Sample
{
  EnergyBalance energy;            ///< of all ranks
  Vector<D> momentum;              ///< of all particles [N s]
  HistoryRow row;                  ///< filled by the Observe stage
  std::vector<FrontValues> fronts; ///< of 3D, where an effect measures them
  long step = 0;                   ///< at whose end it was taken; 0: before the first step
};

/// The state of a run. What belongs to one effect alone is kept by that effect.
template <int D>
struct State
{
  Method method;          ///< schemes and their constants
  Ranks ranks;            ///< of the run
  Clock clock;            ///< time and step
  Mesh<D> mesh;           ///< cells and nodes
  Particles<D> particles; ///< of this rank
  Bodies<D> bodies;       ///< of the scene
  MaterialSet materials;  ///< of the scene

  CrackSet<D> cracks;       ///< empty unless an effect cuts the body
  StoredStencils<D> stored; ///< empty unless an effect cuts the body
  NodalMotion<D> motion;    ///< supports, displacement-dependent forces, coupled masses

  std::vector<ToolOutline<D>> tools; ///< rigid tools, in the order of the scene; empty without them

  EnergyBalance energy; ///< of all ranks when a sample is taken; entries added later are this rank's
  Sample<D> sample;     ///< the last one

  std::string failure;               ///< why the run can't go on; empty while it can
  std::vector<std::string> warnings; ///< for the summary
};

/// Positions of the nodes of a state, those of refined cells included.
template <int D>
NodePositions<D> nodePositions(const State<D>& state)
{
  return {state.mesh.grid, state.mesh.tree.finePosition};
}

/// Number of particles of all ranks.
template <int D>
int allParticles(const State<D>& state)
{
  return state.ranks.many() ? state.particles.ofAllRanks : state.particles.size();
}

/// Index of a body by name, or -1.
template <int D>
int findBody(const State<D>& state, const std::string& name)
{
  for (std::size_t b = 0; b < state.bodies.info.size(); ++b)
    if (state.bodies.info[b].name == name)
      return static_cast<int>(b);
  return -1;
}

} // namespace Rhegma
