#include "contact/ContactInEquilibrium.hpp"

#include "contact/FacePatches.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace Rhegma::contact
{

namespace
{

/// Stiffness of contact over that of dynamics, which a step of time limits: multipliers then converge by one
/// or two digits an iteration.
constexpr double stiffening = 1000.0;

/// The same of what keeps the nodes of a patch together. It is less than that of contact, as neighbouring
/// patches have nodes in common: their multipliers converge with the ratio of both.
constexpr double joining = 20.0;

/// Gap below which faces touch at the start of a step, in cells: gaps of closed faces go to zero with the
/// residual.
constexpr double touchingGap = 1e-9;

/// How often a patch may open, or begin to slide, before its nodes are free to move apart while it presses or
/// sticks. Those of a patch in which the faces part at one end may overlap in the mean when they are free and
/// pull in the mean when they are kept together, so that neither is an equilibrium. Once they are free, a
/// mean pressure closes a mean overlap.
constexpr int mostChanges = 1;

/// Rounding of the shear traction of faces that slide, as a part of its limit.
constexpr double atLimit = 1e-6;

/// Jump of a displacement between two rows along an axis; a row of -1 does not move.
template <int D>
double jumpOf(const View<double*>& displacement, int plus, int minus, int axis)
{
  return (plus >= 0 ? displacement(D * plus + axis) : 0.0) -
         (minus >= 0 ? displacement(D * minus + axis) : 0.0);
}

} // namespace

template <int D>
typename ContactInEquilibrium<D>::Groups ContactInEquilibrium<D>::begin(const State<D>& state,
                                                                        const View<int*>& rowOf)
{
  patches_.collect(state);
  names_.clear();
  for (const Crack<D>& crack : state.cracks.cracks)
    names_.push_back(crack.name);
  Groups groups;
  for (Patch& patch : patches_.all())
  {
    patch.touching = patch.gap <= touchingGap * state.mesh.grid.spacing;
    patch.normalMultiplier = patch.pressure;
    patch.shearMultiplier = patch.shear;
    const double limit = contact_.friction() * patch.pressure;
    patch.slid = limit > 0.0 && norm(patch.shear) > (1.0 - atLimit) * limit;
    patch.touch = !patch.touching                       ? Touch::Open
                  : contact_.law() == Law::Frictionless ? Touch::Sliding
                                                        : Touch::Sticking;
    for (Part& part : patch.parts)
    {
      part.plusRow = rowOf(part.plus);
      part.minusRow = rowOf(part.minus);
    }
    addGroups(patch, groups);
  }
  return groups;
}

template <int D>
void ContactInEquilibrium<D>::addGroups(const Patch& patch, Groups& groups) const
{
  const auto addRows = [](const Part& part, std::vector<int>& group)
  {
    for (const int row : {part.plusRow, part.minusRow})
      if (row >= 0)
        group.push_back(row);
  };
  if (std::none_of(patch.parts.begin(), patch.parts.end(), [](const Part& part) { return part.ofThisRank; }))
    return;
  std::vector<int> whole;
  for (const Part& a : patch.parts)
  {
    addRows(a, whole);
    for (const Part& b : patch.parts)
      if (patch.isWide && a.ofThisRank && patches_.areCoupled(patch, a, b))
      {
        groups.emplace_back();
        addRows(a, groups.back());
        addRows(b, groups.back());
      }
  }
  if (!patch.isWide)
    groups.push_back(whole);
}

template <int D>
Stiffness ContactInEquilibrium<D>::stiffnessOf(const Patch& patch) const
{
  const Stiffness dynamic = contact_.stiffnessOf(patch.crack);
  return {stiffening * dynamic.normal, stiffening * dynamic.tangential};
}

template <int D>
Vector<D - 1> ContactInEquilibrium<D>::slipOf(const Patch& patch) const
{
  Vector<D - 1> slip;
  for (int t = 0; t < D - 1; ++t)
    slip[t] = patch.moved[1 + t];
  return slip;
}

template <int D>
Vector<D> ContactInEquilibrium<D>::jointStiffness(const Patch& patch) const
{
  Vector<D> joint{};
  const Stiffness dynamic = contact_.stiffnessOf(patch.crack);
  const Stiffness k{joining * dynamic.normal, joining * dynamic.tangential};
  joint[0] = patch.touch == Touch::Open || patch.opened > mostChanges ? 0.0 : k.normal;
  for (int t = 1; t < D; ++t)
    joint[t] =
        patch.touch == Touch::Sticking && !patch.slid && patch.slipped <= mostChanges ? k.tangential : 0.0;
  return joint;
}

template <int D>
void ContactInEquilibrium<D>::press(Patch& patch) const
{
  const Stiffness k = stiffnessOf(patch);
  patch.now = {};
  if (patch.touch == Touch::Open)
    return;
  patch.now.pressure = patch.normalMultiplier - k.normal * (patch.gap + patch.moved[0]);
  patch.now.shear = patch.touch == Touch::Sticking
                        ? patch.shearMultiplier + k.tangential * slipOf(patch)
                        : (contact_.friction() * patch.now.pressure) * slidingDirection(patch);
}

template <int D>
Vector<D - 1> ContactInEquilibrium<D>::slidingDirection(const Patch& patch) const
{
  if (!(patch.slideRadius > 0.0))
    return patch.direction;
  const Vector<D - 1> further = slipOf(patch) - patch.slipThen;
  const Vector<D - 1> sideways = further - dot(further, patch.direction) * patch.direction;
  const Vector<D - 1> turned = patch.direction + (1.0 / patch.slideRadius) * sideways;
  return (1.0 / norm(turned)) * turned;
}

template <int D>
void ContactInEquilibrium<D>::choose(Patch& patch) const
{
  const Stiffness k = stiffnessOf(patch);
  const Vector<D - 1> before = patch.direction, trial = patch.shearMultiplier + k.tangential * slipOf(patch);
  const Return<D - 1> law = returnMap(contact_.law(), contact_.friction(), k,
                                      patch.gap + patch.moved[0] - patch.normalMultiplier / k.normal,
                                      patch.touching, Vector<D - 1>{}, (1.0 / k.tangential) * trial, {});
  const Touch touched = patch.touch;
  const bool slid = touched == Touch::Sliding && norm(before) > 0.0;
  // The overlap of a patch that was open is that without contact: what it needs to close the patch is
  // unknown. As a multiplier it would be closed twice, and the next iteration could open it again.
  patch.normalMultiplier = touched == Touch::Open ? 0.0 : law.pressure;
  patch.shearMultiplier = touched == Touch::Open ? Vector<D - 1>{} : law.shear;
  patch.direction = {};
  patch.slideRadius = 0.0;
  const double size = norm(law.shear), limit = contact_.friction() * law.pressure;
  const bool sticks = patch.touching && (contact_.law() == Law::Stick ||
                                         (contact_.law() == Law::Coulomb && norm(trial) <= limit));
  if (!(law.pressure > 0.0))
    patch.touch = Touch::Open;
  else if (slid && dot(trial, before) < limit) // it would slide back: it sticks
  {
    patch.touch = Touch::Sticking;
    patch.shearMultiplier = limit * before;
  }
  else if (sticks)
    patch.touch = Touch::Sticking;
  else
  {
    patch.touch = Touch::Sliding;
    if (size > 0.0)
    {
      patch.direction = (1.0 / size) * law.shear;
      patch.slipThen = slipOf(patch);
      patch.slideRadius = norm(trial) / k.tangential;
    }
  }
  patch.opened += touched != Touch::Open && patch.touch == Touch::Open ? 1 : 0;
  patch.slipped += touched == Touch::Sticking && patch.touch == Touch::Sliding ? 1 : 0;
}

template <int D>
void ContactInEquilibrium<D>::findJumps(const Values& displacement)
{
  std::vector<Patch>& patches = patches_.all();
  std::vector<double> sums(2 * D * patches.size(), 0.0); // moved, middle
  for (std::size_t m = 0; m < patches.size(); ++m)
    for (Part& part : patches[m].parts)
    {
      part.own = Vector<D>{};
      for (int c = 0; c < D && part.ofThisRank; ++c)
      {
        for (int d = 0; d < D; ++d)
        {
          const double jump = jumpOf<D>(displacement, part.plusRow, part.minusRow, d);
          sums[2 * D * m + c] += part.jump[c][d] * jump;
          part.own[c] += part.axes[c][d] * jump;
        }
        sums[2 * D * m + D + c] += part.weight / patches[m].weights * part.own[c];
      }
    }
  patches_.ranks().sum(sums.data(), static_cast<int>(sums.size()));
  for (std::size_t m = 0; m < patches.size(); ++m)
  {
    std::copy_n(sums.data() + 2 * D * m, D, patches[m].moved.c);
    std::copy_n(sums.data() + 2 * D * m + D, D, patches[m].middle.c);
  }
}

template <int D>
void ContactInEquilibrium<D>::add(const Values& displacement, const Values& force)
{
  findJumps(displacement);
  for (Patch& patch : patches_.all())
  {
    press(patch);
    const Vector<D> joint = jointStiffness(patch);
    Vector<D> traction; // its change, on side +1
    traction[0] = patch.now.pressure - patch.pressure;
    for (int t = 0; t < D - 1; ++t)
      traction[1 + t] = patch.shear[t] - patch.now.shear[t];
    for (const Part& part : patch.parts)
      for (int c = 0; c < D && part.ofThisRank; ++c)
        for (int d = 0; d < D; ++d)
        {
          const double one = patch.area * part.jump[c][d] * traction[c] -
                             joint[c] * part.weight * (part.own[c] - patch.middle[c]) * part.axes[c][d];
          if (part.plusRow >= 0)
            force(D * part.plusRow + d) += one;
          if (part.minusRow >= 0)
            force(D * part.minusRow + d) -= one;
        }
  }
}

/// \param C minus the derivative of the traction on side +1 (normal, tangents) by the mean jump [Pa/m]
template <int D>
bool ContactInEquilibrium<D>::derive(const Patch& patch, bool symmetric, double (&C)[D][D]) const
{
  const Stiffness k = stiffnessOf(patch);
  C[0][0] = k.normal;
  if (patch.touch == Touch::Sticking)
    for (int t = 1; t < D; ++t)
      C[t][t] = k.tangential;
  // The direction of sliding turns with the slip sideways, without which a body that slides would drift
  // there.
  const double turning = patch.touch == Touch::Sliding && patch.slideRadius > 0.0 && patch.now.pressure > 0.0
                             ? contact_.friction() * patch.now.pressure / patch.slideRadius
                             : 0.0;
  for (int s = 0; s < D - 1 && turning > 0.0; ++s)
    for (int t = 0; t < D - 1; ++t)
      C[1 + s][1 + t] = turning * ((s == t ? 1.0 : 0.0) - patch.direction[s] * patch.direction[t]);
  if (patch.touch == Touch::Sticking || symmetric)
    return true;
  for (int s = 0; s < D - 1; ++s)
    C[1 + s][0] = -contact_.friction() * k.normal * patch.direction[s];
  return contact_.friction() == 0.0;
}

template <int D>
bool ContactInEquilibrium<D>::addStiffness(bool symmetric, const AddBlock& addBlock)
{
  bool isSymmetric = true;
  for (const Patch& patch : patches_.all())
  {
    if (patch.touch == Touch::Open)
      continue;
    double C[D][D] = {};
    isSymmetric = derive(patch, symmetric, C) && isSymmetric;
    const Vector<D> joint = jointStiffness(patch);
    for (const Part& a : patch.parts)
      for (const Part& b : patch.parts)
      {
        if (!a.ofThisRank || !patches_.areCoupled(patch, a, b))
          continue;
        double block[D * D] = {}, opposite[D * D];
        for (int c = 0; c < D; ++c)
          for (int e = 0; e < D; ++e)
            for (int i = 0; i < D && C[c][e] != 0.0; ++i)
              for (int j = 0; j < D; ++j)
                block[D * i + j] += patch.area * a.jump[c][i] * C[c][e] * b.jump[e][j];
        for (int c = 0; c < D; ++c)
          for (int i = 0; i < D && joint[c] != 0.0; ++i)
            for (int j = 0; j < D; ++j)
              block[D * i + j] += joint[c] * a.weight * ((&a == &b ? 1.0 : 0.0) - b.weight / patch.weights) *
                                  a.axes[c][i] * b.axes[c][j];
        for (int k = 0; k < D * D; ++k)
          opposite[k] = -block[k];
        for (const int row : {a.plusRow, a.minusRow})
          for (const int other : {b.plusRow, b.minusRow})
            if (row >= 0 && other >= 0)
              addBlock(row, other, (row == a.plusRow) == (other == b.plusRow) ? block : opposite);
      }
  }
  return isSymmetric;
}

template <int D>
bool ContactInEquilibrium<D>::update()
{
  bool closed = false;
  for (Patch& patch : patches_.all())
  {
    const bool before = patch.touch != Touch::Open;
    choose(patch);
    closed = closed || before || patch.touch != Touch::Open;
  }
  return closed;
}

template <int D>
std::vector<HeldDirection<D>> ContactInEquilibrium<D>::heldDirections() const
{
  const FacePoints<D>& points = contact_.points();
  std::vector<HeldDirection<D>> held;
  for (const Patch& patch : patches_.all())
    if (patch.touch != Touch::Open)
      for (const int k : patch.points)
      {
        HeldDirection<D> one;
        Vector<D> normal;
        for (int d = 0; d < D; ++d)
        {
          one.position[d] = points.position(k, d);
          normal[d] = points.normal(k, d);
        }
        for (const Part& part : patch.parts) // pieces of both faces are among them
          for (const int row : {part.plusRow, part.minusRow})
          {
            if (!part.ofThisRank)
              continue;
            one.row = row;
            one.direction = normal;
            if (row >= 0)
              held.push_back(one);
            for (int t = 0; t < D - 1 && patch.touch == Touch::Sticking && row >= 0; ++t)
            {
              one.direction = patches_.tangent(k, t);
              held.push_back(one);
            }
          }
      }
  return held;
}

template <int D>
int ContactInEquilibrium<D>::reach() const
{
  return mostNodesApart + 1;
}

template <int D>
std::string ContactInEquilibrium<D>::reason() const
{
  std::map<int, std::array<int, 3>> counts; // of each crack's patches: all, closed, sliding
  for (const Patch& patch : patches_.all())
    if (!patch.points.empty())
    {
      std::array<int, 3>& count = counts[patch.crack];
      ++count[0];
      count[1] += patch.touch != Touch::Open ? 1 : 0;
      count[2] += patch.touch == Touch::Sliding ? 1 : 0;
    }
  std::string text;
  for (const auto& [crack, count] : counts)
    if (count[1] > 0 && count[1] == count[2])
      text += (text.empty() ? "" : "; ") + ("all closed faces of crack " + names_[crack] + " slide");
  return text;
}

template <int D>
void ContactInEquilibrium<D>::accept(const State<D>& state)
{
  std::vector<PointContact<D>> found(contact_.points().count());
  double stored = 0.0, lost = 0.0;
  for (const Patch& patch : patches_.all())
  {
    stored -= 0.5 * patch.area * (patch.pressure + patch.now.pressure) * patch.moved[0];
    const double heat = 0.5 * dot(patch.shear + patch.now.shear, slipOf(patch));
    lost += patch.area * heat;
    for (const int k : patch.points)
    {
      PointContact<D>& point = found[k];
      point.acts = true;
      point.gap = patch.gap + patch.moved[0];
      point.pressure = patch.now.pressure;
      point.heat = patch.area / patch.size * heat;
      for (int t = 0; t < D - 1; ++t)
        for (int s = 0; s < D - 1; ++s)
          point.shear[s] +=
              patch.now.shear[t] * dot(patches_.tangent(k, t), tangentOf(contact_.points(), k, s));
    }
  }
  contact_.accept(state, found, stored, lost);
}

template class ContactInEquilibrium<2>;
template class ContactInEquilibrium<3>;

} // namespace Rhegma::contact
