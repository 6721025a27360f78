#pragma once
/// A rigid tool: its shape, what moves it, and where it is.

#include "geometry/Shape.hpp"
#include "material/FrictionLaw.hpp"
#include "rigid_tools/RigidMotion.hpp"
#include "scene/TimeFunction.hpp"

#include <Teuchos_ParameterList.hpp>

#include <string>
#include <vector>

namespace Rhegma
{
class Archive;
}

namespace Rhegma::rigid_tools
{

/// A tool that moves as a mass, without rotation.
template <int D>
struct FreeMass
{
  double mass = 0.0;                               ///< [kg]
  bool free[D]{};                                  ///< axes along which it moves; others are held
  double release = 0.0;                            ///< until then it is held along all axes [s]
  Vector<D> force{};                               ///< on it, to be multiplied by `history` [N]
  TimeFunction history = TimeFunction::parse("1"); ///< of the force
};

/// A rigid tool.
template <int D>
class Tool
{
public:
  /// \param list of the tool, validated \param name of the tool
  Tool(const Teuchos::ParameterList& list, std::string name);

  const std::string& name() const { return name_; }            ///< as in the scene
  const Shape<D>& shape() const { return shape_; }             ///< where the scene has it
  const Placement<D>& placement() const { return placement_; } ///< where it is now
  const RigidVelocity<D>& velocity() const { return now_; } ///< at the end of the step, or since the last one
  /// Mean of the velocities at the start and at the end of the step.
  RigidVelocity<D> meanVelocity() const { return meanOf(before_, now_); }
  const FrictionLaw& law() const { return law_; }                    ///< of its surface
  const std::vector<std::string>& bodies() const { return bodies_; } ///< that it touches; empty: all

  /// Whether it moves by its mass.
  bool hasMass() const { return mass_.mass > 0.0; }
  const FreeMass<D>& mass() const { return mass_; } ///< zero without one
  /// Whether forces move it along an axis in this step.
  bool moves(int axis) const { return released_ && mass_.free[axis]; }

  /// A vector along the axes along which forces move it, zero along others.
  Vector<D> freePart(Vector<D> vector) const
  {
    for (int d = 0; d < D; ++d)
      vector[d] = moves(d) ? vector[d] : 0.0;
    return vector;
  }

  /// Largest distance that a point of it has moved since it was at another place [m].
  double distanceFrom(const Placement<D>& earlier) const;
  /// The longest step from a time on in which none of its points moves farther than a distance without
  /// contact, `most` at most. \param time begin of the step [s] \param distance [m] \param most [s]
  double longestStep(double time, double distance, double most) const;
  /// The ball around it, with all of its points: centre and radius [m].
  Vector<D> middle() const { return placement_.centre + placement_.moved; }
  double radius() const { return radius_; } ///< of the ball around it [m]
  /// Its kinetic energy; 0 without a mass [J].
  double kineticEnergy() const;

  /// Velocity at the end of a step from `time` on without contact; the work of its force is added when the
  /// step ends. \return energy that it gets because it is released with a velocity [J]
  double beginStep(double time, double dt);
  /// The velocity of the centre with contact [m/s].
  void setVelocity(const Vector<D>& velocity) { now_.ofCentre = velocity; }
  /// Moves it. \return the work of its force in the step [J]
  double endStep(double dt);

  /// Saves or loads its motion.
  void serialize(Archive& archive);

private:
  void turn();

  std::string name_;
  Shape<D> shape_;
  FrictionLaw law_;
  std::vector<std::string> bodies_;
  RigidVelocity<D> unit_; ///< prescribed, to be multiplied by `history_`; of a mass: the velocity at release
  TimeFunction history_;
  FreeMass<D> mass_;
  double radius_ = 0.0; ///< largest distance of its points from the centre of rotation [m]

  Placement<D> placement_;
  double turned_ = 0.0; ///< integral of the history [s]
  double factor_ = 0.0; ///< of `unit_` in this step
  bool started_ = false, released_ = false;
  RigidVelocity<D> before_, now_;
  Vector<D> push_{}; ///< force on it in this step [N]
};

} // namespace Rhegma::rigid_tools
