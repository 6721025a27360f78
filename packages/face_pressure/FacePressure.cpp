#include "face_pressure/FacePressure.hpp"

#include "archive/Archive.hpp"
#include "base/ReadList.hpp"
#include "plan/LastStage.hpp"
#include "plan/LoadOverStep.hpp"
#include "plausibility/IdleLoads.hpp"
#include "transfer/FacePush.hpp"
#include "transfer/PressureReport.hpp"

#include <memory>

namespace Rhegma::face_pressure
{

void FacePressure::serialize(Archive& archive) { archive("pressure", now_); }

template <int D>
void FacePressure::apply(State<D>& state, const FacePoints<D>& points)
{
  const LoadOverStep value = loadOverStep(state, history_);
  now_ = value.acts;
  works_ = value.works;
  publishPressure("rhegma::face_pressure::publish", state.cracks, crack_, now_);
  pushFaces("rhegma::face_pressure::push", state, points, crack_, now_);
}

template <int D>
double FacePressure::work(const State<D>& state, const FacePoints<D>& points) const
{
  return workOnFaces("rhegma::face_pressure::work", state, points, crack_, works_);
}

namespace
{

Section section()
{
  Section s("Face Pressure", "Prescribed pressure on crack faces.");
  Section crack("crack", "Pressure in one crack. The sublist has the name of the crack.");
  crack.timeFunction("Pressure")
      .unit("Pa")
      .meaning("Pressure as a function of time: an expression of t or a table \"0:0, 1e-5:1e6\".");
  s.namedByUser(crack);
  s.namedAfter("Cracks", "there are no cracks; add the section Cracks or leave Face Pressure out");
  return s;
}

/// A pressure must be a number at any time of the run.
void checkPressure(const Teuchos::ParameterList& scene, const std::string& name,
                   std::vector<SceneError>& errors)
{
  const Teuchos::ParameterList& list = scene.sublist("Face Pressure").sublist(name);
  if (!list.isType<std::string>("Pressure") || !scene.isSublist("Time") ||
      !scene.sublist("Time").isType<double>("Final Time"))
    return;
  const double end = scene.sublist("Time").get<double>("Final Time");
  if (const auto message = messageIfNotFinite(list.get<std::string>("Pressure"), end))
    errors.push_back({"Face Pressure > " + name + " > Pressure", *message});
}

void check(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors)
{
  for (const std::string& name : sublistNames(scene.sublist("Face Pressure")))
    checkPressure(scene, name, errors);
}

/// The state of the effect that lasts from step to step.
template <int D>
struct Account
{
  FacePoints<D> points;
  std::vector<FacePressure> pressures;
};

template <int D>
Effect<D> make(const Teuchos::ParameterList& scene)
{
  const Teuchos::ParameterList list = scene.sublist("Face Pressure");
  const auto account = std::make_shared<Account<D>>();
  Effect<D> effect;
  effect.name = "Face Pressure";
  effect.needs = {fields::side};
  effect.atStart = [account, list](State<D>& state)
  {
    for (const std::string& name : sublistNames(list))
      account->pressures.emplace_back(findCrack(state.cracks, name),
                                      TimeFunction::parse(list.sublist(name).get<std::string>("Pressure")));
  };
  effect.judge = [list, all = Teuchos::ParameterList(scene)](State<D>& state)
  {
    const ActingTimes times = actingTimes(all, state);
    for (const std::string& name : sublistNames(list))
      for (const std::string& message :
           idleMessages({"Face Pressure > " + name, "pressure"}, "Pressure",
                        list.sublist(name).get<std::string>("Pressure"), "Pa", times))
        state.warnings.push_back(message);
  };
  effect.call(Stage::BeforeSolve, "pressure on crack faces", {quantity::nodalMass, quantity::crackGeometry},
              {}, {quantity::nodalForce, quantity::facePressure},
              [account](State<D>& s)
              {
                account->points.update(s);
                for (FacePressure& pressure : account->pressures)
                  pressure.apply(s, account->points);
              });
  effect.call(stageOfFaceVelocity(scene), "work of pressure on crack faces",
              {projectsLast(scene) ? quantity::projection : quantity::nodalMotion}, {}, {},
              [account](State<D>& s)
              {
                for (const FacePressure& pressure : account->pressures)
                  s.energy.externalWork += pressure.work(s, account->points);
              });
  effect.call(Stage::Observe, "pressure in cracks", {quantity::facePressure}, {}, {},
              [account](State<D>& s)
              {
                for (const FacePressure& pressure : account->pressures)
                  samplePressure(s, pressure.crack(), pressure.pressure());
              });
  effect.memory = [account](State<D>&, Archive& archive)
  {
    for (FacePressure& pressure : account->pressures)
    {
      const Archive::Group group(archive, std::to_string(pressure.crack()));
      pressure.serialize(archive);
    }
    const Archive::Group group(archive, "points");
    account->points.serialize(archive);
  };
  effect.report = [account](const State<D>&, nlohmann::json& summary)
  {
    for (const FacePressure& pressure : account->pressures)
      reportPressure(summary, pressure.crack(), pressure.pressure());
  };
  return effect;
}

} // namespace

EffectEntry facePressureEntry()
{
  EffectEntry entry{section(), check, make<2>, make<3>, true};
  entry.declare = [](const Teuchos::ParameterList& list, RunOptions& options)
  {
    for (const std::string& name : sublistNames(list))
    {
      options.pressedCracks.insert(name);
      if (list.sublist(name).isType<std::string>("Pressure")) // else the scene is refused
        options.facePressures["Face Pressure > " + name + " > Pressure"] =
            list.sublist(name).get<std::string>("Pressure");
    }
  };
  entry.cells.addNeeds = [](const auto&, CellNeeds& needs, auto&) { needs.facesLoaded = true; };
  return entry;
}

template void FacePressure::apply(State<2>&, const FacePoints<2>&);
template void FacePressure::apply(State<3>&, const FacePoints<3>&);
template double FacePressure::work(const State<2>&, const FacePoints<2>&) const;
template double FacePressure::work(const State<3>&, const FacePoints<3>&) const;

} // namespace Rhegma::face_pressure
