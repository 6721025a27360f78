#include "state/FrontEvent.hpp"

#include "archive/Archive.hpp"
#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"

namespace Rhegma
{

template <int D>
std::string FrontEvent<D>::asText() const
{
  std::string text = what;
  if (toughness > 0.0)
    text += std::string(lost ? ", G is not known, it was last " : ", G = ") + formatShort(release) +
            " J/m2 for Gc = " + formatShort(toughness) + " J/m2,";
  text += " at t = " + readableTime(time) + ", at ";
  for (int d = 0; d < D; ++d)
    text += formatShort(position[d]) + (d + 1 < D ? ", " : " m");
  return text;
}

template <int D>
void FrontEvent<D>::serialize(Archive& archive)
{
  archive("what", what);
  archive("time", time);
  archive("position", position);
  archive("release", release);
  archive("toughness", toughness);
  archive("lost", lost);
}

template struct FrontEvent<2>;
template struct FrontEvent<3>;

} // namespace Rhegma
