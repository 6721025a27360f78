#include "cracks/FewParticles.hpp"

#include "base/ReadList.hpp"

namespace Rhegma::cracks
{

std::vector<std::string> bodiesOfFewParticles(const Teuchos::ParameterList& scene, const RunOptions& options)
{
  std::vector<std::string> messages;
  if (!options.heat() || !options.extrapolated)
    return messages;
  const Teuchos::ParameterList& bodies = scene.sublist("Bodies");
  for (const std::string& name : sublistNames(bodies))
    if (bodies.sublist(name).get<int>("Particles Per Cell") == 1)
      messages.push_back("Bodies > " + name +
                         " > Particles Per Cell is 1: with Cracks > Formulation = Corrected Broken Cell and "
                         "heat, temperatures next to a crack can be unstable (half of the bodies that were "
                         "tried); write 2, or Formulation = Dual Field");
  return messages;
}

} // namespace Rhegma::cracks
