#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "plausibility/Judges.hpp"

#include <cmath>

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

/// Every number of a list and its sublists.
void lookThrough(const ParameterList& list, const std::string& path, Messages& messages)
{
  for (auto entry = list.begin(); entry != list.end(); ++entry)
  {
    const std::string& name = list.name(entry);
    const std::string where = path.empty() ? name : path + " > " + name;
    if (list.isSublist(name))
    {
      if (where != "Reference")
        lookThrough(list.sublist(name), where, messages);
      continue;
    }
    std::vector<double> values;
    if (list.isType<double>(name))
      values = {list.get<double>(name)};
    else if (list.isType<Teuchos::Array<double>>(name))
      values = list.get<Teuchos::Array<double>>(name).toVector();
    for (const double value : values)
      if (isBeyond(value))
      {
        messages.push_back(where + " is " + formatReal(value) + ", and no quantity in SI units is that " +
                           (std::fabs(value) > largestNumber ? "large" : "small") + "; check the exponent");
        break;
      }
  }
}

/// Densities of solids that bear loads reach from 10 (foam) to 22 590 kg/m3 (osmium).
template <int D>
void judgeDensities(const JudgedScene<D>& judged, Messages& messages)
{
  constexpr double lightest = 5.0, heaviest = 25e3;
  const MaterialSet& materials = judged.state.materials;
  for (std::size_t m = 0; m < materials.properties.size(); ++m)
    if (const double density = materials.properties[m].density; density < lightest || density > heaviest)
      messages.push_back(
          "Materials > " + materials.names[m] + " > Density is " + formatReal(density) + " kg/m3, " +
          (density < lightest ? "less than of foams (10)" : "more than of any solid (osmium 22 590)") +
          "; densities are in kg/m3, and 1 g/cm3 is 1000 kg/m3");
}

/// A thickness of 1 m is also the default, by which forces are per metre.
template <int D>
void judgeThicknessOfPlane(const JudgedScene<D>& judged, Messages& messages)
{
  const double thickness = judged.state.method.thickness;
  double longest = 0.0;
  for (const BodyMeasure<D>& body : judged.bodies)
    longest = std::max(longest, body.longest);
  if (D == 3 || thickness == 1.0 || (thickness <= 1e3 * longest && thickness >= 1e-5 * longest))
    return;
  messages.push_back("Domain > Thickness is " + readableLength(thickness) + ", " +
                     formatShort(thickness / longest) + " times the largest body's " +
                     readableLength(longest) + "; it is in metres");
}

} // namespace

template <int D>
Messages judgeNumbers(const JudgedScene<D>& judged)
{
  Messages messages;
  lookThrough(judged.scene, "", messages);
  judgeDensities(judged, messages);
  judgeThicknessOfPlane(judged, messages);
  return messages;
}

template Messages judgeNumbers(const JudgedScene<2>&);
template Messages judgeNumbers(const JudgedScene<3>&);

} // namespace Rhegma
