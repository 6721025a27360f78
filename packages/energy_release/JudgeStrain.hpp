#pragma once
/// Whether strains are small enough for stress intensities (docs/reference/warnings-of-cracks-and-runs.md).

#include "base/ShortNumber.hpp"
#include "plausibility/LoadEstimate.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace Rhegma::energy_release
{

/// K and G = K^2 / E' are those of small strains: at 1 % they are off by as much.
constexpr double smallStrain = 0.01;

/// Follows the strain of bodies of a linear law: by the loads at the start, by the strain energy later.
struct StrainWatch
{
  double stiffness = 0.0;     ///< sum of Young's modulus times volume [J]
  double largestEnergy = 0.0; ///< of all samples [J]

  /// \param scene its core
  template <int D>
  void start(const Teuchos::ParameterList& scene, State<D>& state)
  {
    if (state.bodies.info.empty())
      return;
    const std::vector<BodyMeasure<D>> bodies = measureBodies(state);
    for (const BodyMeasure<D>& body : bodies)
      if (!body.linear)
        return;
    for (const BodyMeasure<D>& body : bodies)
      stiffness += body.moduli.young * body.volume;
    const std::vector<LoadEstimate> loads = estimateLoads(scene, state, bodies);
    const LoadEstimate* load = largestStrain(loads);
    if (load != nullptr && load->strain > smallStrain)
      state.warnings.push_back("Energy Release: " + load->where + " strains the body by about " +
                               formatShort(100.0 * load->strain) + " %" + advice());
  }

  /// To be called with every sample. \param energy strain energy of all bodies [J]
  void sample(double energy) { largestEnergy = std::max(largestEnergy, energy); }

  /// What a user must know at the end; empty if nothing.
  std::string warning() const
  {
    const double strain = stiffness > 0.0 ? std::sqrt(2.0 * largestEnergy / stiffness) : 0.0;
    return strain > smallStrain && std::isfinite(strain)
               ? "Energy Release: the bodies were strained by " + formatShort(100.0 * strain) +
                     " % (root mean square, from the largest strain energy)" + advice()
               : std::string();
  }

private:
  static std::string advice()
  {
    return "; K assumes small strain and is off by about the strain: use G_J, and a law for finite strain";
  }
};

} // namespace Rhegma::energy_release
