#include "surface/FrontLines.hpp"

namespace Rhegma::surface
{

template <int D>
void cutLanded(FrontLines<D>& lines)
{
  bool cut = false;
  for (std::size_t k = 0; k < lines.size(); ++k)
    if (lines[k].joined && lines[k].landed && lines[nextPoint(lines, k)].landed)
    {
      lines[k].joined = false;
      cut = true;
    }
  if constexpr (D == 2)
    cut = std::any_of(lines.begin(), lines.end(), [](const FrontPoint<D>& p) { return p.landed; });
  if (!cut)
    return;
  // A closed line that was cut begins behind the cut.
  if (lines.back().joined)
  {
    const auto open =
        std::find_if(lines.begin(), lines.end(), [](const FrontPoint<D>& p) { return !p.joined; });
    std::rotate(lines.begin(), open + 1, lines.end());
  }
  FrontLines<D> rest;
  for (std::size_t k = 0; k < lines.size(); ++k)
    if (lines[k].joined || previousPoint(lines, k) >= 0)
      rest.push_back(lines[k]);
  lines = rest;
}

template void cutLanded(FrontLines<2>&);
template void cutLanded(FrontLines<3>&);

} // namespace Rhegma::surface
