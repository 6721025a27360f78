#include "face_pressure/FacePressure.hpp"

#include "scene/ReadList.hpp"

#include <memory>
#include <stdexcept>

namespace Rhegma::face_pressure
{

namespace
{

/// Force on the face of side +1 at point k [N].
KOKKOS_INLINE_FUNCTION Vector<2> faceForce(const FacePoints& points, int k, double pressure, double thickness)
{
  const Vector<2> normal{points.normal(k, 0), points.normal(k, 1)};
  return (pressure * points.currentLength(k) * thickness) * normal;
}

/// Lets others know of the pressure.
void publish(CrackSet<2>& cracks, int crack, double pressure)
{
  if (cracks.pressure.extent(0) != cracks.simplex.extent(0))
    cracks.pressure = View<double*>("rhegma::crackPressure", cracks.simplex.extent(0));
  const View<double*> of = cracks.pressure;
  const int first = cracks.cracks[crack].firstSimplex;
  Kokkos::parallel_for(
      "rhegma::face_pressure::publish", Kokkos::RangePolicy<ExecSpace>(0, cracks.cracks[crack].numSimplices),
      KOKKOS_LAMBDA(const int s) { of(first + s) = pressure; });
}

} // namespace

void FacePressure::apply(State<2>& state, const FacePoints& points)
{
  now_ = history_(state.time + 0.5 * state.dt);
  publish(state.cracks, crack_, now_);
  const FacePoints p = points;
  const Nodes<2> nodes = state.nodes;
  const double pressure = now_, thickness = state.thickness;
  const int crack = crack_;
  Kokkos::parallel_for(
      "rhegma::face_pressure::apply", Kokkos::RangePolicy<ExecSpace>(0, points.count()),
      KOKKOS_LAMBDA(const int k) {
        if (p.crack(k) != crack)
          return;
        const Vector<2> force = faceForce(p, k, pressure, thickness);
        addFaceForce(nodes, p.above, k, force);
        addFaceForce(nodes, p.below, k, -1.0 * force);
      });
}

double FacePressure::work(const State<2>& state, const FacePoints& points) const
{
  const FacePoints p = points;
  const Nodes<2> nodes = state.nodes;
  const double pressure = now_, thickness = state.thickness, dt = state.dt;
  const int crack = crack_;
  // Velocity in the middle of the step.
  const auto mean = KOKKOS_LAMBDA(const int n, const int d)
  {
    return nodes.motion(n, d) - 0.5 * dt * nodes.motion(n, Nodes<2>::accelerationAt + d);
  };
  double work = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::face_pressure::work", Kokkos::RangePolicy<ExecSpace>(0, points.count()),
      KOKKOS_LAMBDA(const int k, double& sum) {
        if (p.crack(k) == crack)
          sum += dt * dot(faceForce(p, k, pressure, thickness), jumpAt(p.below, p.above, k, mean));
      },
      work);
  return work;
}

namespace
{

Section section()
{
  Section s("Face Pressure", "A pressure that is given in time and pushes the faces of cracks apart.");
  Section crack("crack", "The pressure in the crack of this name.");
  crack.timeFunction("Pressure")
      .unit("Pa")
      .meaning("Over time: an expression of t or a table \"0:0, 1e-5:1e6\".");
  s.namedByUser(crack);
  return s;
}

void check(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors)
{
  if (!scene.isSublist("Face Pressure"))
    return;
  if (!scene.isSublist("Cracks"))
  {
    errors.push_back({"Face Pressure", "there are no crack faces that it could push; add a section Cracks or "
                                       "leave Face Pressure out"});
    return;
  }
  const std::vector<std::string> cracks = sublistNames(scene.sublist("Cracks"));
  std::string known;
  for (const std::string& name : cracks)
    known += (known.empty() ? "" : ", ") + name;
  for (const std::string& name : sublistNames(scene.sublist("Face Pressure")))
    if (!scene.sublist("Cracks").isSublist(name))
      errors.push_back({"Face Pressure > " + name, "there is no crack of this name; Cracks has " + known});
}

/// What the effect keeps from step to step.
struct Account
{
  FacePoints points;
  std::vector<FacePressure> pressures;
};

int findCrack(const CrackSet<2>& cracks, const std::string& name)
{
  for (std::size_t c = 0; c < cracks.cracks.size(); ++c)
    if (cracks.cracks[c].name == name)
      return static_cast<int>(c);
  throw std::invalid_argument("Face Pressure > " + name + ": there is no crack of this name");
}

Effect<2> make2(const Teuchos::ParameterList& scene)
{
  const Teuchos::ParameterList list = scene.sublist("Face Pressure");
  const auto account = std::make_shared<Account>();
  Effect<2> effect;
  effect.name = "Face Pressure";
  effect.needs = {fields::side};
  effect.atStart = [account, list](State<2>& state)
  {
    for (const std::string& name : sublistNames(list))
      account->pressures.emplace_back(findCrack(state.cracks, name),
                                      TimeFunction::parse(list.sublist(name).get<std::string>("Pressure")));
  };
  effect.call({Stage::BeforeSolve,
               "pressure on crack faces",
               {"nodal mass"},
               {},
               {"nodal force"},
               [account](State<2>& s)
               {
                 account->points.update(s);
                 for (FacePressure& pressure : account->pressures)
                   pressure.apply(s, account->points);
               }});
  effect.call({Stage::AfterSolve,
               "work of pressure on crack faces",
               {"constrained motion"},
               {},
               {},
               [account](State<2>& s)
               {
                 for (const FacePressure& pressure : account->pressures)
                   s.energy.externalWork += pressure.work(s, account->points);
               }});
  effect.call({Stage::Observe,
               "pressure in cracks",
               {"energies"},
               {},
               {},
               [account](State<2>& s)
               {
                 for (const FacePressure& pressure : account->pressures)
                   s.row.emplace_back(s.cracks.cracks[pressure.crack()].name + ".pressure",
                                      pressure.pressure());
               }});
  effect.report = [account](const State<2>&, nlohmann::json& summary)
  {
    for (const FacePressure& pressure : account->pressures)
      summary["cracks"][pressure.crack()]["pressure"] = pressure.pressure();
  };
  return effect;
}

Effect<3> make3(const Teuchos::ParameterList&)
{
  throw std::invalid_argument("Face Pressure: pressure on crack faces in three dimensions is not in this "
                              "version; use a 2D scene");
}

} // namespace

EffectEntry facePressureEntry() { return {section(), check, make2, make3}; }

} // namespace Rhegma::face_pressure
