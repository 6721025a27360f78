#include "mass_matrix/MatrixMemory.hpp"

#include <cstdio>
#include <stdexcept>
#include <string>

namespace Rhegma::mass_matrix
{

void refuseLargeMatrix(double rows, double bytesPerRow, double available, const char* instead)
{
  const double needed = rows * bytesPerRow;
  if (!(needed > available))
    return;
  char sizes[128];
  std::snprintf(sizes, sizeof sizes, "about %.3g nodes needs %.3g GB of memory where %.3g GB are free", rows,
                1e-9 * needed, 1e-9 * available);
  throw std::invalid_argument("Mass Matrix > Type: the matrix of " + std::string(sizes) + "; take " +
                              instead);
}

} // namespace Rhegma::mass_matrix
