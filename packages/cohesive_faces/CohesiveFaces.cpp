#include "cohesive_faces/CohesiveFaces.hpp"

#include "archive/Archive.hpp"
#include "base/ReadList.hpp"
#include "cohesive_faces/CohesionInEquilibrium.hpp"
#include "cohesive_faces/CohesiveReport.hpp"
#include "cohesive_faces/CohesiveSection.hpp"
#include "cohesive_faces/LawsOfCracks.hpp"
#include "plan/LastStage.hpp"
#include "scene/SceneBodies.hpp"
#include "transfer/FacePush.hpp"

#include <memory>
#include <stdexcept>

namespace Rhegma::cohesive_faces
{

namespace
{

/// The state of the effect that lasts from step to step.
template <int D>
struct Account
{
  FaceCohesion<D> cohesion;
  std::shared_ptr<CohesionInEquilibrium<D>> equilibrium; ///< of `cohesion`, unless bodies move
  std::vector<TractionLaw> laws;                         ///< of each crack of the scene
  double recorded = 0.0;                                 ///< dissipated energy that is in the balance [J]
};

/// A crack with a front would go on holding there as solid material.
template <int D>
void refuseFronts(const State<D>& state, int crack)
{
  for (const CrackFront<D>& front : state.cracks.fronts)
    if (front.crack == crack && !front.ended)
      throw std::invalid_argument("Cohesive Faces > " + state.cracks.cracks[crack].name +
                                  ": the crack ends inside the body; let it go on to the surface, or write "
                                  "Fronts = None for it (2D)");
}

/// Faces without cohesion from the start.
template <int D>
struct FreeBox
{
  bool exists = false;
  Vector<D> lower{}, upper{}; ///< [m]

  bool contains(const Vector<D>& x) const
  {
    bool inside = exists;
    for (int d = 0; d < D; ++d)
      inside = inside && x[d] >= lower[d] && x[d] <= upper[d];
    return inside;
  }
};

template <int D>
void begin(State<D>& state, const Teuchos::ParameterList& list, const SceneBodies<D>& bodies, bool touching,
           const std::shared_ptr<Account<D>>& account)
{
  const std::vector<AtCrack> at = materialsAtCracks(state);
  std::vector<FreeBox<D>> free(state.cracks.cracks.size());
  account->laws.assign(state.cracks.cracks.size(), {});
  for (const std::string& name : sublistNames(list))
  {
    const int c = findCrack(state.cracks, name);
    refuseFronts(state, c);
    const Teuchos::ParameterList& one = list.sublist(name);
    account->laws[c] = readLaw(one, at[c].modulus, state.mesh.grid.spacing, state.method.equilibrium());
    account->laws[c].resistsOverlap = !touching;
    if (one.isParameter("Free Lower Corner"))
      free[c] = {true, readVector<D>(one, "Free Lower Corner"), readVector<D>(one, "Free Upper Corner")};
  }
  // A crack reaches beyond the surface by a part of a particle.
  const auto holdsAt =
      [free, shapes = std::make_shared<SceneBodies<D>>(bodies)](int crack, const Vector<D>& x)
  { return shapes->contain(x) && !free[crack].contains(x); };
  account->cohesion.setLaws(account->laws, holdsAt);
  if (account->equilibrium)
    state.motion.stepForces.push_back(account->equilibrium);
}

template <int D>
void judge(State<D>& state, const Teuchos::ParameterList& list, const Account<D>& account)
{
  if (account.laws.empty()) // a crack is wrong
    return;
  const std::vector<AtCrack> at = materialsAtCracks(state);
  for (const std::string& name : sublistNames(list))
  {
    const int c = findCrack(state.cracks, name);
    const ProcessZone zone = processZone(list.sublist(name), at[c].effective);
    for (const std::string& warning :
         {warningOfZone(name, zone, state.mesh.smallestSpacing()),
          warningOfOverlap(name, account.laws[c], at[c].modulus, state.mesh.grid.spacing,
                           !state.method.equilibrium())})
      if (!warning.empty())
        state.warnings.push_back(warning);
  }
}

/// All ranks know these energies, and one records them. Springs behind fronts set theirs in each step before.
template <int D>
void record(State<D>& state, Account<D>& account)
{
  const double now = account.cohesion.dissipated(), stored = account.cohesion.stored();
  const bool records = state.ranks.rank() == 0;
  if (records)
    state.energy.fracture += now - account.recorded;
  account.recorded = now;
  const double others = state.cracks.frontSprings ? state.energy.springs : 0.0;
  state.energy.springs = others + (records ? stored : 0.0);
}

template <int D>
void addForces(State<D>& state, const Account<D>& account)
{
  account.cohesion.addForces(state);
}

template <int D>
void advance(State<D>& state, Account<D>& account)
{
  if (account.equilibrium)
    account.equilibrium->accept(state);
  else if (state.method.scheme == UpdateScheme::Usl)
    account.cohesion.advance(state, state.mesh.nodes.motion);
  else
    account.cohesion.advance(state, state.mesh.nodes.projection);
  record(state, account);
}

/// Replaced points hold another energy, though no force has done work.
template <int D>
void prepare(State<D>& state, Account<D>& account)
{
  const double change = account.cohesion.prepare(state);
  if (state.ranks.rank() == 0)
  {
    state.energy.merged -= change;
    state.energy.springs += change;
  }
}

template <int D>
Effect<D> make(const Teuchos::ParameterList& scene, const RunOptions& options)
{
  const Teuchos::ParameterList list = scene.sublist("Cohesive Faces");
  const auto account = std::make_shared<Account<D>>();
  if (isEquilibrium(scene))
    account->equilibrium = std::make_shared<CohesionInEquilibrium<D>>(account->cohesion);
  Effect<D> effect;
  effect.name = "Cohesive Faces";
  effect.balance = {"fracture"};
  effect.needs = {fields::side};
  effect.atStart = [account, list, all = Teuchos::ParameterList(scene), touching = options.contact](
                       State<D>& state) { begin(state, list, SceneBodies<D>(all), touching, account); };
  effect.judge = [account, list](State<D>& state) { judge(state, list, *account); };
  effect.call(Stage::Scatter, "points on cohesive faces", {quantity::nodalMass, quantity::enrichedFields}, {},
              {}, [account](State<D>& s) { prepare(s, *account); });
  effect.call(Stage::BeforeSolve, "cohesion of crack faces", {quantity::nodalMass, quantity::enrichedFields},
              {}, {quantity::nodalForce}, [account](State<D>& s) { addForces(s, *account); });
  effect.call(Stage::AfterProjection, "jumps of cohesive faces",
              {quantity::nodalMotion, ifWritten(quantity::projection), ifWritten(quantity::springStretch)},
              {}, {}, [account](State<D>& s) { advance(s, *account); });
  effect.call(Stage::Observe, "cohesion of crack faces", {quantity::energyBalance}, {}, {},
              [account](State<D>& s) { sampleCohesion(s, account->cohesion, account->laws); });
  effect.memory = [account](State<D>&, Archive& archive)
  {
    archive("recorded", account->recorded);
    account->cohesion.serialize(archive);
  };
  effect.report = [account](const State<D>&, nlohmann::json& summary)
  { reportCohesion(account->cohesion, account->laws, summary); };
  effect.timeStepLimit = [account](const State<D>& state) { return timeStepLimit(state, account->laws); };
  return effect;
}

} // namespace

EffectEntry cohesiveFacesEntry()
{
  EffectEntry entry{cohesiveSection(), checkCohesion, make<2>, make<3>, true};
  entry.cells.addNeeds = [](const auto&, CellNeeds& needs, auto&) { needs.facesLoaded = true; };
  return entry;
}

} // namespace Rhegma::cohesive_faces
