#include "thermal/ThinLayers.hpp"

#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"
#include "plausibility/BodyMeasures.hpp"

#include <stdexcept>

namespace Rhegma::thermal
{

template <int D>
void refuseThinLayers(const Teuchos::ParameterList& materials, const State<D>& state)
{
  const char* const name = "Conductivity Ratios";
  const double cell = state.mesh.grid.spacing;
  constexpr double rows = 1.5;
  for (const BodyMeasure<D>& body : measureBodies(state))
  {
    const Teuchos::ParameterList& material = materials.sublist(body.material);
    if (!material.isType<Teuchos::Array<double>>(name))
      continue;
    const auto& ratio = material.get<Teuchos::Array<double>>(name);
    for (int d = 0; d < D && material.isParameter("Conductivity"); ++d)
      for (int e = 0; e < D; ++e)
      {
        const double length = body.ownUpper[e] - body.ownLower[e],
                     width = body.ownUpper[d] - body.ownLower[d];
        if (width < rows * cell) // there are no rows next to one another
          continue;
        const double least = ratio[e] * cell * cell / (length * length);
        if (e == d || !(ratio[d] < least) || !(ratio[d] < ratio[e]))
          continue;
        throw std::invalid_argument(
            "Materials > " + body.material + " > " + name + ": " + formatReal(ratio[d]) +
            " is too small for steady conduction in these cells: across Bodies > " + body.name +
            " temperatures change within less than a cell, and leave the bounds of those prescribed; write "
            "at "
            "least " +
            formatShort(least) + ", which is " + formatShort(ratio[e]) +
            " (h / L)^2 with the cells h = " + readableLength(cell) +
            " and its length L = " + readableLength(length) + ", or use a smaller Domain > Cell Size");
      }
  }
}

template void refuseThinLayers(const Teuchos::ParameterList&, const State<2>&);
template void refuseThinLayers(const Teuchos::ParameterList&, const State<3>&);

} // namespace Rhegma::thermal
