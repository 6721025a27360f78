#pragma once

#include "base/Numbers.hpp"
#include "base/Types.hpp"

#include <string>

namespace Rhegma
{

/// A point for a message: "(0.1, 0.25) m". \param x [m]
template <int D>
std::string formatPoint(const Vector<D>& x)
{
  std::string text;
  for (int d = 0; d < D; ++d)
    text += (d == 0 ? "(" : ", ") + formatReal(x[d]);
  return text + ") m";
}

} // namespace Rhegma
