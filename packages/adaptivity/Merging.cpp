#include "adaptivity/Merging.hpp"

#include "adaptivity/Families.hpp"
#include "adaptivity/TogetherAgain.hpp"
#include "material/Materials.hpp"
#include "material/Tensors.hpp"
#include "state/Ancestry.hpp"
#include "state/ParticleEnergy.hpp"
#include "state/Subdomain.hpp"
#include "transfer/Box.hpp"

#include <algorithm>
#include <vector>

namespace Rhegma::adaptivity
{

namespace
{

/// Computes the particle that a family would become, decides whether the family may merge, and merges it.
template <int D>
struct MergeFamilies
{
  View<int * [parts<D>]> family;
  View<int*> accepted; ///< 1: merged, 2: kept for its energy
  View<int*> unlike;   ///< of each family: 1 where its parts differ in something that has no mean
  /// Of each part of each family: its fraction of the undeformed volume. Parts may have burnt by different
  /// fractions.
  View<double * [parts<D>]> fraction;
  TreeSight<D> sight;
  View<double* [D][D]> axes;
  ParticleEnergy<D> before; ///< of the parts
  BorrowedView<double*[D]> position, reference, velocity, edge, box;
  BorrowedView<double*> mass, volume;
  BorrowedView<double * [gradientSize<D>]> deformation;
  BorrowedView<int*> body, level, lineage;
  double largestBox, tolerance, meanEnergy; ///< the last per mass [J/kg]
  bool boxes, undeformed;

  explicit MergeFamilies(const State<D>& state) : before(state) {}

  KOKKOS_INLINE_FUNCTION void operator()(int i, double& lost) const
  {
    const int to = family(i, 0);
    accepted(i) = 0;
    if (unlike(i) != 0)
      return;
    double F[gradientSize<D>] = {}, v[D] = {}, x[D] = {}, X[D] = {}, m = 0.0, V = 0.0, now = 0.0,
           energy = 0.0, motion = 0.0;
    const Properties& law = before.materials(before.material(to));
    for (int k = 0; k < parts<D>; ++k)
    {
      m += mass(family(i, k));
      V += volume(family(i, k));
    }
    for (int k = 0; k < parts<D>; ++k)
    {
      const int p = family(i, k);
      const double heavy = mass(p) / m;
      fraction(i, k) = volume(p) / V;
      for (int d = 0; d < D; ++d)
      {
        v[d] += before.mechanics ? heavy * velocity(p, d) : 0.0;
        x[d] += heavy * position(p, d);
        X[d] += heavy * reference(p, d);
      }
      for (int c = 0; c < gradientSize<D>; ++c)
        F[c] += fraction(i, k) * deformation(p, c);
      now += fraction(i, k) * determinant<D>(&deformation(p, 0));
      energy += before.kinetic(p) + before.strain(p);
      motion += before.kinetic(p);
    }
    stretchTo(now, F);
    const int depth = level(to) - 1;
    double edges[D], half[D];
    for (int d = 0; d < D; ++d)
      edges[d] = 2.0 * edge(to, d);
    updateBox<D>(axes, body(to), edges, undeformed ? nullptr : F, std::ldexp(largestBox, -depth), half);
    if (touchesFiner(x, half, depth))
      return;
    double memory[historyCapacity] = {};
    mergeHistory(i, law, m, memory);
    double square = 0.0;
    for (int d = 0; d < D; ++d)
      square += v[d] * v[d];
    const double after = 0.5 * m * square + V * stored(law, before.material(to), i, F,
                                                       before.history.extent(1) > 0 ? memory : nullptr);
    const double enough = energy > m * meanEnergy ? energy : m * meanEnergy;
    // Plastic states do not average: a mean strain with a mean plastic strain can hold more energy than the
    // parts did.
    if (std::fabs(energy - after) > tolerance * enough)
    {
      accepted(i) = 2;
      return;
    }
    accepted(i) = 1;
    // Where particles have internal energy, the strain energy that is lost becomes heat.
    lost += before.thermo.empty() ? energy - after : motion - 0.5 * m * square;
    for (int c = 0; c < static_cast<int>(before.history.extent(1)); ++c)
      before.history(to, c) = memory[c];
    mass(to) = m;
    volume(to) = V;
    write(to, F, v, x, X, edges, half);
  }

  KOKKOS_INLINE_FUNCTION void write(int to, const double* F, const double* v, const double* x,
                                    const double* X, const double* edges, const double* half) const
  {
    --level(to);
    lineage(to) = lineage(to) >> D;
    for (int c = 0; c < gradientSize<D>; ++c)
      deformation(to, c) = F[c];
    for (int d = 0; d < D; ++d)
    {
      if (before.mechanics)
        velocity(to, d) = v[d];
      position(to, d) = x[d];
      reference(to, d) = X[d];
      edge(to, d) = edges[d];
      if (boxes)
        box(to, d) = half[d];
    }
  }

  /// Gives a deformation gradient the determinant that is wanted: the volume that the parts have now.
  KOKKOS_INLINE_FUNCTION static void stretchTo(double wanted, double* F)
  {
    const double ratio = wanted / determinant<D>(F), stretch = D == 2 ? std::sqrt(ratio) : std::cbrt(ratio);
    for (int c = 0; c < D * D; ++c)
      F[c] *= stretch;
  }

  /// Elastic energy of the family as one [J/m3], at its mean temperature where particles have one.
  KOKKOS_INLINE_FUNCTION double stored(const Properties& law, int material, int i, const double* F,
                                       const double* memory) const
  {
    if (!before.mechanics)
      return 0.0;
    if (before.thermo.empty())
      return storedEnergy<D>(law, F, memory);
    double T = 0.0;
    for (int k = 0; k < parts<D>; ++k)
      T += fraction(i, k) * before.temperature(family(i, k));
    return withLaw<D>(law.law, law.plane, ThermoEnergy{ThermoPoint(before.thermo, material, T), F, memory});
  }

  /// The history of the family as one. \param m mass of all parts
  KOKKOS_INLINE_FUNCTION void mergeHistory(int i, const Properties& law, double m,
                                           double (&memory)[historyCapacity]) const
  {
    double value[parts<D>], byVolume[parts<D>], byMass[parts<D>];
    for (int k = 0; k < parts<D>; ++k)
    {
      byVolume[k] = fraction(i, k);
      byMass[k] = mass(family(i, k)) / m;
    }
    for (int c = 0; c < static_cast<int>(before.history.extent(1)); ++c)
    {
      for (int k = 0; k < parts<D>; ++k)
        value[k] = before.history(family(i, k), c);
      memory[c] = merged(meanOfHistory<D>(law, c), value, byVolume, byMass);
    }
  }

  KOKKOS_INLINE_FUNCTION bool touchesFiner(const double (&x)[D], const double (&half)[D], int depth) const
  {
    const double slack = std::ldexp(0.5 * mayReach, -depth - 1);
    double low[D], high[D];
    for (int d = 0; d < D; ++d)
    {
      const double at = sight.grid.inCells(x[d], d);
      const double reach = boxes ? half[d] * sight.grid.inverse - slack : 0.0;
      low[d] = at - reach;
      high[d] = at + reach;
    }
    bool finer = false;
    sight.forEachLeaf(low, high, [&](const auto& leaf) { finer = finer || leaf.level > depth; });
    return finer;
  }
};

/// Kinetic and strain energy of all particles over their mass [J/kg]. Collective.
template <int D>
double meanEnergy(const State<D>& state)
{
  const ParticleEnergy<D> of(state);
  double energy = 0.0, all = 0.0;
  Kokkos::parallel_reduce(
      "rhegma::adaptivity::meanEnergy", Kokkos::RangePolicy<ExecSpace>(0, state.particles.size()),
      KOKKOS_LAMBDA(const int p, double& sum, double& m) {
        sum += of.kinetic(p) + of.strain(p);
        m += of.mass(p);
      },
      energy, all);
  double sums[2] = {energy, all};
  sumParts(state, sums, 2);
  return sums[1] > 0.0 ? sums[0] / sums[1] : 0.0;
}

/// Fields that merging itself finds; of all other real ones the merged particle has the mean over the
/// undeformed volume, so that quantities per volume are conserved.
bool isFound(const std::string& name)
{
  static const std::vector<std::string> found = {fields::position, fields::reference,   fields::velocity,
                                                 fields::mass,     fields::volume,      fields::edge,
                                                 fields::box,      fields::deformation, fields::history};
  return std::find(found.begin(), found.end(), name) != found.end();
}

template <int D>
void averageOthers(State<D>& state, const MergeFamilies<D>& merge)
{
  const View<int * [parts<D>]> family = merge.family;
  const View<int*> accepted = merge.accepted;
  const View<double * [parts<D>]> fraction = merge.fraction;
  for (const Field& field : state.particles.fields())
  {
    if (field.integer || isFound(field.name))
      continue;
    const auto values = state.particles.table(field.name);
    const int width = field.components;
    Kokkos::parallel_for(
        "rhegma::adaptivity::averageField", Kokkos::RangePolicy<ExecSpace>(0, family.extent(0)),
        KOKKOS_LAMBDA(const int i) {
          if (accepted(i) != 1)
            return;
          for (int c = 0; c < width; ++c)
          {
            double sum = 0.0;
            for (int k = 0; k < parts<D>; ++k)
              sum += fraction(i, k) * values(family(i, k), c);
            values(family(i, 0), c) = sum;
          }
        });
  }
}

/// Marks families whose parts differ in a whole number that an effect gave them, such as the side of a crack
/// on which each lies: these have no mean.
template <int D>
void findUnlike(const State<D>& state, const View<int * [parts<D>]>& family, const View<int*>& unlike)
{
  static const std::vector<std::string> own = {fields::id, fields::level, fields::ancestor, fields::lineage};
  for (const Field& field : state.particles.fields())
  {
    if (!field.integer || std::find(own.begin(), own.end(), field.name) != own.end())
      continue;
    const auto values = state.particles.integer(field.name);
    Kokkos::parallel_for(
        "rhegma::adaptivity::findUnlike", Kokkos::RangePolicy<ExecSpace>(0, family.extent(0)),
        KOKKOS_LAMBDA(const int i) {
          for (int k = 1; k < parts<D>; ++k)
            if (values(family(i, k)) != values(family(i, 0)))
              unlike(i) = 1;
        });
  }
}

template <int D>
MergeFamilies<D> mergerOf(State<D>& state, double tolerance, double mean)
{
  FieldTable& table = state.particles;
  MergeFamilies<D> merge(state);
  merge.sight = TreeSight<D>(state.mesh.grid, state.mesh.tree);
  merge.axes = state.bodies.axes;
  merge.position = table.real<D>(fields::position);
  merge.reference = table.real<D>(fields::reference);
  merge.undeformed = state.method.totalLagrangian;
  if (state.method.mechanics)
    merge.velocity = table.real<D>(fields::velocity);
  merge.edge = table.real<D>(fields::edge);
  merge.mass = table.scalar(fields::mass);
  merge.volume = table.scalar(fields::volume);
  merge.deformation = table.real<gradientSize<D>>(fields::deformation);
  merge.body = table.integer(fields::body);
  merge.level = table.integer(fields::level);
  merge.lineage = table.integer(fields::lineage);
  merge.boxes = state.method.shape == ShapeKind::Gimp;
  if (merge.boxes)
    merge.box = table.real<D>(fields::box);
  merge.largestBox = 0.5 * state.mesh.grid.spacing;
  merge.tolerance = tolerance;
  merge.meanEnergy = mean;
  return merge;
}

/// Merges the families that may be. \param mean energy per mass of all particles \return what was done here
template <int D>
Merged mergeOnce(State<D>& state, const std::vector<Family<D>>& families, double tolerance, double mean)
{
  const int count = static_cast<int>(families.size());
  const View<int * [parts<D>]> family("rhegma::family", count);
  const auto hostFamily = Kokkos::create_mirror_view(family);
  for (int i = 0; i < count; ++i)
    for (int k = 0; k < parts<D>; ++k)
      hostFamily(i, k) = families[i][k];
  Kokkos::deep_copy(family, hostFamily);
  const View<int*> accepted("rhegma::accepted", count);
  MergeFamilies<D> merge = mergerOf(state, tolerance, mean);
  merge.family = family;
  merge.accepted = accepted;
  merge.unlike = View<int*>("rhegma::unlikeFamilies", count);
  merge.fraction = View<double * [parts<D>]>("rhegma::familyFractions", count);
  findUnlike<D>(state, family, merge.unlike);
  Merged merged;
  Kokkos::parallel_reduce("rhegma::adaptivity::mergeFamilies", Kokkos::RangePolicy<ExecSpace>(0, count),
                          merge, merged.lost);
  averageOthers(state, merge);

  const int n = state.particles.size();
  std::vector<char> gone(n, 0);
  const auto hostAccepted = onHost(accepted);
  for (int i = 0; i < count; ++i)
  {
    merged.families += hostAccepted(i) == 1 ? 1 : 0;
    merged.kept += hostAccepted(i) == 2 ? 1 : 0;
    for (int k = 1; k < parts<D> && hostAccepted(i) == 1; ++k)
      gone[families[i][k]] = 1;
  }
  if (merged.families == 0)
    return merged;
  const View<int*> order("rhegma::mergeOrder", n - merged.families * (parts<D> - 1));
  const auto hostOrder = Kokkos::create_mirror_view(order);
  int next = 0;
  for (int p = 0; p < n; ++p)
    if (gone[p] == 0)
      hostOrder(next++) = p;
  Kokkos::deep_copy(order, hostOrder);
  state.particles.reorder(order);
  return merged;
}

} // namespace

template <int D>
Merged mergeParticles(State<D>& state, double tolerance)
{
  Merged all;
  const Ranks ranks = ranksOf(state);
  for (;;)
  {
    View<int*> small = tooSmall(state);
    if (state.mesh.subdomain)
    {
      bringTogether(state, small);
      small = tooSmall(state);
    }
    const std::vector<Family<D>> families = wholeFamilies<D>(state, small);
    if (ranks.sum(static_cast<double>(families.size())) == 0.0)
      break;
    const Merged some = mergeOnce(state, families, tolerance, meanEnergy(state));
    double done[2] = {double(some.families), double(some.kept)};
    ranks.sum(done, 2);
    all.lost += some.lost;
    all.families += static_cast<int>(done[0]);
    all.kept = static_cast<int>(done[1]);
    if (done[0] == 0.0)
      break;
    state.particles.sorted = false;
  }
  return all;
}

template Merged mergeParticles(State<2>&, double);
template Merged mergeParticles(State<3>&, double);

} // namespace Rhegma::adaptivity
