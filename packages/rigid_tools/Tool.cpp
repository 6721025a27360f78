#include "rigid_tools/Tool.hpp"

#include "archive/Archive.hpp"
#include "base/ReadList.hpp"
#include "scene/BondedGroups.hpp"
#include "scene/FrictionSection.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace Rhegma::rigid_tools
{

namespace
{

constexpr double degreesPerRadian = 57.295779513082320877;

template <int D>
RigidVelocity<D> scaled(const RigidVelocity<D>& unit, double factor)
{
  RigidVelocity<D> v;
  v.ofCentre = factor * unit.ofCentre;
  for (int k = 0; k < spinSize<D>; ++k)
    v.spin[k] = factor * unit.spin[k];
  return v;
}

template <int D>
double sizeOfSpin(const RigidVelocity<D>& velocity)
{
  double square = 0.0;
  for (const double spin : velocity.spin)
    square += spin * spin;
  return std::sqrt(square);
}

TimeFunction historyOf(const Teuchos::ParameterList& list, const std::string& name)
{
  return TimeFunction::parse(list.isParameter(name) ? list.get<std::string>(name) : "1");
}

template <int D>
FreeMass<D> readMass(const Teuchos::ParameterList& list)
{
  FreeMass<D> mass;
  if (!list.isParameter("Mass"))
    return mass;
  mass.mass = list.get<double>("Mass");
  const std::string axes = list.isParameter("Components") ? list.get<std::string>("Components") : "xyz";
  for (int d = 0; d < D; ++d)
    mass.free[d] = axes.find(static_cast<char>('x' + d)) != std::string::npos;
  mass.release = list.isParameter("Release Time") ? list.get<double>("Release Time") : 0.0;
  if (list.isParameter("Force"))
    mass.force = readVector<D>(list, "Force");
  mass.history = historyOf(list, "Force History");
  return mass;
}

} // namespace

template <int D>
Tool<D>::Tool(const Teuchos::ParameterList& list, std::string name)
    : name_(std::move(name)),
      shape_(makeShape<D>(list)),
      law_(readFrictionLaw(list)),
      history_(historyOf(list, "History")),
      mass_(readMass<D>(list))
{
  if (list.isParameter("Bodies"))
    bodies_ = splitNames(list.get<std::string>("Bodies"));
  const auto bounds = shape_.bounds();
  placement_.centre = list.isParameter("Pivot") ? readVector<D>(list, "Pivot") : bounds.centre();
  unit_.ofCentre = readVector<D>(list, "Velocity");
  const auto spin = list.get<Teuchos::Array<double>>("Angular Velocity");
  std::copy_n(spin.begin(), spinSize<D>, unit_.spin);
  for (int d = 0; d < D; ++d)
    if (hasMass() && !mass_.free[d])
      unit_.ofCentre[d] = 0.0;
  for (const Vector<D>& corner : bounds.corners())
    radius_ = std::max(radius_, norm(corner - placement_.centre));
  if (hasMass() && !(mass_.release > 0.0))
  {
    released_ = started_ = true;
    now_ = before_ = unit_;
  }
}

template <int D>
double Tool<D>::distanceFrom(const Placement<D>& earlier) const
{
  double turned = 0.0; // the largest change of a unit vector
  for (int d = 0; d < D; ++d)
    turned += dot(placement_.axes[d] - earlier.axes[d], placement_.axes[d] - earlier.axes[d]);
  return norm(placement_.moved - earlier.moved) + radius_ * std::sqrt(turned);
}

template <int D>
double Tool<D>::longestStep(double time, double distance, double most) const
{
  if (hasMass())
  {
    const bool moves = released_ || time + most >= mass_.release;
    const double speed = !moves ? 0.0 : released_ ? norm(now_.ofCentre) : norm(unit_.ofCentre);
    const double factor = moves ? std::fabs(mass_.history.overStep(time, time + most)) : 0.0;
    const double acceleration = norm(mass_.force) * factor / mass_.mass;
    const double root = std::sqrt(speed * speed + 4.0 * acceleration * distance);
    // The velocity at the end of a step moves it: speed dt + acceleration dt^2.
    return root > 0.0 ? std::min(most, 2.0 * distance / (speed + root)) : most;
  }
  const double unit = norm(unit_.ofCentre) + radius_ * sizeOfSpin(unit_);
  constexpr int mostTrials = 60;
  double step = most;
  for (int k = 0; k < mostTrials; ++k)
  {
    const double speed = unit * std::fabs(history_.overStep(time, time + step));
    if (!(speed * step > distance))
      return step;
    step = std::min(0.5 * step, distance / speed);
  }
  return step;
}

template <int D>
double Tool<D>::kineticEnergy() const
{
  return 0.5 * mass_.mass * dot(now_.ofCentre, now_.ofCentre);
}

template <int D>
double Tool<D>::beginStep(double time, double dt)
{
  double given = 0.0;
  if (!hasMass())
  {
    before_ = started_ ? now_ : scaled(unit_, history_(time));
    factor_ = history_.overStep(time, time + dt);
    now_ = scaled(unit_, factor_);
  }
  else
  {
    if (!released_ && time >= mass_.release - 0.5 * dt)
    {
      released_ = true;
      now_ = unit_;
      given = kineticEnergy();
    }
    before_ = now_;
    push_ = released_ ? mass_.history.overStep(time, time + dt) * mass_.force : Vector<D>{};
    for (int d = 0; d < D; ++d)
    {
      push_[d] = moves(d) ? push_[d] : 0.0;
      now_.ofCentre[d] += dt / mass_.mass * push_[d];
    }
  }
  started_ = true;
  return given;
}

template <int D>
double Tool<D>::endStep(double dt)
{
  placement_.moved = placement_.moved + dt * now_.ofCentre;
  turned_ += dt * factor_;
  turn();
  return dt * dot(push_, meanVelocity().ofCentre);
}

template <int D>
void Tool<D>::turn()
{
  const double size = sizeOfSpin(unit_);
  if (!(size > 0.0))
    return;
  if constexpr (D == 2)
    placement_.axes = Geometry::turnedAxes(degreesPerRadian * unit_.spin[0] * turned_);
  else
    placement_.axes = Geometry::turnedAxes(degreesPerRadian * size * turned_,
                                           Vector<3>{{unit_.spin[0], unit_.spin[1], unit_.spin[2]}});
}

template <int D>
void Tool<D>::serialize(Archive& archive)
{
  archive("moved", placement_.moved);
  archive("turned", turned_);
  archive("velocity", now_.ofCentre);
  archive("spin", now_.spin);
  archive("started", started_);
  archive("released", released_);
  if (archive.loads())
    turn();
}

template class Tool<2>;
template class Tool<3>;

} // namespace Rhegma::rigid_tools
