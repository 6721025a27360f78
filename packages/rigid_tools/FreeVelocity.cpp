#include "rigid_tools/FreeVelocity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace Rhegma::rigid_tools
{

namespace
{

/// Residual of the momentum of a tool below which a velocity is a solution, as a fraction of the sum of the
/// sizes of its terms: rounding of sums over thousands of contacts is less.
constexpr double settled = 1e-12;

/// Residual with which Newton's method ends at once, in the same way.
constexpr double exact = 1e-15;

constexpr int mostNewtonSteps = 50;
constexpr int mostMinimumSteps = 400;
/// Rounds in which bounds of friction follow the pressure; after half of them by half of the difference.
constexpr int mostRounds = 40;
/// Rounds in which they are lowered to it; after these they become zero, so that there are few more rounds.
constexpr int mostLowered = 20;

/// The difference of a bound from the friction that the law allows up to which the two are equal.
constexpr double sameBound = 1e-12;

/// Momentum that a tool has too much at a velocity, its derivative, and the sum of the sizes of its terms.
template <int D>
struct Residual
{
  Vector<D> value{};
  double matrix[D][D]{};
  double scale = 0.0;

  double size() const { return norm(value); }
  bool isSettled(double fraction) const { return !(size() > fraction * scale); }
};

/// How a field moves relative to a tool, as impulses: all after which both move alike.
template <int D>
struct Alike
{
  double pressing = 0.0; ///< along the normal
  Vector<D> along{};     ///< along the face
  double size = 0.0;     ///< of that
};

template <int D>
Alike<D> alikeAt(const FieldAtTool<D>& field, const Vector<D>& velocity)
{
  Vector<D> all{};
  for (int d = 0; d < D; ++d)
    all[d] = field.free[d] ? field.mass * (velocity[d] - field.velocity[d]) : 0.0;
  Alike<D> alike;
  alike.pressing = dot(all, field.normal);
  alike.along = all - alike.pressing * field.normal;
  alike.size = norm(alike.along);
  return alike;
}

/// The friction that a law allows, and whether the surfaces do not slide.
struct Allowed
{
  double friction = 0.0; ///< [N s]
  double slope = 0.0;    ///< its derivative by the pressure
  bool sticks = false;
};

template <int D>
Allowed allowedBy(const FrictionLaw& law, const Alike<D>& alike)
{
  if (!(alike.pressing > 0.0))
    return {};
  if (law.atRest > 0.0 && alike.size <= law.atRest * alike.pressing)
    return {law.atRest * alike.pressing, 0.0, true};
  return {law.sliding > 0.0 ? law.sliding * alike.pressing : 0.0, law.sliding, false};
}

template <int D>
class Search
{
public:
  Search(const MovingMass<D>& tool, const std::vector<FieldAtTool<D>>& fields) : tool_(tool), fields_(fields)
  {
  }

  FreeVelocity<D> run()
  {
    velocity_ = tool_.guess;
    if (newton() || follow())
      return solution();
    lower();
    return solution();
  }

private:
  /// At a velocity, by the law or, with bounds of friction, by these.
  Residual<D> residualAt(const Vector<D>& velocity) const
  {
    Residual<D> sum;
    for (std::size_t c = 0; c < fields_.size(); ++c)
      add(c, velocity, sum);
    for (int i = 0; i < D; ++i)
    {
      const double terms[] = {tool_.mass * velocity[i], tool_.mass * tool_.alone[i]};
      sum.scale += std::fabs(terms[0]) + std::fabs(terms[1]);
      sum.value[i] = tool_.moves[i] ? sum.value[i] + (terms[0] - terms[1]) : 0.0;
      for (int j = 0; j < D; ++j)
        sum.matrix[i][j] =
            (i == j ? tool_.mass : 0.0) + (tool_.moves[i] && tool_.moves[j] ? sum.matrix[i][j] : 0.0);
    }
    return sum;
  }

  void add(std::size_t c, const Vector<D>& velocity, Residual<D>& sum) const
  {
    const FieldAtTool<D>& field = fields_[c];
    if (!isContact(field))
      return;
    const Alike<D> alike = alikeAt(field, velocity);
    const bool presses = alike.pressing > 0.0;
    const Allowed allowed = bounds_.empty() ? allowedBy(tool_.law, alike) : Allowed{bounds_[c], 0.0, false};
    const bool sticks = allowed.friction > 0.0 && alike.size <= allowed.friction;
    const double fraction = sticks ? 1.0 : alike.size > 0.0 ? allowed.friction / alike.size : 0.0;
    const Vector<D> impulse = (presses ? alike.pressing : 0.0) * field.normal + fraction * alike.along;
    const Vector<D> direction = (alike.size > 0.0 ? 1.0 / alike.size : 0.0) * alike.along;
    sum.value = sum.value + impulse;
    sum.scale += norm(impulse);
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
      {
        const double across = field.normal[i] * field.normal[j];
        double slope = presses ? across : 0.0;
        slope += fraction * ((i == j && field.free[i] ? 1.0 : 0.0) - across);
        if (!sticks)
        {
          // Friction turns with the direction of sliding, and follows the pressure.
          slope -= fraction * direction[i] * direction[j];
          slope += presses ? allowed.slope * direction[i] * field.normal[j] : 0.0;
        }
        sum.matrix[i][j] += field.mass * slope;
      }
  }

  static bool isContact(const FieldAtTool<D>& field)
  {
    return field.mass > 0.0 && dot(field.normal, field.normal) > 0.0;
  }

  /// The change of the velocity in which the linear residual is zero; zero if there is none.
  static Vector<D> stepOf(Residual<D> at)
  {
    Vector<D> right = -1.0 * at.value;
    for (int i = 0; i < D; ++i)
    {
      int pivot = i;
      for (int k = i + 1; k < D; ++k)
        pivot = std::fabs(at.matrix[k][i]) > std::fabs(at.matrix[pivot][i]) ? k : pivot;
      if (!(std::fabs(at.matrix[pivot][i]) > 0.0))
        return {};
      std::swap(right[i], right[pivot]);
      for (int j = 0; j < D; ++j)
        std::swap(at.matrix[i][j], at.matrix[pivot][j]);
      for (int k = i + 1; k < D; ++k)
      {
        const double factor = at.matrix[k][i] / at.matrix[i][i];
        for (int j = i; j < D; ++j)
          at.matrix[k][j] -= factor * at.matrix[i][j];
        right[k] -= factor * right[i];
      }
    }
    for (int i = D - 1; i >= 0; --i)
    {
      for (int j = i + 1; j < D; ++j)
        right[i] -= at.matrix[i][j] * right[j];
      right[i] /= at.matrix[i][i];
    }
    return right;
  }

  /// Newton's method on the law of friction. \return whether it has found a solution
  bool newton()
  {
    std::vector<double> bounds;
    bounds.swap(bounds_);
    Vector<D> velocity = velocity_;
    Residual<D> now = residualAt(velocity);
    for (int k = 0; k < mostNewtonSteps && !now.isSettled(exact); ++k)
    {
      const Vector<D> step = stepOf(now);
      const double least = now.isSettled(settled) ? 0.6 : 1e-3;
      bool falls = false;
      for (double fraction = 1.0; fraction > least && !falls; fraction *= 0.5)
      {
        const Vector<D> next = velocity + fraction * step;
        const Residual<D> then = residualAt(next);
        falls = then.size() < (1.0 - 1e-4 * fraction) * now.size();
        if (!falls)
          continue;
        velocity = next;
        now = then;
      }
      if (!falls)
        break;
    }
    if (now.isSettled(settled))
    {
      velocity_ = velocity;
      return true;
    }
    bounds.swap(bounds_);
    return false;
  }

  /// Finds the velocity for the bounds of friction. The residual is the gradient of a convex function, which
  /// falls along a step as long as the gradient along it is negative.
  void minimize()
  {
    Residual<D> now = residualAt(velocity_);
    for (int k = 0; k < mostMinimumSteps && !now.isSettled(exact); ++k)
    {
      const Vector<D> step = stepOf(now);
      const bool wholeToo = 2 * k < mostMinimumSteps; // close to the minimum whole steps end it
      double fraction = 1.0;
      Residual<D> then = residualAt(velocity_ + step);
      while (fraction > 1e-12 && dot(then.value, step) > 0.0 && !(wholeToo && then.size() < 0.5 * now.size()))
      {
        fraction *= 0.5;
        then = residualAt(velocity_ + fraction * step);
      }
      if (!(then.size() < now.size()) && now.isSettled(settled))
        return;
      velocity_ = velocity_ + fraction * step;
      now = then;
    }
  }

  Allowed allowedAt(std::size_t c) const
  {
    return isContact(fields_[c]) ? allowedBy(tool_.law, alikeAt(fields_[c], velocity_)) : Allowed{};
  }

  /// Bounds of friction follow the pressure. \return whether there is a solution with the law
  bool follow()
  {
    velocity_ = tool_.guess;
    bounds_.assign(fields_.size(), 0.0);
    for (int k = 0; k < mostRounds; ++k)
    {
      minimize();
      for (std::size_t c = 0; c < fields_.size(); ++c)
      {
        const double allowed = allowedAt(c).friction;
        const bool half = 2 * k > mostRounds && std::isfinite(allowed) && std::isfinite(bounds_[c]);
        bounds_[c] = half ? 0.5 * (bounds_[c] + allowed) : allowed;
      }
      if (newton())
        return true;
    }
    return false;
  }

  /// The friction that the law allows where it is limited by the bounds.
  double allowedInBounds(std::size_t c, const Alike<D>& alike) const
  {
    if (bounds_.empty())
      return allowedBy(tool_.law, alike).friction;
    if (!(alike.pressing > 0.0))
      return 0.0;
    const double coefficient = alike.size <= bounds_[c] ? tool_.law.atRest : tool_.law.sliding;
    return coefficient > 0.0 ? coefficient * alike.pressing : 0.0;
  }

  /// Lowers bounds that are above what the law allows, until there are none. A bound becomes zero at most
  /// once, so that this ends.
  void lower()
  {
    bool any = true;
    for (std::size_t k = 0; any && k < mostLowered + fields_.size() + 1; ++k)
    {
      minimize();
      any = false;
      for (std::size_t c = 0; c < fields_.size(); ++c)
      {
        if (!isContact(fields_[c]))
          continue;
        const double allowed = allowedInBounds(c, alikeAt(fields_[c], velocity_));
        if (!(bounds_[c] > (1.0 + sameBound) * allowed))
          continue;
        any = true;
        bounds_[c] = k < mostLowered ? allowed : 0.0;
      }
    }
  }

  FreeVelocity<D> solution() const
  {
    FreeVelocity<D> found;
    found.velocity = velocity_;
    found.contacts.resize(fields_.size());
    for (std::size_t c = 0; c < fields_.size(); ++c)
    {
      if (!isContact(fields_[c]))
        continue;
      const Alike<D> alike = alikeAt(fields_[c], velocity_);
      if (!(alike.pressing > 0.0))
        continue;
      const double allowed = allowedInBounds(c, alike);
      const double bound = bounds_.empty() ? allowed : std::min(allowed, bounds_[c]);
      ContactImpulse<D>& contact = found.contacts[c];
      contact.sticks = bound > 0.0 && alike.size <= bound;
      const double fraction = contact.sticks ? 1.0 : alike.size > 0.0 ? bound / alike.size : 0.0;
      contact.pressing = alike.pressing;
      contact.impulse = alike.pressing * fields_[c].normal + fraction * alike.along;
      const bool less = !contact.sticks && bound < (1.0 - 1e-9) * tool_.law.sliding * alike.pressing;
      found.cut += tool_.law.sliding > 0.0 && less ? 1 : 0;
    }
    return found;
  }

  const MovingMass<D>& tool_;
  const std::vector<FieldAtTool<D>>& fields_;
  Vector<D> velocity_{};
  std::vector<double> bounds_; ///< of the friction of each contact [N s]; empty: by the law
};

} // namespace

template <int D>
FreeVelocity<D> findFreeVelocity(const MovingMass<D>& tool, const std::vector<FieldAtTool<D>>& fields)
{
  return Search<D>(tool, fields).run();
}

template FreeVelocity<2> findFreeVelocity(const MovingMass<2>&, const std::vector<FieldAtTool<2>>&);
template FreeVelocity<3> findFreeVelocity(const MovingMass<3>&, const std::vector<FieldAtTool<3>>&);

} // namespace Rhegma::rigid_tools
