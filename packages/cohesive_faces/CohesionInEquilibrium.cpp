#include "cohesive_faces/CohesionInEquilibrium.hpp"

#include "state/Subdomain.hpp"

#include <algorithm>

namespace Rhegma::cohesive_faces
{

namespace
{

/// Of secant fractions, as a part of them: less damage than by the jump is none.
constexpr double rounding = 1e-9;

/// How often a point may change its branch in the iterations of a step before its secant fraction is held
/// over each: at a kink both branches may lead to the other one.
constexpr int mostChanges = 6;

} // namespace

template <int D>
typename CohesionInEquilibrium<D>::Groups CohesionInEquilibrium<D>::begin(const State<D>& state,
                                                                          const View<int*>& rowOf)
{
  const FacePoints<D>& points = cohesion_.points();
  ranks_ = ranksOf(state);
  names_.clear();
  for (const Crack<D>& crack : state.cracks.cracks)
    names_.push_back(crack.name);
  points_.clear();
  jumps_.assign(static_cast<std::size_t>(D) * points.count(), 0.0);
  found_.resize(points.count());
  branch_.assign(points.count(), {});
  changes_.assign(points.count(), 0);
  held_.assign(points.count(), 0.0);
  Groups groups;
  for (int k = 0; k < points.count(); ++k)
  {
    FoundPoint<D>& found = found_[k];
    found.gap = cohesion_.gap()(k);
    for (int t = 0; t < D - 1; ++t)
      found.slip[t] = cohesion_.slip()(k, t);
    const TractionLaw& law = cohesion_.laws()(points.crack(k));
    if (law.holds)
    {
      // A point whose damage grew last is taken to go on, which gives the softening of its neighbours, too.
      const double secant = cohesion_.secant()(k);
      branch_[k] = branchAt<D>(law, found.gap, found.slip, secant < 1.0 ? (1.0 + rounding) * secant : secant);
      found.now =
          cohesionOn<D>(branch_[k], law, found.gap, found.slip, cohesion_.secant()(k), cohesion_.spent()(k));
    }
    if (!law.holds || points.acts(k) == 0)
      continue;
    Point point;
    point.index = k;
    point.crack = points.crack(k);
    point.area = points.size(k) * cohesion_.thickness();
    for (int d = 0; d < D; ++d)
      point.axes[0][d] = points.normal(k, d);
    for (int t = 1; t < D; ++t)
      point.axes[t] = tangentOf(points, k, t - 1);
    for (const bool upper : {false, true})
    {
      const StencilTable<D>& face = upper ? points.above : points.below;
      point.whole = point.whole && face.count(k) > 0;
      for (int e = 0; e < face.count(k); ++e)
        if (const int row = rowOf(face.node(k, e)); row >= 0)
          point.parts.push_back({row, upper ? face.weight(k, e) : -face.weight(k, e)});
    }
    if (point.parts.empty())
      continue;
    groups.emplace_back();
    for (const Part& part : point.parts)
      groups.back().push_back(part.row);
    points_.push_back(std::move(point));
  }
  return groups;
}

template <int D>
void CohesionInEquilibrium<D>::add(const Values& displacement, const Values& force)
{
  std::fill(jumps_.begin(), jumps_.end(), 0.0);
  for (const Point& point : points_)
    for (const Part& part : point.parts)
      for (int d = 0; d < D; ++d)
        jumps_[D * point.index + d] += part.weight * displacement(D * part.row + d);
  ranks_.sum(jumps_.data(), static_cast<int>(jumps_.size()));
  const FacePoints<D>& all = cohesion_.points();
  for (int k = 0; k < all.count(); ++k)
  {
    const TractionLaw& law = cohesion_.laws()(all.crack(k));
    if (!law.holds || all.acts(k) == 0)
      continue;
    Vector<D> jump, normal;
    for (int d = 0; d < D; ++d)
    {
      jump[d] = jumps_[D * k + d];
      normal[d] = all.normal(k, d);
    }
    FoundPoint<D>& found = found_[k];
    found.gap = cohesion_.gap()(k) + dot(jump, normal);
    for (int t = 0; t < D - 1; ++t)
      found.slip[t] = cohesion_.slip()(k, t) + dot(jump, tangentOf(all, k, t));
    const double secant = changes_[k] > mostChanges ? held_[k] : cohesion_.secant()(k);
    found.now = cohesionOn<D>(branch_[k], law, found.gap, found.slip, secant, cohesion_.spent()(k));
  }
  for (const Point& point : points_)
  {
    const int k = point.index;
    const Cohesion<D> mean = meanOf(found_[k].now, cohesion_.bonded()(k));
    Vector<D> onUpper = -(mean.tension + cohesion_.pressure()(k)) * point.axes[0];
    for (int t = 0; t < D - 1; ++t)
      onUpper = onUpper - (mean.shear[t] - cohesion_.shear()(k, t)) * point.axes[1 + t];
    for (const Part& part : point.parts)
      for (int d = 0; d < D; ++d)
        force(D * part.row + d) += point.area * part.weight * onUpper[d];
  }
}

template <int D>
bool CohesionInEquilibrium<D>::addStiffness(bool symmetric, const AddBlock& addBlock)
{
  bool isSymmetric = true;
  for (const Point& point : points_)
  {
    const int k = point.index;
    const TractionLaw& law = cohesion_.laws()(point.crack);
    const FoundPoint<D>& found = found_[k];
    Branch branch = branch_[k];
    branch.grows = branch.grows && point.whole;
    double C[D][D];
    stiffnessAt<D>(branch, law, found.gap, found.slip, found.now, C);
    const double bonded = cohesion_.bonded()(k);
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
        C[i][j] *= i == 0 && j == 0 && !branch.open ? 1.0 : bonded;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < i; ++j)
      {
        isSymmetric = isSymmetric && C[i][j] == C[j][i];
        if (symmetric)
          C[i][j] = C[j][i] = 0.5 * (C[i][j] + C[j][i]);
      }
    double K[D][D] = {}; // along the axes of the cells
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
        for (int a = 0; a < D; ++a)
          for (int b = 0; b < D; ++b)
            K[a][b] += point.area * C[i][j] * point.axes[i][a] * point.axes[j][b];
    for (const Part& one : point.parts)
      for (const Part& other : point.parts)
      {
        double block[D * D];
        for (int a = 0; a < D; ++a)
          for (int b = 0; b < D; ++b)
            block[D * a + b] = one.weight * other.weight * K[a][b];
        addBlock(one.row, other.row, block);
      }
  }
  return symmetric || ranks_.max(isSymmetric ? 0.0 : 1.0) == 0.0;
}

template <int D>
bool CohesionInEquilibrium<D>::update()
{
  bool changed = false;
  const FacePoints<D>& points = cohesion_.points();
  for (int k = 0; k < points.count(); ++k)
  {
    const TractionLaw& law = cohesion_.laws()(points.crack(k));
    if (!law.holds || points.acts(k) == 0)
      continue;
    Branch now = branchAt<D>(law, found_[k].gap, found_[k].slip, cohesion_.secant()(k));
    const Branch& before = branch_[k];
    const bool differs =
        now.open != before.open || now.grows != before.grows || (now.grows && now.segment != before.segment);
    if (changes_[k] <= mostChanges)
      changes_[k] += differs ? 1 : 0;
    if (changes_[k] > mostChanges)
    {
      const double secant =
          cohesionOn<D>(now, law, found_[k].gap, found_[k].slip, cohesion_.secant()(k), cohesion_.spent()(k))
              .secant;
      changed = changed || now.open != before.open || secant != held_[k];
      held_[k] = secant;
      now.grows = false;
    }
    else
      changed = changed || differs;
    branch_[k] = now;
  }
  return changed;
}

template <int D>
std::string CohesionInEquilibrium<D>::reason() const
{
  std::vector<char> any(names_.size(), 0), holds(names_.size(), 0);
  const FacePoints<D>& points = cohesion_.points();
  for (int k = 0; k < points.count(); ++k)
    if (cohesion_.laws()(points.crack(k)).holds)
    {
      any[points.crack(k)] = 1;
      if (found_[k].now.spent < failedFraction && cohesion_.bonded()(k) > 0.0)
        holds[points.crack(k)] = 1;
    }
  std::string text;
  for (std::size_t c = 0; c < any.size(); ++c)
    if (any[c] != 0 && holds[c] == 0)
      text += (text.empty() ? "" : "; ") +
              ("the cohesive faces of crack " + names_[c] + " have failed over all their length");
  return text;
}

template <int D>
void CohesionInEquilibrium<D>::accept(const State<D>& state)
{
  const FacePoints<D>& points = cohesion_.points();
  for (int k = 0; k < points.count(); ++k)
    if (const TractionLaw& law = cohesion_.laws()(points.crack(k)); law.holds && changes_[k] > mostChanges)
      found_[k].now =
          cohesionAt<D>(law, found_[k].gap, found_[k].slip, cohesion_.secant()(k), cohesion_.spent()(k));
  cohesion_.accept(state, found_);
}

template class CohesionInEquilibrium<2>;
template class CohesionInEquilibrium<3>;

} // namespace Rhegma::cohesive_faces
