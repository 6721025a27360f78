#pragma once
/// Bodies that move as one, because they share nodes.

#include "geometry/NearBoxes.hpp"
#include "plan/BoundaryType.hpp"
#include "plausibility/BodyMeasures.hpp"

namespace Rhegma
{

template <int D>
struct BodyGroup
{
  Geometry::Bounds<D> bounds; ///< of all its bodies [m]
  double mass = 0.0;          ///< [kg]
  std::vector<int> bodies{};  ///< their numbers
};

/// The groups of a scene: of bodies whose bounds come within two cells. They are found for the bodies that
/// are asked for.
template <int D>
class BodyGroups
{
public:
  /// \param bodies kept by the caller \param cell [m]
  BodyGroups(const std::vector<BodyMeasure<D>>& bodies, double cell);

  /// Number of the group of a body.
  int of(int body);

  const BodyGroup<D>& operator[](int number) const { return groups_[number]; }
  int count() const { return static_cast<int>(groups_.size()); }

  /// Bodies whose bounds come within a distance of a box [m].
  std::vector<int> near(const Geometry::Bounds<D>& box, double gap) const { return boxes_.near(box, gap); }

  /// Whether another body, or a support that does not hold the group, is in the way of its motion.
  bool isStopped(int number, const Vector<D>& by, const std::vector<BoundaryRegion>& supports) const;

private:
  const std::vector<BodyMeasure<D>>& bodies_;
  double cell_;                             ///< [m]
  std::vector<Geometry::Bounds<D>> bounds_; ///< of the bodies
  Geometry::NearBoxes<D> boxes_;
  std::vector<int> groupOf_; ///< by body; -1: not asked for
  std::vector<BodyGroup<D>> groups_;
};

/// Whether the scene gives one of these bodies a velocity.
template <int D>
bool isThrown(const Teuchos::ParameterList& scene, const std::vector<BodyMeasure<D>>& bodies,
              const std::vector<int>& numbers);

} // namespace Rhegma
