#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "base/ShortNumber.hpp"
#include "plausibility/CrackExtent.hpp"
#include "plausibility/HistoryRange.hpp"
#include "plausibility/Judges.hpp"
#include "transfer/LocalSpacing.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace Rhegma
{

namespace
{

using Teuchos::ParameterList;

/// No quantity in SI units is larger or, unless zero, smaller: power densities reach 1e20 W/m3 at crack tips,
/// burn coefficients fall to 1e-20 m/s/Pa^n.
constexpr double largestNumber = 1e24, smallestNumber = 1e-30;

bool isBeyond(double value)
{
  return std::fabs(value) > largestNumber || (value != 0.0 && std::fabs(value) < smallestNumber);
}

/// The first number of an entry that no quantity has; null: there is none.
const double* numberBeyond(const Teuchos::ParameterEntry& entry)
{
  const double *first = nullptr, *last = nullptr;
  if (entry.isType<double>())
    last = (first = &Teuchos::any_cast<double>(entry.getAny(false))) + 1;
  else if (entry.isType<Teuchos::Array<double>>())
  {
    const auto& all = Teuchos::any_cast<Teuchos::Array<double>>(entry.getAny(false));
    last = (first = all.getRawPtr()) + all.size();
  }
  const double* const found = std::find_if(first, last, isBeyond);
  return found == last ? nullptr : found;
}

/// Every number of a list and its sublists. \param above names of the lists around it
void lookThrough(const ParameterList& list, std::vector<const std::string*>& above, Messages& messages)
{
  for (const auto& named : list)
  {
    const std::string& name = named.first;
    const Teuchos::ParameterEntry& entry = named.second;
    above.push_back(&name);
    if (entry.isList())
    {
      if (above.size() > 1 || name != "Reference")
        lookThrough(Teuchos::any_cast<ParameterList>(entry.getAny(false)), above, messages);
    }
    else if (const double* const value = numberBeyond(entry); value != nullptr)
    {
      std::string where;
      for (const std::string* part : above)
        where += (where.empty() ? "" : " > ") + *part;
      messages.push_back(where + " is " + formatReal(*value) +
                         ", an implausible number: no quantity in SI units is that " +
                         (std::fabs(*value) > largestNumber ? "large" : "small") + "; check the exponent");
    }
    above.pop_back();
  }
}

/// Densities of solids that bear loads reach from 10 (foam) to 22 590 kg/m3 (osmium); a gas may have any.
template <int D>
void judgeDensities(const JudgedScene<D>& judged, Messages& messages)
{
  constexpr double lightest = 5.0, heaviest = 25e3;
  const MaterialSet& materials = judged.state.materials;
  for (std::size_t m = 0; m < materials.properties.size(); ++m)
    if (const double density = materials.properties[m].density;
        materials.properties[m].mu > 0.0 && (density < lightest || density > heaviest))
      messages.push_back(
          "Materials > " + materials.names[m] + " > Density is " + formatReal(density) + " kg/m3, " +
          (density < lightest ? "less than of foams (10)" : "more than of any solid (osmium 22 590)") +
          "; densities are in kg/m3, and 1 g/cm3 is 1000 kg/m3");
}

/// A thickness of 1 m is also the default, by which forces are per metre. Plane stress is that of a thin
/// body.
template <int D>
void judgeThicknessOfPlane(const JudgedScene<D>& judged, Messages& messages)
{
  constexpr double thick = 2.0, thickest = 1e3, thinnest = 1e-5;
  const double thickness = judged.state.method.thickness;
  double longest = 0.0;
  for (const BodyMeasure<D>& body : judged.bodies)
    longest = std::max(longest, body.longest);
  if (D == 3 || judged.state.method.axisymmetric || thickness == 1.0 || isBeyond(thickness) ||
      !(longest > 0.0))
    return;
  const double ratio = thickness / longest;
  const bool stress = judged.state.method.plane == Plane::Stress;
  if (ratio >= thinnest && ratio <= (stress ? thick : thickest))
    return;
  messages.push_back(
      "Domain > Thickness is " + readableLength(thickness) + ", " + formatShort(ratio) +
      " times the largest body's " + readableLength(longest) +
      (stress && ratio > thick ? "; plane stress assumes a body thinner than it is wide; " : "; ") +
      "it is in metres, and 1 mm is 0.001 m");
}

/// Forces in a plane scene that does not say how thick its bodies are.
template <int D>
void judgeForcesOnAMetre(const JudgedScene<D>& judged, Messages& messages)
{
  if (D == 3 || judged.state.method.axisymmetric || !judged.state.method.mechanics ||
      !judged.scene.isSublist("Boundaries") ||
      !judged.scene.sublist("Domain").getEntry("Thickness").isDefault())
    return;
  const ParameterList& section = judged.scene.sublist("Boundaries");
  const double end = judged.scene.sublist("Time").template get<double>("Final Time");
  for (const std::string& name : sublistNames(section))
  {
    const ParameterList& list = section.sublist(name);
    if (!list.isParameter("Force"))
      continue;
    const double factor = rangeOf(list.get<std::string>("History"), end).largest;
    const std::string force = formatShort(norm(readVector<D>(list, "Force")) * factor);
    messages.push_back("Domain > Thickness is not given and is 1 m, so that the force of Boundaries > " +
                       name + ", " + force + " N at most, acts on a body 1 m thick, as all forces of the " +
                       "scene do; write the thickness of the bodies in metres, or 1 if " + force +
                       " N per metre of it are meant");
    return;
  }
}

/// A yield stress that the bonds of no solid bear: a tenth of Young's modulus (Frenkel).
template <int D>
void judgeYieldStress(const JudgedScene<D>& judged, Messages& messages)
{
  constexpr double most = 0.1;
  std::set<std::string> said;
  for (const BodyMeasure<D>& body : judged.bodies)
    if (body.yield > most * body.moduli.young && said.insert(body.material).second)
      messages.push_back(
          "Materials > " + body.material + " > Yield Stress is " + formatShort(body.yield) + " Pa, " +
          formatShort(body.yield / body.moduli.young) +
          " of Young's modulus: no solid bears more than a tenth of it; it is in Pa, and 1 MPa is "
          "1e6 Pa");
}

/// A yield stress that a scene without cracks gives to a law that does not yield: only warnings of cracks
/// compare stresses with it.
template <int D>
void judgeUnusedYield(const JudgedScene<D>& judged, Messages& messages)
{
  std::set<std::string> said;
  for (const BodyMeasure<D>& body : judged.bodies)
  {
    if (!(body.linear && body.yield > 0.0) || !judged.state.cracks.cracks.empty() ||
        !said.insert(body.material).second)
      continue;
    const Teuchos::ParameterList& list = judged.scene.sublist("Materials").sublist(body.material);
    if (list.isParameter("Yield Stress") && !list.getEntry("Yield Stress").isDefault())
      messages.push_back(
          "Materials > " + body.material + " > Yield Stress is " + formatShort(body.yield) +
          " Pa, but its Model, Linear Elastic, does not yield; write Model = J2 Plastic, or leave "
          "it out");
  }
}

/// Edge of the cells of most of a body [m]: the median at 4^D points of its bounding box, so that cells
/// refined next to fronts do not count.
template <int D>
double usualSpacing(const State<D>& state, const BodyMeasure<D>& body)
{
  constexpr int count = 4;
  std::vector<double> edges;
  int points = 1;
  for (int d = 0; d < D; ++d)
    points *= count;
  for (int k = 0; k < points; ++k)
  {
    Vector<D> x;
    for (int d = 0, rest = k; d < D; ++d, rest /= count)
      x[d] = body.lower[d] + (0.5 + rest % count) / count * (body.upper[d] - body.lower[d]);
    edges.push_back(spacingAt(state, x));
  }
  std::nth_element(edges.begin(), edges.begin() + points / 2, edges.end());
  return edges[points / 2];
}

/// Bodies with cracks that hardly change their volume: cells lock, which makes parts that bend too stiff.
template <int D>
void judgeLocking(const JudgedScene<D>& judged, Messages& messages)
{
  // A double cantilever beam in plane strain, 4 to 16 cells an arm, Poisson ratios of 0.3 to 0.495: G is too
  // small by 16 % times K / G over the square of the number of cells.
  constexpr double measured = 0.16, most = 0.02, ofModuli = 8.0; // 0.44 of Poisson's ratio
  if (judged.state.cracks.cracks.empty() || (D == 2 && judged.state.method.plane == Plane::Stress))
    return;
  std::set<std::string> said;
  for (const BodyMeasure<D>& body : judged.bodies)
  {
    const Elasticity& e = body.moduli;
    const double ratio = (e.lambda + 2.0 / 3.0 * e.shear) / e.shear;
    const double cells = 0.5 * shortestAcrossFronts(judged.state, body) / usualSpacing(judged.state, body);
    const double error = measured * ratio / (cells * cells);
    if (!(ratio > ofModuli) || !(error > most) || !said.insert(body.material).second)
      continue;
    messages.push_back(
        "Materials > " + body.material + ": its bulk modulus is " + formatShort(ratio) +
        " times its shear modulus (Poisson ratio " + formatShort(e.poisson) +
        "), and too few cells make bending too stiff: parts of Bodies > " + body.name +
        " half as thick as it, " + formatShort(cells) + " cells, bend by some " +
        formatShort(std::round(100.0 * error / (1.0 + error))) +
        " % too little, so that G is too small by as much under given forces and too large under "
        "given displacements; use " +
        formatShort(std::ceil(cells * std::sqrt(error / most))) +
        " cells or more for half of the thickness, or plane stress if the body is thin");
  }
}

} // namespace

Messages judgeNumbers(const ParameterList& scene)
{
  Messages messages;
  std::vector<const std::string*> above;
  lookThrough(scene, above, messages);
  return messages;
}

template <int D>
Messages judgeQuantities(const JudgedScene<D>& judged)
{
  Messages messages;
  judgeDensities(judged, messages);
  judgeThicknessOfPlane(judged, messages);
  judgeForcesOnAMetre(judged, messages);
  judgeYieldStress(judged, messages);
  judgeUnusedYield(judged, messages);
  judgeLocking(judged, messages);
  return messages;
}

template Messages judgeQuantities(const JudgedScene<2>&);
template Messages judgeQuantities(const JudgedScene<3>&);

} // namespace Rhegma
