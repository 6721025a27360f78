#pragma once
/// Contact of the faces of cracks: a penalty traction at points on the faces.

#include "contact/ContactLaw.hpp"
#include "transfer/FacePoints.hpp"

#include <vector>

namespace Rhegma::contact
{

/// What is recorded of one crack.
struct CrackContact
{
  int closedPoints = 0;         ///< points under pressure now
  int touches = 0;              ///< how often an open crack has begun to touch
  double firstTouch = -1.0;     ///< time of the first [s]; negative: never
  double largestPressure = 0.0; ///< ever, at a point [Pa]
};

/// Contact at a face point as a step of equilibrium has found it.
template <int D>
struct PointContact
{
  bool acts = false;
  double gap = 0.0, pressure = 0.0; ///< [m, Pa]
  Vector<D - 1> shear{};            ///< traction that holds back side +1, along the point's tangents [Pa]
  double heat = 0.0;                ///< dissipated over the step [J/m2]
};

/// Contact at the face points of all cracks, which all ranks have and move on alike.
///
/// The gap of a point, zero in the undeformed state, follows the normal jump of the velocity that strains the
/// particles, and so does its elastic slip the tangential jump: contact is an elastic layer in series with
/// the cells next to it and conserves energy as they do. Where the gap is negative the faces press each other
/// with p = kn <-gap>; the shear traction kt s is limited to mu p, the rest is plastic slip (return mapping:
/// Wriggers, Computational Contact Mechanics, 2nd ed., Springer 2006, ch. 5). Gap and slip are components
/// along the normal and the tangents of the crack, which turn with it.
template <int D>
class FaceContact
{
public:
  /// \param friction coefficient; used by Coulomb \param alpha stiffness in units of modulus / cell size
  FaceContact(Law law, double friction, double alpha) : law_(law), friction_(friction), alpha_(alpha) {}

  /// Finds points and stencils for this step; needs nodal masses. \return the change of the stored energy [J]
  /// where points were replaced, as those that inherit stand for other pieces; the dissipated energy does not
  /// change
  double prepare(const State<D>& state);

  /// Adds the tractions' forces [N]: opposite ones on the two faces, so momentum is kept to round-off.
  void addForces(const State<D>& state) const;
  /// The same to the first D columns of a row a node.
  void addForces(const View<double * [D + 1]>& force) const;

  /// The tractions on a crack, in the order of its points.
  std::vector<FaceTraction<D>> tractions(int crack) const;

  /// Forces at points all of whose nodes are subcycled follow these nodes; the others are frozen.
  void addFrozenForces(const State<D>& state, const NodeSlots& slots, const View<double* [D]>& force) const;
  void addChange(const State<D>& state, const NodeSlots& slots, const View<double* [D]>& displacement,
                 const View<double* [D]>& force) const;

  /// Moves gaps and slips on by dt with a nodal velocity (first D columns), finds the tractions, and adds
  /// what friction dissipates.
  template <class Velocity>
  void advance(const State<D>& state, const Velocity& velocity);

  /// Takes what a step of equilibrium has found, a value a point. \param stored change of the energy of the
  /// layer [J] \param lost dissipated by friction [J]
  void accept(const State<D>& state, const std::vector<PointContact<D>>& found, double stored, double lost);

  /// Saves or loads the points with their history.
  void serialize(Archive& archive);

  const FacePoints<D>& points() const { return points_; }
  const View<double*>& gap() const { return gap_; }
  const View<double* [D - 1]>& slip() const { return slip_; } const View<double*>& pressure() const
  {
    return pressure_;
  }
  const View<double* [D - 1]>& shear() const { return shear_; } Law law() const { return law_; }
  double friction() const { return law_ == Law::Coulomb ? friction_ : 0.0; }
  bool pointsReplaced() const { return replaced_; } ///< by the last `prepare`
  Stiffness stiffnessOf(int crack) const { return onHost(stiffness_)(crack); }

  /// Energy [J] that the layer holds now and that friction has dissipated so far.
  double stored() const { return stored_; }
  double dissipated() const { return dissipated_; }

  /// The same over the points for which `part` is not zero.
  double storedIn(const View<int*>& part) const;
  double dissipatedIn(const View<int*>& part) const;

  const std::vector<CrackContact>& cracks() const { return cracks_; }

private:
  void findStiffness(const State<D>& state);
  void storeCracks(Archive& archive);
  void storeHistory(const View<double*>& size);
  void note(const State<D>& state);

  Law law_;
  double friction_, alpha_;
  FacePoints<D> points_;
  View<Stiffness*> stiffness_;   ///< of each crack
  View<double*> gap_;            ///< opening of the faces since the undeformed state [m]
  View<double * [D - 1]> slip_;  ///< elastic slip, side +1 against side -1 along the tangents [m]
  View<double*> pressure_;       ///< [Pa]
  View<double * [D - 1]> shear_; ///< traction that holds back side +1, along the tangents [Pa]
  View<double*> jump_;           ///< of each point, of the velocity from side -1 to side +1, D numbers [m/s]
  View<double*> heat_;           ///< dissipated at each point so far, by its undeformed size [J/m2]
  View<int*> closed_;            ///< points of each crack that press
  View<double*> peak_;           ///< largest pressure of each crack [Pa]
  double thickness_ = 1.0;
  bool replaced_ = false;
  double stored_ = 0.0, dissipated_ = 0.0;
  std::vector<CrackContact> cracks_;
};

} // namespace Rhegma::contact
