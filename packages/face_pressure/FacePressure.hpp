#pragma once
/// The effect `Face Pressure`: a pressure between the faces of a crack.

#include "plan/Effect.hpp"
#include "scene/TimeFunction.hpp"
#include "transfer/FacePoints.hpp"

namespace Rhegma::face_pressure
{

/// The effect `Face Pressure`.
EffectEntry facePressureEntry();

/// A pressure given in time on both faces of one crack.
///
/// At every face point the faces get the opposite forces p n A, A the current area and n the current normal,
/// so the sum over all nodes is zero to round-off.
class FacePressure
{
public:
  FacePressure(int crack, TimeFunction history) : crack_(crack), history_(std::move(history)) {}

  /// Adds the forces [N] of the middle of this step to the nodes.
  template <int D>
  void apply(State<D>& state, const FacePoints<D>& points);

  /// Work [J] of the forces in this step, on the displacement of the faces.
  template <int D>
  double work(const State<D>& state, const FacePoints<D>& points) const;

  double pressure() const { return now_; } ///< [Pa]
  void serialize(Archive& archive);
  int crack() const { return crack_; }

private:
  int crack_;
  TimeFunction history_;
  double now_ = 0.0, works_ = 0.0;
};

} // namespace Rhegma::face_pressure
