#include "geometry/Seeds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace Rhegma
{
namespace
{

/// Cells of the lattice, counted from the base shape's lower corner; `first` may be negative.
template <int D>
struct Lattice
{
  Vector<D> origin; ///< own coordinates [m]
  Vector<D> edge;   ///< [m]
  double first[D];
  double count[D];
};

/// Bounds of the whole shape in the base shape's own coordinates; exact where nothing is added.
template <int D>
Geometry::Bounds<D> reach(const Shape<D>& shape)
{
  const Geometry::Part<D>& base = shape.base();
  Geometry::Bounds<D> result = base.ownBounds();
  for (const auto& part : shape.parts())
    if (&part != &base && part.operation == Geometry::Operation::Add)
      for (const auto& corner : part.bounds().corners())
        result.include(base.frame.toOwn(corner));
  return result;
}

template <int D>
Lattice<D> makeLattice(const Shape<D>& shape, double edge)
{
  const Geometry::Bounds<D> base = shape.base().ownBounds();
  const Geometry::Bounds<D> all = reach(shape);
  Lattice<D> lattice;
  lattice.origin = base.lower;
  for (int d = 0; d < D; ++d)
  {
    const double length = base.upper[d] - base.lower[d];
    const double across = std::max(1.0, std::round(length / edge));
    lattice.edge[d] = length / across;
    // A part that ends on a lattice line must not get an additional row because of rounding.
    const double slack = 1.0e-9;
    lattice.first[d] = std::floor((all.lower[d] - base.lower[d]) / lattice.edge[d] + slack);
    const double last = std::ceil((all.upper[d] - base.lower[d]) / lattice.edge[d] - slack);
    lattice.count[d] = last - lattice.first[d];
  }
  return lattice;
}

template <int D>
Vector<D> positionOf(const Lattice<D>& lattice, const double (&index)[3])
{
  Vector<D> own;
  for (int d = 0; d < D; ++d)
    own[d] = lattice.origin[d] + (lattice.first[d] + index[d]) * lattice.edge[d];
  return own;
}

} // namespace

template <int D>
double estimateSeeds(const Shape<D>& shape, double cell, int particlesPerCell)
{
  const Lattice<D> lattice = makeLattice(shape, cell / particlesPerCell);
  double total = 1.0;
  for (int d = 0; d < D; ++d)
    total *= lattice.count[d];
  constexpr int samples = 100000;
  if (!(total > samples))
    return total;
  // Fractions of multiples of an irrational number fill the interval evenly (Weyl); square roots of primes do
  // so in each axis without regard to the others.
  const double steps[3] = {std::sqrt(2.0), std::sqrt(3.0), std::sqrt(5.0)};
  int inside = 0;
  for (int k = 1; k <= samples; ++k)
  {
    double index[3] = {};
    for (int d = 0; d < D; ++d)
      index[d] = (k * steps[d] - std::floor(k * steps[d])) * lattice.count[d];
    inside += shape.contains(shape.base().frame.toSpace(positionOf(lattice, index))) ? 1 : 0;
  }
  return total * std::max(inside, 1) / samples;
}

template <int D>
Seeds<D> seedParticles(const Shape<D>& shape, double cell, int particlesPerCell, const std::string& section)
{
  if (!(cell > 0.0) || particlesPerCell < 1)
    throw std::invalid_argument(section +
                                ": particles need a positive cell size and at least one particle per cell.");
  const Lattice<D> lattice = makeLattice(shape, cell / particlesPerCell);

  double total = 1.0;
  Seeds<D> seeds;
  seeds.edge = lattice.edge;
  seeds.axes = shape.base().frame.axes;
  seeds.volume = 1.0;
  for (int d = 0; d < D; ++d)
  {
    total *= lattice.count[d];
    seeds.volume *= lattice.edge[d];
  }
  if (!(total < std::numeric_limits<int>::max()))
  {
    std::ostringstream message;
    message << section << ": the body would need about " << total << " particles, more than "
            << std::numeric_limits<int>::max() << "; make the cells larger or the body smaller.";
    throw std::invalid_argument(message.str());
  }

  long long counts[3] = {1, 1, 1};
  for (int d = 0; d < D; ++d)
    counts[d] = static_cast<long long>(lattice.count[d]);
  for (long long k = 0; k < counts[2]; ++k)
    for (long long j = 0; j < counts[1]; ++j)
      for (long long i = 0; i < counts[0]; ++i)
      {
        const double index[3] = {double(i) + 0.5, double(j) + 0.5, double(k) + 0.5};
        const Vector<D> x = shape.base().frame.toSpace(positionOf(lattice, index));
        if (shape.contains(x))
          seeds.position.push_back(x);
      }

  if (seeds.position.empty())
  {
    std::ostringstream message;
    message << section << ": the body contains no particle; it is smaller than a particle ("
            << cell / particlesPerCell << " m) or fully cut away; make the body larger or the cells smaller.";
    throw std::invalid_argument(message.str());
  }
  return seeds;
}

template double estimateSeeds<2>(const Shape<2>&, double, int);
template double estimateSeeds<3>(const Shape<3>&, double, int);
template Seeds<2> seedParticles<2>(const Shape<2>&, double, int, const std::string&);
template Seeds<3> seedParticles<3>(const Shape<3>&, double, int, const std::string&);

} // namespace Rhegma
