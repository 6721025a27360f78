#include "cohesive_faces/LawsOfCracks.hpp"

#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "geometry/NearestOnSimplex.hpp"
#include "material/MaterialTable.hpp"
#include "state/Subdomain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Rhegma::cohesive_faces
{

namespace
{

/// Stiffness of undamaged faces, in units of modulus over cell size: that of contact, which the step of waves
/// bears as it is; in equilibrium nothing but the rounding of forces limits it.
constexpr double stiffnessInMotion = 2.0, stiffnessAtRest = 20.0;

/// Largest part of the toughness that is taken when the strength is reached, unless a stiffness is given.
constexpr double elasticPart = 0.1;

/// Cells that the process zone needs (Turon, Davila, Camanho and Costa, 2007).
constexpr double fewestCells = 3.0;

double given(const Teuchos::ParameterList& list, const char* name, double otherwise)
{
  return list.isType<double>(name) ? list.get<double>(name) : otherwise;
}

/// Toughness and strength of opening (0) and sliding (1).
struct Modes
{
  double energy[2], strength[2];
  explicit Modes(const Teuchos::ParameterList& list)
  {
    energy[0] = list.get<double>("Toughness");
    energy[1] = given(list, "Toughness II", energy[0]);
    strength[0] = list.get<double>("Strength");
    strength[1] = given(list, "Shear Strength", strength[0]);
  }
};

/// Marks the materials of particles within a distance of each crack. \return a row of materials a crack
template <int D>
std::vector<double> nearbyMaterials(const State<D>& state, double reach)
{
  const std::size_t materials = state.materials.properties.size();
  std::vector<double> near(state.cracks.cracks.size() * materials, 0.0);
  const auto vertex = onHost(state.cracks.vertex);
  const auto simplex = onHost(state.cracks.simplex);
  const auto crackOf = onHost(state.cracks.crackOf);
  const auto position = onHost(state.particles.template real<D>(fields::position));
  const auto material = onHost(state.particles.integer(fields::material));
  for (std::size_t s = 0; s < simplex.extent(0); ++s)
  {
    Vector<D> corner[D], low, high;
    for (int i = 0; i < D; ++i)
      for (int d = 0; d < D; ++d)
      {
        const double x = corner[i][d] = vertex(simplex(s, i), d);
        low[d] = i == 0 ? x : std::min(low[d], x);
        high[d] = i == 0 ? x : std::max(high[d], x);
      }
    for (int p = 0; p < state.particles.size(); ++p)
    {
      Vector<D> x;
      bool inReach = true;
      for (int d = 0; d < D; ++d)
      {
        x[d] = position(p, d);
        inReach = inReach && x[d] >= low[d] - reach && x[d] <= high[d] + reach;
      }
      double& one = near[crackOf(s) * materials + material(p)];
      if (inReach && one == 0.0 && Geometry::distanceToSimplex<D>(corner, x) <= reach)
        one = 1.0;
    }
  }
  maxParts(state, near.data(), static_cast<int>(near.size()));
  return near;
}

} // namespace

TractionLaw readLaw(const Teuchos::ParameterList& list, double modulus, double cell, bool equilibrium)
{
  const Modes modes(list);
  const std::string name = list.get<std::string>("Law");
  TractionLaw law;
  law.holds = true;
  law.shape = name == "Exponential" ? Shape::Exponential : Shape::Trapezoidal;
  law.plateau = name == "Trapezoidal" ? given(list, "Plateau", 0.5) : 0.0;
  law.exponent = list.get<double>("Exponent");
  const double ratio = modes.strength[1] / modes.strength[0];
  if (law.shape == Shape::Exponential)
    law.normal = std::exp(2.0) * modes.strength[0] * modes.strength[0] / modes.energy[0];
  else
    law.normal =
        given(list, "Initial Stiffness",
              std::max((equilibrium ? stiffnessAtRest : stiffnessInMotion) * modulus / cell,
                       modes.strength[0] * modes.strength[0] / (2.0 * elasticPart * modes.energy[0])));
  // Damage then grows alike in all modes (Turon, Camanho, Costa and Renart, Compos. Struct. 92 (2010) 1857).
  law.shear = ratio * ratio * modes.energy[0] / modes.energy[1] * law.normal;
  for (int mode = 0; mode < 2; ++mode)
  {
    law.energy[mode] = modes.energy[mode];
    law.elastic[mode] =
        modes.strength[mode] * modes.strength[mode] / (2.0 * (mode == 0 ? law.normal : law.shear));
  }
  return law;
}

template <int D>
std::vector<AtCrack> materialsAtCracks(const State<D>& state)
{
  const std::vector<Properties>& materials = state.materials.properties;
  const std::vector<double> near = nearbyMaterials(state, 2.0 * state.mesh.grid.spacing);
  std::vector<AtCrack> all(state.cracks.cracks.size());
  for (std::size_t c = 0; c < all.size(); ++c)
  {
    const auto row = near.begin() + c * materials.size();
    const bool any = std::any_of(row, row + materials.size(), [](double one) { return one > 0.0; });
    all[c].modulus = all[c].effective = std::numeric_limits<double>::infinity();
    for (std::size_t m = 0; m < materials.size(); ++m)
      if (!any || row[m] > 0.0)
      {
        const Elasticity e = elasticity(materials[m]);
        all[c].modulus = std::min(all[c].modulus, e.constrainedModulus);
        all[c].effective = std::min(all[c].effective, e.effectiveModulus);
      }
  }
  return all;
}

ProcessZone processZone(const Teuchos::ParameterList& list, double effective)
{
  const Modes modes(list);
  return {effective * modes.energy[0] / (modes.strength[0] * modes.strength[0]),
          effective * modes.energy[1] / (modes.strength[1] * modes.strength[1])};
}

std::string warningOfZone(const std::string& name, const ProcessZone& zone, double cell)
{
  const double shorter = std::min(zone.opening, zone.sliding), cells = shorter / cell;
  if (cells >= fewestCells)
    return {};
  return "Cohesive Faces > " + name + ": the process zone, about " + readableLength(shorter) + " in mode " +
         (zone.opening <= zone.sliding ? "I" : "II") + ", has " + formatShort(cells) +
         " cells, and needs 3: forces rise and fall as it passes from cell to cell; use cells of " +
         readableLength(shorter / fewestCells) + ", or a " +
         (zone.opening <= zone.sliding ? "Strength" : "Shear Strength") + " that is " +
         formatShort(std::sqrt(fewestCells / cells)) + " times smaller";
}

std::string warningOfOverlap(const std::string& name, const TractionLaw& law, double modulus, double cell,
                             bool moves)
{
  const double times = stiffnessInMotion * modulus / (cell * law.normal);
  if (!law.resistsOverlap || !(times > 1.0))
    return {};
  return "Cohesive Faces > " + name +
         ": without Contact, faces that press on each other resist by the initial stiffness of " +
         formatShort(law.normal) + " Pa/m: they overlap by " + readableLength(1e6 / law.normal) +
         " per MPa, " + formatShort(times) + " times as much as in contact; " +
         (moves ? "add Contact, if they close" : "write a larger Initial Stiffness, if they close");
}

template <int D>
double timeStepLimit(const State<D>& state, const std::vector<TractionLaw>& laws)
{
  double fastest = 0.0, lightest = std::numeric_limits<double>::infinity(), stiffest = 0.0;
  for (const Properties& p : state.materials.properties)
  {
    fastest = std::max(fastest, std::sqrt(elasticity(p).constrainedModulus / p.density));
    lightest = std::min(lightest, p.density);
  }
  for (const TractionLaw& law : laws)
    if (law.holds)
      stiffest = std::max(stiffest, law.stiffest());
  const double h = state.mesh.stepSpacing();
  const double square = 4.0 * D * fastest * fastest / (h * h) + 4.0 * stiffest / (lightest * h);
  return stiffest > 0.0 ? 0.9 * 2.0 / std::sqrt(square) : std::numeric_limits<double>::infinity();
}

template std::vector<AtCrack> materialsAtCracks(const State<2>&);
template std::vector<AtCrack> materialsAtCracks(const State<3>&);
template double timeStepLimit(const State<2>&, const std::vector<TractionLaw>&);
template double timeStepLimit(const State<3>&, const std::vector<TractionLaw>&);

} // namespace Rhegma::cohesive_faces
