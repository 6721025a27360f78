#pragma once
/// Contact of the faces of cracks over a step of equilibrium.

#include "contact/ContactPatches.hpp"
#include "state/StepForce.hpp"

#include <string>
#include <vector>

namespace Rhegma::contact
{

/// Contact without overlap by augmented Lagrangians (Simo and Laursen, Comput. Struct. 42 (1992) 97) and an
/// active set (Hueber, Stadler and Wohlmuth, SIAM J. Sci. Comput. 30 (2008) 572).
///
/// The law is that of the face points in dynamics (ContactLaw.hpp), a pressure kn <-g> and a return map of
/// the shear traction, at patches of face points (FacePatches.hpp) with their mean gap and slip, and shifted
/// by multipliers: p = <l - kn g>. After each iteration of Newton's method the law says which patches are
/// open, stick or slide in the next one, and the multipliers take the tractions found, so that gap and
/// elastic slip go to zero with the residual; kn sets only how fast. A patch that slides and would slide back
/// sticks next.
///
/// Faces that touch at the start of a step are taken to stick by the first iteration. Faces that meet within
/// a step have no shear traction at its end, as in dynamics.
///
/// Forces act on nodes with two fields, in proportion to the areas of their faces (FaceNodes.hpp), equal and
/// opposite on both. The nodes of a patch that presses have one normal jump, and one tangential jump until it
/// slides: forces on them whose sum is zero keep them together. They do so until the patch has opened, or
/// begun to slide, twice in the iterations of a step.
template <int D>
class ContactInEquilibrium : public StepForce<D>
{
public:
  using typename StepForce<D>::Values;
  using typename StepForce<D>::Groups;
  using typename StepForce<D>::AddBlock;

  /// \param contact whose points and history it uses, and must outlive it
  explicit ContactInEquilibrium(FaceContact<D>& contact) : contact_(contact), patches_(contact) {}

  Groups begin(const State<D>& state, const View<int*>& rowOf) override;
  void add(const Values& displacement, const Values& force) override;
  bool addStiffness(bool symmetric, const AddBlock& addBlock) override;
  bool update() override;
  bool hasBranches() const override { return true; }
  std::vector<HeldDirection<D>> heldDirections() const override;
  bool joinsPieces() const override { return true; }
  std::string reason() const override;
  int reach() const override;

  /// Adds the forces of the points' tractions at the start of a step, as the nodes take them [N], to the
  /// first D columns of a row a node. Needs the nodes of the step. On several ranks those that this rank
  /// owns.
  void addForces(const State<D>& state, const View<double * [D + 1]>& force);

  /// Adds to the internal forces on nodes, front springs left out, what contact exerts in equilibrium with
  /// them [N].
  void balance(const State<D>& state, const View<double * [D + 1]>& force);

  /// Gives the points the tractions and gaps found by the last `add`, and adds the work of contact over the
  /// step to its energies.
  void accept(const State<D>& state);

  /// Stores or loads the patch of each point.
  void serialize(Archive& archive) { patches_.serialize(archive); }

  /// Patches of the last step.
  int patches() const { return static_cast<int>(patches_.all().size()); }
  Touch touchOf(int patch) const { return patches_.all()[patch].touch; }
  double pressureOf(int patch) const { return patches_.all()[patch].now.pressure; }
  double sizeOf(int patch) const { return patches_.all()[patch].area; }

private:
  using Patch = ContactPatch<D>;
  using Part = PatchNode<D>;

  /// Adds the rows of a patch with nodes that this rank owns to the groups of coupled rows.
  void addGroups(const Patch& patch, Groups& groups) const;
  /// Jumps of the nodes and their means over the patches. Collective.
  void findJumps(const Values& displacement);
  Stiffness stiffnessOf(const Patch& patch) const;
  /// Shear traction of a patch that slides, over its limit: the direction of the last `choose`, turned by the
  /// slip sideways since then. It is never reversed: `choose` lets a patch stick that slides back.
  Vector<D - 1> slidingDirection(const Patch& patch) const;
  /// Slip over the step.
  Vector<D - 1> slipOf(const Patch& patch) const;
  /// Tractions of a patch as it is taken to touch.
  void press(Patch& patch) const;
  /// Stiffness that keeps the jumps of a patch's nodes together, of the normal and the tangents [Pa/m].
  Vector<D> jointStiffness(const Patch& patch) const;
  /// How a patch touches by the law, at the displacement of the last `add`, and its multipliers.
  void choose(Patch& patch) const;
  bool derive(const Patch& patch, bool symmetric, double (&C)[D][D]) const;

  FaceContact<D>& contact_;
  ContactPatches<D> patches_;
  std::vector<std::string> names_; ///< of cracks
};

} // namespace Rhegma::contact
