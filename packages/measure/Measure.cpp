#include "measure/Measure.hpp"

#include "base/ReadList.hpp"
#include "base/ShortNumber.hpp"
#include "material/MaterialTable.hpp"
#include "measure/Extremes.hpp"
#include "measure/FrontShape.hpp"
#include "measure/Pieces.hpp"
#include "measure/SideEnergy.hpp"
#include "measure/StressAlternation.hpp"
#include "scene/Compatibility.hpp"
#include "scene/NearestName.hpp"
#include "state/ParticleDamage.hpp"

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>

namespace Rhegma::measure
{

namespace
{

Section extremes()
{
  Section entry("extreme", "Largest and smallest value of a field of the particles. You choose its name.");
  entry.choice("Field", measurableFields())
      .meaning(
          "Principal Stress: the largest principal Cauchy stress, in 2D including that across the plane "
          "[Pa]. Von Mises Stress [Pa]. Energy Density: elastic energy per undeformed volume [J/m3]. Damage: "
          "that of the law, from 0 of a whole to 1 of a broken material. Speed [m/s]. Displacement: its "
          "magnitude [m]. Temperature [K].");
  entry.text("Body").notEmpty().optional().meaning(
      "Only the particles of this body count. Default: all bodies.");
  Section s("Extremes",
            "Largest and smallest values of fields over time, and where they are. They are in history.csv as "
            "NAME.largest, NAME.largest_x, NAME.smallest, NAME.smallest_x and so on, and in summary.json.");
  s.namedByUser(entry);
  return s;
}

Section section()
{
  Section s("Measure", "Additional results in summary.json and history.csv that only few scenes need, such "
                       "as those that verify "
                       "a method.");
  Section sides("Side Energy", "Energy on each side of each crack: reflected, transmitted and dissipated.");
  sides.real("Part").above(0.0).atMost(1.0).byDefault(1.0).onlyIn(2).meaning(
      "Fraction of the length of each crack, around its middle. Only material next to it is included. 1: the "
      "whole body.");
  s.subsection(sides);
  Section shape("Front Shape",
                "Radius, roundness and flatness of fronts that are a circle, or part of one, at the start.");
  shape.onlyIn(3);
  s.subsection(shape);
  Section stress("Stress Alternation",
                 "Part of the stress of each body that changes from particle to particle within the cells.");
  s.subsection(stress);
  s.subsection(extremes());
  s.subsection(
      {"Pieces",
       "Into how many pieces cracks have divided the bodies. Bonded bodies are one piece. history.csv gets "
       "the number of pieces and the mass of the largest one, summary.json mass and centre of each, and "
       "fields.h5 the number of each particle's piece, 0 for the largest; -1 before the first step."});
  for (const char* const ofCracks : {"Measure > Side Energy", "Measure > Front Shape"})
    s.refuse({when::present(ofCracks), when::absent("Cracks")},
             "there is no crack to measure at; add a section Cracks or remove this section");
  s.refuse({when::present("Measure > Stress Alternation"), when::is("Thermal", "Mechanics", {"false"})},
           "without mechanics there is no stress; remove one of the two");
  s.refuse({when::present("Measure > Pieces"), when::is("Thermal", "Mechanics", {"false"})},
           "without mechanics no body comes apart; remove one of the two");
  return s;
}

/// The sides of each crack at the start.
template <int D>
struct Sides
{
  std::vector<MeasuredCrack<D>> cracks;
  std::vector<SideEnergy> start;
};

template <int D>
void begin(const State<D>& state, double part, Sides<D>& sides)
{
  for (std::size_t c = 0; c < state.cracks.cracks.size(); ++c)
  {
    sides.cracks.push_back(measuredCrack(state.cracks, static_cast<int>(c), part));
    sides.start.push_back(measureSides(state, sides.cracks.back()));
  }
}

/// A number, or null where it has no value.
nlohmann::json where(bool known, double value) { return known ? nlohmann::json(value) : nlohmann::json(); }

template <int D>
void reportSides(const State<D>& state, const Sides<D>& sides, nlohmann::json& summary)
{
  for (std::size_t c = 0; c < sides.cracks.size(); ++c)
  {
    const MeasuredCrack<D>& crack = sides.cracks[c];
    ContactEnergy layer;
    if (state.cracks.contactEnergy)
      layer = state.cracks.contactEnergy(static_cast<int>(c), 0.5 * crack.length, crack.reach);
    SideEnergy now = measureSides(state, crack);
    // The layer between the faces belongs to both sides.
    now.below += 0.5 * layer.stored - sides.start[c].below;
    now.above += 0.5 * layer.stored - sides.start[c].above;
    const double friction = layer.dissipated, all = now.below + now.above + friction;
    // Strain and kinetic energy of a travelling wave are equal.
    const double waves = 2.0 * (now.alongBelow + now.alongAbove) + friction;
    nlohmann::json& entry = summary["cracks"][c]["contact"];
    entry["gain_below"] = now.below;
    entry["gain_above"] = now.above;
    entry["along_below"] = now.alongBelow;
    entry["along_above"] = now.alongAbove;
    entry["shear_fraction_below"] = where(waves > 0.0, 2.0 * now.alongBelow / waves);
    entry["shear_fraction_above"] = where(waves > 0.0, 2.0 * now.alongAbove / waves);
    entry["shear_fraction_friction"] = where(waves > 0.0, friction / waves);
    entry["fraction_below"] = where(all != 0.0, now.below / all);
    entry["fraction_above"] = where(all != 0.0, now.above / all);
    entry["fraction_friction"] = where(all != 0.0, friction / all);
  }
}

/// \param circles that the fronts were at the start
void reportShapes(const State<3>& state, const std::vector<Circle>& circles, nlohmann::json& summary)
{
  for (std::size_t f = 0; f < circles.size(); ++f)
  {
    const CrackFront<3>& front = state.cracks.fronts[f];
    if (circles[f].radius == 0.0 || front.ended)
      continue;
    const Shape shape = shapeOf(front, circles[f]);
    nlohmann::json& entry = summary["cracks"][front.crack]["fronts"][front.number];
    entry["radius"] = shape.radius;
    entry["roundness"] = shape.roundness;
    entry["flatness"] = shape.flatness;
  }
}

template <int D>
void reportStress(const State<D>& state, nlohmann::json& summary)
{
  nlohmann::json& bodies = summary["bodies"];
  const std::size_t count = std::min(bodies.size(), state.bodies.info.size());
  for (std::size_t b = 0; b < count; ++b)
  {
    const StressAlternation found = stressAlternation(state, static_cast<int>(b));
    bodies[b]["stress_alternation"] = {{"deviation", found.deviation},
                                       {"largest", found.largest},
                                       {"ratio", where(found.largest > 0.0, found.ratio())}};
  }
}

/// A request for the extremes of a field.
struct Watched
{
  std::string name, field;
  int body = -1; ///< -1: all
};

/// Why a run has no such field; empty if it has.
template <int D>
std::string whyNot(const State<D>& state, const std::string& field)
{
  if (field == "Temperature")
    return state.particles.has(fields::temperature)
               ? ""
               : "the scene has no temperature; add a section Thermal or choose another field";
  if (field == "Damage" && !hasDamage(state))
    return "no material has a damage; write Materials > NAME > Model = " + asText(lawsWithDamage()) +
           " or choose another field";
  return state.method.mechanics ? "" : "without mechanics only Temperature changes; write that";
}

/// Reads the requests. Throws std::invalid_argument where a body or a field does not exist.
template <int D>
std::vector<Watched> readExtremes(const State<D>& state, const Teuchos::ParameterList& list)
{
  std::vector<Watched> all;
  for (const std::string& name : sublistNames(list))
  {
    const Teuchos::ParameterList& entry = list.sublist(name);
    Watched watched{name, entry.get<std::string>("Field"), -1};
    if (const std::string why = whyNot(state, watched.field); !why.empty())
      throw std::invalid_argument(std::string("Measure > Extremes > ")
                                      .append(name)
                                      .append(" > Field = ")
                                      .append(watched.field)
                                      .append(": ")
                                      .append(why));
    if (entry.isParameter("Body"))
    {
      const std::string body = entry.get<std::string>("Body");
      watched.body = findBody(state, body);
      if (watched.body < 0)
        throw std::invalid_argument(std::string("Measure > Extremes > ")
                                        .append(name)
                                        .append(" > Body: there is no body ")
                                        .append(body));
    }
    all.push_back(watched);
  }
  return all;
}

/// Calls add(name, extreme) for the largest and the smallest value of a field. Collective.
template <int D, class Add>
void forBoth(const State<D>& state, const Watched& watched, const Add& add)
{
  const Extremes<D> found = extremesOf(state, watched.field, watched.body);
  add("largest", found.largest);
  add("smallest", found.smallest);
}

/// Measures the fields and adds their columns to the sample.
template <int D>
void sampleExtremes(State<D>& state, const std::vector<Watched>& watched)
{
  if (!state.clock.observing)
    return;
  for (const Watched& w : watched)
    forBoth(state, w,
            [&](const std::string& what, const Extreme<D>& extreme)
            {
              const std::string column = w.name + "." + what;
              state.sample.row.emplace_back(column, extreme.value);
              for (int d = 0; d < D; ++d)
                state.sample.row.emplace_back(column + "_" + "xyz"[d], extreme.where[d]);
            });
}

template <int D>
void reportExtremes(const State<D>& state, const std::vector<Watched>& watched, nlohmann::json& summary)
{
  for (const Watched& w : watched)
  {
    nlohmann::json& entry = summary["extremes"][w.name];
    entry["field"] = w.field;
    forBoth(state, w,
            [&](const std::string& what, const Extreme<D>& extreme)
            {
              entry[what] = extreme.value;
              entry[what + "_position"] = std::vector<double>(extreme.where.c, extreme.where.c + D);
            });
  }
}

/// Numbers the pieces and adds their columns to the sample.
template <int D>
void samplePieces(State<D>& state)
{
  if (!state.clock.observing)
    return;
  numberPieces(state);
  const std::vector<Piece<D>> pieces = piecesOf(state);
  state.sample.row.emplace_back("pieces", static_cast<double>(pieces.size()));
  state.sample.row.emplace_back("largest_piece", pieces.empty() ? 0.0 : pieces.front().mass);
}

/// At most so many pieces are listed.
constexpr std::size_t mostPieces = 20;

template <int D>
void reportPieces(const State<D>& state, nlohmann::json& summary)
{
  const std::vector<Piece<D>> pieces = piecesOf(state);
  if (pieces.empty()) // before the first step
    return;
  double all = 0.0;
  for (const Piece<D>& piece : pieces)
    all += piece.mass;
  nlohmann::json& entry = summary["pieces"];
  entry["number"] = pieces.size();
  entry["largest"] = nlohmann::json::array();
  for (std::size_t k = 0; k < std::min(pieces.size(), mostPieces); ++k)
  {
    nlohmann::json one{{"mass", pieces[k].mass},
                       {"fraction", pieces[k].mass / all},
                       {"centre", std::vector<double>(pieces[k].centre.c, pieces[k].centre.c + D)},
                       {"bodies", nlohmann::json::array()}};
    for (const int body : pieces[k].bodies)
      one["bodies"].push_back(state.bodies.info[body].name);
    entry["largest"].push_back(one);
  }
  const std::string number = pieces.size() == 1 ? "1 piece" : std::to_string(pieces.size()) + " pieces";
  summary["answers"].push_back(
      "pieces: at the end there " + std::string(pieces.size() == 1 ? "is " : "are ") + number +
      "; the largest has " + formatShort(100.0 * pieces.front().mass / all) + " % of the mass");
}

/// Adds what finds pieces.
template <int D>
void addPieces(Effect<D>& effect)
{
  effect.adds.push_back(
      {pieceField, 1, "", "number of the piece, 0 for the largest; -1: not known yet", true});
  effect.call(Stage::Observe, "pieces of bodies", {quantity::particleStress}, {}, {},
              [](State<D>& state) { samplePieces(state); });
}

template <int D>
Effect<D> make(const Teuchos::ParameterList& scene)
{
  const Teuchos::ParameterList& list = scene.sublist("Measure");
  const bool measuresSides = list.isSublist("Side Energy");
  double part = 1.0;
  if constexpr (D == 2)
    part = measuresSides ? list.sublist("Side Energy").get<double>("Part") : 1.0;
  const bool measuresStress = list.isSublist("Stress Alternation");
  const bool measuresShapes = D == 3 && list.isSublist("Front Shape");
  const auto sides = std::make_shared<Sides<D>>();
  const auto circles = std::make_shared<std::vector<Circle>>();
  const auto watched = std::make_shared<std::vector<Watched>>();
  const bool findsPieces = list.isSublist("Pieces");
  Effect<D> effect;
  effect.name = "Measure";
  if (findsPieces)
    addPieces(effect);
  if (list.isSublist("Extremes"))
    effect.call(Stage::Observe, "extremes of fields",
                {ifWritten(quantity::particleStress), ifWritten(quantity::particleVelocity),
                 ifWritten(quantity::temperature)},
                {}, {}, [watched](State<D>& state) { sampleExtremes(state, *watched); });
  effect.atStart = [=, requests = list.isSublist("Extremes") ? list.sublist("Extremes")
                                                             : Teuchos::ParameterList()](State<D>& state)
  {
    *watched = readExtremes(state, requests);
    if (findsPieces)
      Kokkos::deep_copy(state.particles.integer(pieceField), -1);
    if (measuresSides)
      begin(state, part, *sides);
    if constexpr (D == 3)
      for (std::size_t f = 0; measuresShapes && f < state.cracks.fronts.size(); ++f)
        circles->push_back(circleOf(state.cracks.fronts[f]));
  };
  effect.report = [=](const State<D>& state, nlohmann::json& summary)
  {
    reportSides(state, *sides, summary);
    reportExtremes(state, *watched, summary);
    if (findsPieces)
      reportPieces(state, summary);
    if (measuresStress && state.clock.step > 0) // before, particles have no nodes
      reportStress(state, summary);
    if constexpr (D == 3)
      reportShapes(state, *circles, summary);
  };
  return effect;
}

} // namespace

EffectEntry measureEntry() { return {section(), {}, make<2>, make<3>, true}; }

} // namespace Rhegma::measure
