#include "cracks/Cracks.hpp"

#include "cracks/CrackMotion.hpp"
#include "cracks/CrackSetup.hpp"
#include "cracks/Normals.hpp"
#include "cracks/Sides.hpp"
#include "cracks/Visibility.hpp"
#include "scene/ReadList.hpp"

#include <memory>

namespace Rhegma::cracks
{

namespace
{

Section section()
{
  Section s("Cracks", "Explicit cracks that cut the body wherever they lie in the cells.");
  s.choice("Formulation", {"Dual Field", "Broken Cell", "Corrected Broken Cell"})
      .byDefault("Dual Field")
      .meaning("How cells are cut: a velocity field on each side; shape functions broken by visibility; the "
               "same made "
               "linearly complete by extrapolation.");
  Section crack("crack", "One crack; its own name is up to you.");
  crack.realArray("Points").unit("m").perPoint(2).meaning(
      "The crack as a polyline, point after point. Points outside of the body are cut off.");
  crack.choice("Fronts", {"Automatic", "First", "Last", "Both", "None"})
      .byDefault("Automatic")
      .meaning("Which ends are crack fronts. Automatic: those with material ahead of them.");
  s.namedByUser(crack);
  return s;
}

void check(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors)
{
  if (scene.isSublist("Cracks") && sublistNames(scene.sublist("Cracks")).empty())
    errors.push_back({"Cracks",
                      "the section holds no crack; write one as <ParameterList name=\"...\"> or leave "
                      "the section out"});
  if (scene.isSublist("Cracks") && scene.isSublist("Domain") &&
      scene.sublist("Domain").isParameter("Dimension") && scene.sublist("Domain").get<int>("Dimension") == 3)
    errors.push_back({"Cracks", "cracks in three dimensions are not in this version; use a 2D scene"});
}

Formulation readFormulation(const Teuchos::ParameterList& section)
{
  const std::string name = section.get<std::string>("Formulation");
  return name == "Broken Cell"             ? Formulation::BrokenCell
         : name == "Corrected Broken Cell" ? Formulation::CorrectedBrokenCell
                                           : Formulation::DualField;
}

Effect<2> make2(const Teuchos::ParameterList& scene)
{
  const Teuchos::ParameterList section = scene.sublist("Cracks");
  const Formulation formulation = readFormulation(section);
  const auto surroundings = std::make_shared<Surroundings>();
  const auto ghosts = std::make_shared<Ghosts>();
  const auto motion = std::make_shared<CrackMotion>();
  Effect<2> effect;
  effect.name = "Cracks";
  effect.adds.push_back(
      {fields::side, 1, "", "side of the nearest crack: its number + 1, negative on side -1", true});
  if (formulation == Formulation::BrokenCell)
    effect.adds.push_back(
        {crackNormal, 2, "", "unit normal of the face near the particle, out of its material"});
  effect.atStart = [=](State<2>& state)
  {
    state.cracks.dualField = formulation == Formulation::DualField;
    readCracks(section, state);
    state.editor.prepare = [=](State<2>& s, const View<int*>& row)
    {
      findSides(s, *surroundings, row);
      if (formulation == Formulation::CorrectedBrokenCell)
        findGhosts(s, row, *ghosts);
      if (formulation == Formulation::BrokenCell)
        carryNormals(s, row);
    };
    state.editor.edit = [=](const State<2>& s, const ObservedPoints<2>& points, const StencilTable<2>& table)
    { editStencils(s, formulation, *ghosts, points, table); };
  };
  effect.call({Stage::Gather, "cracks move", {"nodal motion"}, {"crack geometry"}, {}, [motion](State<2>& s) {
                 motion->move(s);
               }});
  if (formulation == Formulation::CorrectedBrokenCell)
    effect.timeStepLimit = [](const State<2>& state)
    { return largestCflOfGhosts * state.grid.spacing / state.fastest; };
  effect.report = [](const State<2>& state, nlohmann::json& summary)
  {
    for (std::size_t c = 0; c < state.cracks.cracks.size(); ++c)
    {
      summary["cracks"][c]["name"] = state.cracks.cracks[c].name;
      if (!summary["cracks"][c].contains("fronts"))
        summary["cracks"][c]["fronts"] = nlohmann::json::array();
    }
    for (const CrackFront<2>& front : state.cracks.fronts)
    {
      nlohmann::json& entry = summary["cracks"][front.crack]["fronts"][front.number];
      entry["position"] = {front.position[0], front.position[1]};
      entry["length"] = front.length;
      entry["speed"] = front.speed;
    }
  };
  return effect;
}

Effect<3> make3(const Teuchos::ParameterList&)
{
  throw std::invalid_argument("Cracks: cracks in three dimensions are not in this version; use a 2D scene");
}

} // namespace

EffectEntry cracksEntry() { return {section(), check, make2, make3}; }

} // namespace Rhegma::cracks
