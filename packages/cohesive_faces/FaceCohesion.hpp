#pragma once
/// Cohesion of the faces of cracks: tractions by their jump at points on the faces.

#include "cohesive_faces/TractionLaw.hpp"
#include "transfer/FacePoints.hpp"

#include <functional>
#include <vector>

namespace Rhegma::cohesive_faces
{

/// Whether faces hold at a position of the undeformed body: in it, and not free from the start.
template <int D>
using HoldsAt = std::function<bool(int crack, const Vector<D>& position)>;

/// What is recorded of one crack with cohesive faces.
template <int D>
struct CohesionRecord
{
  double initiated = -1.0;     ///< time of the first damage [s]; negative: never
  Vector<D> first{};           ///< where that was [m]
  double largestOpening = 0.0; ///< ever, of a bonded point [m]
  double largestSlip = 0.0;    ///< the same [m]
};

/// Sums over the points of one crack. Lengths are areas in 3D, all undeformed [m, m2].
template <int D>
struct CohesionSums
{
  double bonded = 0.0;         ///< that held at the start
  double damaged = 0.0;        ///< of it: past the largest traction
  double failed = 0.0;         ///< of it: without traction (failedFraction)
  Vector<D> reach{};           ///< failed point farthest from the first damage [m]
  double stored = 0.0;         ///< now [J]
  double lost[2] = {0.0, 0.0}; ///< dissipated so far by opening and by slip, by the law [J]
};

/// A face point as a step of equilibrium has found it.
template <int D>
struct FoundPoint
{
  double gap = 0.0;     ///< [m]
  Vector<D - 1> slip{}; ///< [m]
  Cohesion<D> now{};
};

/// Cohesion at the face points of all cracks, which all ranks have and move on alike.
///
/// Gap and slip of a point, zero in the undeformed state, follow the jump of the velocity that strains the
/// particles, as those of contact do: the faces are an interface in series with the cells next to it.
/// Components are along the normal and the tangents of the crack, which turn with it. In the energy balance
/// the work of a step is that of the mean traction: its part that unloading would return is stored, the rest
/// is dissipated. What each point has dissipated is that of the law, without an error of the step.
template <int D>
class FaceCohesion
{
public:
  /// \param laws of each crack; those without a law do not hold
  void setLaws(const std::vector<TractionLaw>& laws, HoldsAt<D> holdsAt);

  /// Finds points and stencils for this step; needs nodal masses. \return the change of the stored energy [J]
  /// where points were replaced
  double prepare(const State<D>& state);

  /// Adds the tractions' forces [N], opposite on the two faces.
  void addForces(const State<D>& state) const;
  /// The same to the first D columns of a row a node.
  void addForces(const View<double * [D + 1]>& force) const;

  /// Moves gaps and slips on by dt with a nodal velocity (first D columns), and finds the tractions.
  template <class Velocity>
  void advance(const State<D>& state, const Velocity& velocity);

  /// Takes what a step of equilibrium has found, a value a point.
  void accept(const State<D>& state, const std::vector<FoundPoint<D>>& found);

  /// Saves or loads the points with their history.
  void serialize(Archive& archive);

  const FacePoints<D>& points() const { return points_; }
  const View<TractionLaw*>& laws() const { return laws_; }
  const View<double*>& gap() const { return gap_; }
  const View<double* [D - 1]>& slip() const { return slip_; } const View<double*>& secant() const
  {
    return secant_;
  }
  const View<double*>& spent() const { return spent_; }
  const View<double*>& bonded() const { return bonded_; } ///< fraction of a point's size
  const View<double*>& pressure() const { return pressure_; }
  const View<double* [D - 1]>& shear() const { return shear_; } double thickness() const
  {
    return thickness_;
  }

  double stored() const { return stored_; }   ///< [J]
  double dissipated() const { return lost_; } ///< by the work of the steps [J]
  const std::vector<CohesionRecord<D>>& records() const { return records_; }

  /// Sums over the points of a crack as they are now; a loop on the host.
  CohesionSums<D> sumsOf(int crack) const;

  /// Part of `advance`; public because compilers for devices want kernels in public functions.
  void takeJumps(double dt);

private:
  void storeHistory(const View<double*>& size);
  void bond(const View<double*>& earlier);
  double storedNow() const;
  void noteStart(double time);

  FacePoints<D> points_;
  View<TractionLaw*> laws_;
  HoldsAt<D> holdsAt_;
  View<double*> gap_;            ///< opening since the undeformed state [m]
  View<double * [D - 1]> slip_;  ///< side +1 against side -1, along the tangents [m]
  View<double*> secant_;         ///< s of the law
  View<double*> spent_;          ///< fraction of G_c dissipated
  View<double*> bonded_;         ///< fraction of a point's size that holds
  View<double*> pressure_;       ///< minus the normal traction, mean over the point [Pa]
  View<double * [D - 1]> shear_; ///< that holds back side +1, mean over the point [Pa]
  View<double*> jump_;           ///< of each point, of the velocity, D numbers [m/s]
  View<double*> heat_[2];        ///< dissipated at each point by opening and slip, by its size [J/m2]
  View<double* [2]> largest_;    ///< of each crack: opening and slip [m]
  View<int*> damaged_;           ///< of each crack: points past the largest traction
  double thickness_ = 1.0;
  double stored_ = 0.0, lost_ = 0.0;
  std::vector<CohesionRecord<D>> records_;
};

/// Mean tractions over a point of which a part holds. Where faces press, all of it does.
template <int D>
KOKKOS_INLINE_FUNCTION Cohesion<D> meanOf(Cohesion<D> now, double bonded)
{
  now.tension = (now.presses ? 1.0 : bonded) * now.tension;
  now.shear = bonded * now.shear;
  return now;
}

} // namespace Rhegma::cohesive_faces
