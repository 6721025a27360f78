#include "contact/Contact.hpp"

#include "archive/Archive.hpp"
#include "contact/Balance.hpp"
#include "contact/ClosedVisibility.hpp"
#include "contact/ContactInEquilibrium.hpp"
#include "contact/FaceContact.hpp"
#include "material/MaterialTable.hpp"
#include "scene/RoundBodies.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

namespace Rhegma::contact
{

namespace
{

Section section()
{
  Section s("Contact", "Contact of crack faces. Without this section, closed faces overlap freely.");
  refuseAxisymmetric(s, "the faces of cracks press on each other per thickness, not around a circle");
  s.refuse(
      {when::present("Contact"), when::is("Time", "Initial State", {"Equilibrium"})},
      "the equilibrium at the start does not include contact; write Unloaded or Equilibrium Without Cracks");
  s.refuse({when::is("Contact", "Law", {"Visibility"}), when::equilibrium()},
           "Visibility compares velocities, which are zero in equilibrium; choose another law");
  s.choice("Law", {"Stick", "Frictionless", "Coulomb", "Visibility"})
      .byDefault("Frictionless")
      .meaning("Tangential behaviour of closed faces: full stick, frictionless slip, or Coulomb friction. "
               "Visibility (only with Cracks > Formulation = Broken Cell, for comparison): closed parts are "
               "treated as uncracked.");
  s.real("Friction Coefficient").notNegative().optional().meaning("Friction coefficient of Law = Coulomb.");
  s.real("Penalty").positive().byDefault(2.0).meaning(
      "Penalty stiffness, in units of the P-wave modulus over the cell size. Above 3, a smaller time step "
      "may be needed.");
  s.moved["Watched Part"] = "Measure > Side Energy > Part";
  s.needs("Cracks", "there are no cracks; add the section Cracks or leave Contact out");
  s.refuse(
      {when::is("Contact", "Law", {"Visibility"}), when::isNot("Cracks", "Formulation", {"Broken Cell"})},
      "Visibility needs Cracks > Formulation = Broken Cell; choose that formulation or another law");
  return s;
}

void check(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors)
{
  const Teuchos::ParameterList& list = scene.sublist("Contact");
  if (!list.isParameter("Law"))
    return;
  const bool coulomb = list.get<std::string>("Law") == "Coulomb";
  const bool given = list.isParameter("Friction Coefficient");
  if (coulomb && !given)
    errors.push_back(
        {"Contact > Friction Coefficient",
         "is missing; Law = Coulomb needs it: write, for example, 0.3, or choose Law = Frictionless"});
  if (!coulomb && given)
    errors.push_back({"Contact > Friction Coefficient",
                      "the law " + list.get<std::string>("Law") +
                          " has no friction coefficient; leave it out or choose Law = Coulomb"});
}

Law readLaw(const std::string& name)
{
  return name == "Stick" ? Law::Stick : name == "Coulomb" ? Law::Coulomb : Law::Frictionless;
}

/// The state of the effect that lasts from step to step.
template <int D>
struct Account
{
  explicit Account(FaceContact<D> c) : contact(std::move(c)) {}
  FaceContact<D> contact;
  std::unique_ptr<ClosedVisibility> visibility;         ///< in place of `contact`, if a 2D scene asks for it
  std::shared_ptr<ContactInEquilibrium<D>> equilibrium; ///< of `contact`, unless bodies move
  double recorded = 0.0;                                ///< energy that stands in the energy balance [J]
  Balance<D> balance;
};

/// Whether this rank records quantities that all ranks know.
template <int D>
bool recordsForAllRanks(const State<D>& state)
{
  return state.ranks.rank() == 0;
}

template <int D>
void record(State<D>& state, Account<D>& account)
{
  const double now = account.contact.stored() + account.contact.dissipated();
  if (recordsForAllRanks(state))
    state.energy.contact += now - account.recorded;
  account.recorded = now;
}

/// Marks the points of one crack up to a distance from a middle along it (CrackSet::contactEnergy).
template <int D>
View<int*> pointsIn(const FacePoints<D>& points, int crack, double middle, double reach)
{
  View<int*> part("rhegma::contactPart", points.count());
  const auto host = Kokkos::create_mirror_view(part);
  const auto of = onHost(points.crack);
  const auto length = onHost(points.size);
  double passed = 0.0;
  for (int k = 0; k < points.count(); ++k)
    if (of(k) == crack)
    {
      const double along = passed + 0.5 * length(k);
      host(k) = D == 3 || std::abs(along - middle) <= reach ? 1 : 0;
      passed += length(k);
    }
  Kokkos::deep_copy(part, host);
  return part;
}

constexpr double everywhere = 1e300; ///< a distance that no body has [m]

template <int D>
ContactEnergy energyIn(const FaceContact<D>& contact, int crack, double middle, double reach)
{
  const View<int*> part = pointsIn(contact.points(), crack, middle, reach);
  return {contact.storedIn(part), contact.dissipatedIn(part)};
}

template <int D>
void observe(State<D>& state, Account<D>& account)
{
  const EnergyBalance& energy = state.energy;
  // New faces dissipate energy; heat from outside does not change this balance.
  account.balance.compare(state, energy.damped + energy.filtered + energy.plastic + energy.merged +
                                     energy.fracture + energy.stabilised + energy.thermal - energy.heat +
                                     account.contact.dissipated());
}

template <int D>
void report(const State<D>& state, const Account<D>& account, nlohmann::json& summary)
{
  const FaceContact<D>& contact = account.contact;
  std::vector<CrackContact> cracks = contact.cracks();
  if (cracks.empty() && !account.visibility) // before the first step
    cracks.resize(state.cracks.cracks.size());
  for (std::size_t c = 0; c < cracks.size(); ++c)
  {
    const CrackContact& crack = cracks[c];
    const ContactEnergy energy = energyIn(contact, static_cast<int>(c), 0.0, everywhere);
    nlohmann::json& entry = summary["cracks"][c]["contact"];
    entry["touches"] = crack.touches;
    // Entries without a value are written as null.
    entry["first_touch"] = crack.touches > 0 ? nlohmann::json(crack.firstTouch) : nlohmann::json();
    entry["closed_points"] = crack.closedPoints;
    entry["largest_pressure"] = crack.largestPressure;
    entry["stored"] = energy.stored;
    entry["friction"] = energy.dissipated;
  }
  if (account.visibility)
    for (std::size_t c = 0; c < state.cracks.cracks.size(); ++c)
      summary["cracks"][c]["contact"]["closed_points"] =
          account.visibility->closedPoints(static_cast<int>(c));
  nlohmann::json& friction = summary["energy"]["friction"]; // of bodies, too
  friction = contact.dissipated() + (friction.is_number() ? friction.get<double>() : 0.0);
  if (account.equilibrium)
    return;
  summary["energy"]["last_fraction"] = account.balance.lastFraction();
  summary["energy"]["smallest_fraction"] = account.balance.smallestFraction();
  summary["energy"]["largest_fraction"] = account.balance.largestFraction();
}

/// An explicit step resolves frequencies w only below 2 / w. Cells have w^2 <= 8 c^2 / h^2; the layer adds 4
/// alpha c^2 / h^2 on nodes with half a cell's mass on each side, and no more where it cuts cells, because
/// mass and stiffness of a node both go with the square of its distance from the crack. A tenth is kept as a
/// margin. In 3D cells have w^2 <= 12 c^2 / h^2. In refined cells the layer is as stiff as between the
/// largest ones, so that it adds less; with Sub-Cycling it follows the substeps of the nodes.
///
/// Extrapolated weights (Cracks > Formulation Corrected Broken Cell) see a face at up to 2 and -1 times two
/// nodes and feed back up to 3.2 times what is scattered (docs/explanation/broken-cells.md): at worst, a
/// crack a tenth of a cell above a row of nodes, the largest eigenvalue of the step is (25 + 16 alpha) c^2 /
/// h^2.
template <int D>
double timeStepLimit(const State<D>& state, double alpha, bool extrapolated)
{
  double fastest = 0.0;
  for (const Properties& p : state.materials.properties)
    fastest = std::max(fastest, std::sqrt(elasticity(p).constrainedModulus / p.density));
  const double square = extrapolated ? 25.0 + 16.0 * alpha : 4.0 * (D + alpha);
  return 0.9 * 2.0 / std::sqrt(square) * state.mesh.stepSpacing() / fastest;
}

template <int D>
void prepare(State<D>& state, Account<D>& account)
{
  account.balance.begin(state);
  if constexpr (D == 2)
    if (account.visibility)
    {
      account.visibility->prepare(state);
      return;
    }
  // Replaced points hold another energy of the layer, though no force has done work.
  const double change = account.contact.prepare(state);
  if (recordsForAllRanks(state))
  {
    state.energy.merged -= change;
    state.energy.contact += change;
  }
  account.recorded += change;
}

template <int D, class Velocity>
void advance(State<D>& state, Account<D>& account, const Velocity& velocity)
{
  if constexpr (D == 2)
    if (account.visibility)
    {
      account.visibility->advance(state, velocity);
      return;
    }
  account.contact.advance(state, velocity);
  record(state, account);
}

/// Gaps follow the velocity that strains the particles.
template <int D>
void advance(State<D>& state, Account<D>& account)
{
  if (account.equilibrium)
  {
    account.equilibrium->accept(state);
    record(state, account);
  }
  else if (state.method.scheme == UpdateScheme::Usl)
    advance(state, account, state.mesh.nodes.motion);
  else
    advance(state, account, state.mesh.nodes.projection);
}

template <int D>
void addForces(State<D>& state, Account<D>& account)
{
  if (!account.equilibrium)
    return account.contact.addForces(state);
  const View<double * [D + 1]> force("rhegma::contactForce", state.mesh.nodes.sums.extent(0));
  account.equilibrium->addForces(state, force);
  const Nodes<D> nodes = state.mesh.nodes;
  Kokkos::parallel_for(
      "rhegma::contact::addForcesOfNodes", Kokkos::RangePolicy<ExecSpace>(0, force.extent(0)),
      KOKKOS_LAMBDA(const int n) {
        for (int d = 0; d < D; ++d)
          nodes.sums(n, Nodes<D>::forceAt + d) += force(n, d);
      });
}

template <int D>
void begin(State<D>& state, const std::shared_ptr<Account<D>>& account)
{
  if constexpr (D == 2)
    if (account->visibility)
      account->visibility->install(state);
  if (account->equilibrium)
    state.motion.stepForces.push_back(account->equilibrium);
  else if (!account->visibility)
    state.motion.displacementDependentForces.push_back(
        {[account](const State<D>& s, const NodeSlots& slots, const View<double* [D]>& force)
         { account->contact.addFrozenForces(s, slots, force); },
         [account](const State<D>& s, const NodeSlots& slots, const View<double* [D]>& displacement,
                   const View<double* [D]>&, const View<double* [D]>& force)
         { account->contact.addChange(s, slots, displacement, force); },
         {}});
  state.cracks.contactEnergy = [account](int crack, double middle, double reach)
  { return energyIn(account->contact, crack, middle, reach); };
  if (account->visibility)
    return;
  state.cracks.tractions = [account](int crack) { return account->contact.tractions(crack); };
  state.cracks.addTractions = [account](const State<D>& s, const View<double * [D + 1]>& force)
  {
    if (account->equilibrium)
      account->equilibrium->balance(s, force);
    else
      account->contact.addForces(force);
  };
}

template <int D>
void serialize(Account<D>& account, Archive& archive)
{
  archive("recorded", account.recorded);
  {
    const Archive::Group group(archive, "balance");
    account.balance.serialize(archive);
  }
  if (account.visibility)
    account.visibility->serialize(archive);
  else
    account.contact.serialize(archive);
  if (account.equilibrium)
    account.equilibrium->serialize(archive);
}

template <int D>
Effect<D> make(const Teuchos::ParameterList& scene, const RunOptions& options)
{
  const Teuchos::ParameterList& list = scene.sublist("Contact");
  const double alpha = list.get<double>("Penalty");
  const double friction =
      list.isParameter("Friction Coefficient") ? list.get<double>("Friction Coefficient") : 0.0;
  const auto account =
      std::make_shared<Account<D>>(FaceContact<D>(readLaw(list.get<std::string>("Law")), friction, alpha));
  const bool visibility = list.get<std::string>("Law") == "Visibility";
  const bool equilibrium = scene.sublist("Time").get<std::string>("Analysis") != "Dynamic";
  if (visibility)
    account->visibility = std::make_unique<ClosedVisibility>();
  if (equilibrium)
    account->equilibrium = std::make_shared<ContactInEquilibrium<D>>(account->contact);
  Effect<D> effect;
  effect.name = "Contact";
  effect.balance = {"contact"};
  effect.needs = {fields::side};
  effect.atStart = [account](State<D>& state) { begin(state, account); };
  effect.call(Stage::Scatter, "points on crack faces", {quantity::nodalMass, quantity::enrichedFields}, {},
              {}, [account](State<D>& s) { prepare(s, *account); });
  if (!visibility)
    effect.call(Stage::BeforeSolve, "contact of crack faces", {quantity::nodalMass, quantity::enrichedFields},
                {}, {quantity::nodalForce}, [account](State<D>& s) { addForces(s, *account); });
  if (!equilibrium)
    effect.call(Stage::AfterSolve, "balance of energy",
                {quantity::nodalMotion, ifWritten(quantity::constrainedMotion)}, {}, {},
                [account](State<D>& s)
                {
                  if (s.clock.observing)
                    account->balance.measure(s, account->contact.stored());
                });
  effect.call(Stage::AfterProjection, "gaps of crack faces",
              {quantity::nodalMotion, ifWritten(quantity::projection)}, {quantity::contactGaps}, {},
              [account](State<D>& s) { advance(s, *account); });
  if (!equilibrium)
    effect.call(Stage::Observe, "fractions of energy", {quantity::energyBalance, quantity::contactGaps}, {},
                {}, [account](State<D>& s) { observe(s, *account); });
  effect.memory = [account](State<D>&, Archive& archive) { serialize(*account, archive); };
  effect.report = [account](const State<D>& state, nlohmann::json& summary)
  { report(state, *account, summary); };
  effect.timeStepLimit = [alpha, extrapolated = options.extrapolated](const State<D>& state)
  { return timeStepLimit(state, alpha, extrapolated); };
  return effect;
}

} // namespace

EffectEntry contactEntry()
{
  EffectEntry entry{section(), check, make<2>, make<3>, true};
  entry.declare = [](const Teuchos::ParameterList&, RunOptions& options) { options.contact = true; };
  entry.cells.addNeeds = [](const Teuchos::ParameterList& scene, CellNeeds& needs, auto&)
  {
    needs.facesLoaded = true;
    needs.equal = needs.equal || scene.sublist("Contact").get<std::string>("Law") == "Visibility";
  };
  return entry;
}

} // namespace Rhegma::contact
