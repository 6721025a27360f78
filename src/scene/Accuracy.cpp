#include "scene/Accuracy.hpp"

#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "scene/SceneBodies.hpp"
#include "scene/SceneParts.hpp"
#include "scene/Validation.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <stdexcept>
#include <string>

namespace Rhegma
{

namespace
{

using Teuchos::ParameterList;

/// Levels below the largest cells that a tree may have.
constexpr int mostLevels = 6;

/// How many times smaller cells at fronts are where faces of cracks are loaded: under pressure G is up to 17
/// % too low over the number of cells in a crack (docs/explanation/verification/cracks-2d.md), elsewhere it
/// is off by up to 9 %.
constexpr double loadedFaces = 2.0;

/// The error that scenes in 2D with linear functions keep: where a body or a crack does not lie on rows of
/// cells, G is wrong by up to 2.3 % in cells of any size (docs/how-to/accuracy.md).
constexpr double linearFunctions = 0.03;

/// Cells in the inner radius of a contour that keep it out of the cells of the front.
constexpr double perContour = 2.0;

/// What a cell size that was copied from a message may be too large by: it has four digits.
constexpr double roundingOfText = 1e-3;

/// Cells of a lattice whose nodes an int numbers.
constexpr double mostCells = 2e9;

CellNeeds needsOf(ParameterList& scene, const SceneSchema& schema, std::vector<SceneError>& errors)
{
  CellNeeds needs;
  {
    SceneParts parts(schema, scene);
    for (const auto& [section, effect] : schema.effects())
      if (effect.cells.addNeeds && scene.isSublist(section))
        effect.cells.addNeeds(parts.of(section), needs, errors);
  }
  const ParameterList& time = scene.sublist("Time");
  if (time.isType<std::string>("Update Scheme") && time.get<std::string>("Update Scheme") != "MUSL")
    needs.equal = true; // substeps need MUSL
  return needs;
}

/// "is known for A and for B, and the scene has neither".
std::string nothingMessage(const SceneSchema& schema)
{
  std::string known;
  int count = 0;
  for (const auto& entry : schema.effects())
    if (!entry.second.cells.subject.empty())
      known += (count++ > 0 ? " and for " : "") + entry.second.cells.subject;
  if (count == 0)
    return "is supported by none of the effects in this program; write Domain > Cell Size";
  return "is supported for " + known + ", but the scene has " + (count > 1 ? "neither" : "none") +
         "; write Domain > Cell Size";
}

/// Refuses a cell size of which the domain would have too many cells, with the reason for that size.
void refuseTiny(double cell, const ParameterList& scene, const CellNeeds& needs, const AccuracyRule& rule)
{
  const ParameterList& domain = scene.sublist("Domain");
  const auto& lower = domain.get<Teuchos::Array<double>>("Lower Corner");
  const auto& upper = domain.get<Teuchos::Array<double>>("Upper Corner");
  double count = 1.0;
  for (int d = 0; d < std::min(lower.size(), upper.size()); ++d)
    count *= std::max(1.0, (upper[d] - lower[d]) / cell);
  if (count <= mostCells)
    return;
  const double radius = std::min(needs.source, needs.atRest);
  const double length = std::min({needs.across, needs.atFronts, needs.clear});
  const bool crack = length <= radius;
  throw std::invalid_argument(
      std::string("is ") + rule.name + ", for which " +
      (crack ? needs.shortestAcross +
                   (length == needs.clear ? ", with what is next to it at a distance of "
                                          : ", with a length of ") +
                   formatReal(length)
             : needs.smallestSource + ", with a radius of " + formatReal(radius)) +
      " m, needs cells of " + formatReal(cell) +
      " m, too many for this domain; check that length, or write Domain > Cell Size");
}

double fitted(const ParameterList& scene, double cell)
{
  const auto& corner = scene.sublist("Domain").get<Teuchos::Array<double>>("Lower Corner");
  return dimensionOf(scene) == 3 ? SceneBodies<3>(scene).fit(cell, corner)
                                 : SceneBodies<2>(scene).fit(cell, corner);
}

void refine(ParameterList& scene, const SceneSchema& schema, const FrontRefinement& refinement,
            const AccuracyRule& rule)
{
  if (refinement.levels > mostLevels)
    throw std::invalid_argument(
        std::string("is ") + rule.name + ", for which Domain > Cell Size would need " +
        std::to_string(refinement.levels) + " refinement levels at fronts, and there are only " +
        std::to_string(mostLevels) + "; write a smaller Cell Size, or leave it out");
  for (const auto& entry : schema.effects())
    if (entry.second.cells.refine)
      entry.second.cells.refine(scene, refinement);
}

bool hasTimeSteps(const ParameterList& scene)
{
  const ParameterList& time = scene.sublist("Time");
  return !time.isType<std::string>("Analysis") || time.get<std::string>("Analysis") == "Dynamic";
}

/// Size of the cells at fronts that do not run [m].
double cellAtFronts(const CellNeeds& needs, const AccuracyRule& rule)
{
  if (needs.ahead < CellNeeds::none)
    return std::min({needs.ahead / (rule.perFront * (needs.facesLoaded ? loadedFaces : 1.0)),
                     needs.clear / rule.perClear, needs.contour / perContour});
  // Four fifths of the error are for the position of the front.
  return 1.6 * rule.error * needs.atFronts;
}

/// Size of the cells far from fronts, as far as cracks ask for one [m].
double cellOfParts(const CellNeeds& needs, const AccuracyRule& rule, bool moves)
{
  if (needs.running)
    return needs.across / 16.0;
  const bool graded = (needs.rests || !moves) && !needs.heat && needs.thickness < CellNeeds::none;
  return graded ? needs.thickness / rule.perThickness : needs.across / rule.perLigament;
}

/// Levels of cells that the sections of the scene make around fronts, up to this number of their edge
/// lengths; at 0 anywhere. Also a scene for which cells have been chosen before has some.
int ownLevels(const ParameterList& scene, const SceneSchema& schema, double around)
{
  int levels = 0;
  for (const auto& [section, effect] : schema.effects())
    if (effect.cells.levels && scene.isSublist(section))
      levels = std::max(levels, effect.cells.levels(scene.sublist(section), around));
  return levels;
}

/// "is 1 %, which asks for cells of at most 1e-3 m".
std::string asksFor(const AccuracyRule& rule, double most)
{
  return std::string("is ") + rule.name + ", which asks for cells of at most " + formatShort(most) + " m";
}

/// Refuses a size of cells that is too large for the accuracy far from fronts and at sources of heat, where
/// none are refined.
/// \param most size of these cells [m]
void refuseLarge(const ParameterList& scene, double most, const AccuracyRule& rule)
{
  const double given = scene.sublist("Domain").get<double>("Cell Size");
  if (given > (1.0 + roundingOfText) * most)
    throw std::invalid_argument(asksFor(rule, most) + " everywhere, but Domain > Cell Size is " +
                                formatShort(given) + " m; write a smaller Cell Size, or leave it out");
}

/// Refuses cells that are too large at fronts, where none are chosen there.
/// \param around fronts where refined cells count, in their edge lengths \param most size of the cells [m]
void refuseLargeAtFronts(const ParameterList& scene, const SceneSchema& schema, double around, double most,
                         const AccuracyRule& rule)
{
  const double given = scene.sublist("Domain").get<double>("Cell Size");
  const int levels = ownLevels(scene, schema, around);
  const double smallest = std::ldexp(given, -levels);
  if (smallest <= (1.0 + roundingOfText) * most)
    return;
  throw std::invalid_argument(
      asksFor(rule, most) + " at fronts, but Domain > Cell Size is " + formatShort(given) + " m, and " +
      (levels > 0 ? "its smallest refined cells, " + formatReal(around) +
                        " or more of them around fronts, are " + formatShort(smallest) +
                        " m; write more levels of refinement or a smaller Cell Size, or leave both out"
       : ownLevels(scene, schema, 0.0) > 0
           ? "its refined cells do not have " + formatReal(around) +
                 " of each size around fronts, which is needed; write a smaller Cell Size, more cells around "
                 "fronts, or leave both out"
           : std::string("the cells of this scene cannot be refined; write a smaller Cell Size, or "
                         "leave it out")));
}

/// Size of the cells, and levels below it at fronts.
void choose(ParameterList& scene, const ParameterList& read, const SceneSchema& schema,
            const CellNeeds& needs, const AccuracyRule& rule)
{
  if (needs.running && !rule.running)
    throw std::invalid_argument(std::string("is ") + rule.name +
                                ", which has not been verified for running cracks; write 3 %");
  if (needs.ahead < CellNeeds::none && rule.error < linearFunctions &&
      read.sublist("Domain").get<std::string>("Shape Functions") == "Linear")
    throw std::invalid_argument(std::string("is ") + rule.name +
                                ", but with linear functions G of cracks off the rows of cells is wrong by "
                                "up to 2.3 %; write Domain > Shape Functions = GIMP, or 3 %");
  const bool moves = hasTimeSteps(read), atRest = needs.fronts() && !needs.running;
  double cell = std::min(needs.source / rule.perSource, needs.atRest / rule.perResting);
  if (needs.fronts())
    cell = std::min(cell, cellOfParts(needs, rule, moves));
  if (!std::isfinite(cell))
    throw std::invalid_argument(nothingMessage(schema));
  const double atFront = cellAtFronts(needs, rule);
  const double around = needs.ahead < CellNeeds::none && !needs.running ? rule.aroundFront : 3.0;
  const bool mayRefine =
      atRest && !needs.equal && (moves || needs.ahead < CellNeeds::none || dimensionOf(read) == 3) &&
      std::any_of(schema.effects().begin(), schema.effects().end(),
                  [](const auto& entry) { return static_cast<bool>(entry.second.cells.refine); });
  double least = atRest ? atFront : cell; // of the smallest cells
  std::vector<RefinedBox> boxes;
  for (const NarrowGap& gap : mayRefine ? needs.narrow : std::vector<NarrowGap>{})
  {
    boxes.push_back({gap.lower, gap.upper, gap.width / rule.perThickness});
    least = std::min(least, boxes.back().cell);
  }
  const double far = cell;
  cell = std::min(cell, mayRefine ? least * (1 << mostLevels) : least);
  ParameterList& domain = scene.sublist("Domain");
  if (domain.isType<double>("Cell Size"))
  {
    const bool refined = mayRefine || ownLevels(read, schema, 0.0) > 0;
    refuseLarge(read, refined ? far : std::min(far, least), rule);
    if (!mayRefine)
      refuseLargeAtFronts(read, schema, around, least, rule);
    cell = domain.get<double>("Cell Size");
  }
  else
  {
    refuseTiny(cell, read, needs, rule);
    domain.set("Cell Size", cell = fitted(read, cell));
  }
  const int levels = mayRefine ? static_cast<int>(std::ceil(std::log2(cell / least) - 1e-6)) : 0;
  if (levels > 0)
    refine(scene, schema, {levels, around, moves, boxes}, rule);
}

} // namespace

const std::vector<AccuracyRule>& accuracyRules()
{
  static const std::vector<AccuracyRule> rules = {
      {"10 %", 0.1, 3.0, 4.0, 6.0, 4.0, 5.0, 1.0, 2.0, true},
      {"3 %", 0.03, 5.0, 6.0, 12.0, 4.0, 6.0, 2.0, 3.0, true},
      {"1 %", 0.01, 8.0, 14.0, 24.0, 5.0, 8.0, 3.0, 5.0, false},
      {"0.3 %", 0.003, 16.0, 26.0, 80.0, 12.0, 16.0, 6.0, 10.0, false}};
  return rules;
}

void chooseCells(ParameterList& scene, const SceneSchema& schema, std::vector<SceneError>& errors)
{
  if (!scene.isSublist("Domain") || !scene.sublist("Domain").isType<std::string>("Accuracy"))
    return;
  const std::string wanted = scene.sublist("Domain").get<std::string>("Accuracy");
  const std::vector<AccuracyRule>& rules = accuracyRules();
  const auto rule =
      std::find_if(rules.begin(), rules.end(), [&](const AccuracyRule& r) { return r.name == wanted; });
  if (rule == rules.end())
    return; // validation lists the allowed values
  ParameterList read(scene);
  std::vector<SceneError> ignored;
  Validation(dimensionOf(read), ignored).check(read, schema.root(), "");
  if (!ignored.empty())
    return; // reported again by the cross checks
  try
  {
    std::vector<SceneError> found;
    const CellNeeds needs = needsOf(read, schema, found);
    errors.insert(errors.end(), found.begin(), found.end());
    if (found.empty())
      choose(scene, read, schema, needs, *rule);
  }
  catch (const std::exception& problem)
  {
    errors.push_back({"Domain > Accuracy", problem.what()});
  }
}

} // namespace Rhegma
