#pragma once
/// Contact of the faces of cracks over a step of equilibrium.

#include "contact/FaceContact.hpp"
#include "contact/FaceNodes.hpp"
#include "state/StepForce.hpp"

#include <map>
#include <string>
#include <vector>

namespace Rhegma::contact
{

/// How the faces of a patch touch.
enum class Touch
{
  Open,
  Sticking,
  Sliding
};

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
/// slides: forces on them whose sum is zero keep them together.
template <int D>
class ContactInEquilibrium : public StepForce<D>
{
public:
  using typename StepForce<D>::Values;
  using typename StepForce<D>::Groups;
  using typename StepForce<D>::AddBlock;

  /// \param contact whose points and history it uses, and must outlive it
  explicit ContactInEquilibrium(FaceContact<D>& contact) : contact_(contact) {}

  Groups begin(const State<D>& state, const View<int*>& rowOf) override;
  void add(const Values& displacement, const Values& force) override;
  bool addStiffness(bool symmetric, const AddBlock& addBlock) override;
  bool update() override;
  int iterationFactor() const override { return 3; }
  std::vector<HeldDirection<D>> heldDirections() const override;
  bool joinsPieces() const override { return true; }
  std::string reason() const override;

  /// Adds the forces of the points' tractions at the start of a step, as the nodes take them [N], to the
  /// first D columns of a row a node. Needs the nodes of the step.
  void addForces(const State<D>& state, const View<double * [D + 1]>& force);

  /// Adds to the internal forces on nodes, front springs left out, what contact exerts in equilibrium with
  /// them [N].
  void balance(const State<D>& state, const View<double * [D + 1]>& force);

  /// Gives the points the tractions and gaps found by the last `add`, and adds the work of contact over the
  /// step to its energies.
  void accept(const State<D>& state);

  /// Stores or loads the patch of each point.
  void serialize(Archive& archive);

  /// Patches of the last step.
  int patches() const { return static_cast<int>(patches_.size()); }
  Touch touchOf(int patch) const { return patches_[patch].touch; }
  double pressureOf(int patch) const { return patches_[patch].now.pressure; }
  double sizeOf(int patch) const { return patches_[patch].area; }

private:
  /// Part of the jump of a node's fields in the mean jump of a patch: of normal and tangents, along the axes.
  struct Part
  {
    int plus = 0, minus = 0;         ///< nodes of its fields
    int plusRow = -1, minusRow = -1; ///< their rows
    double jump[D][D] = {};
    double weight = 0.0;    ///< size of its area [m2]
    double axes[D][D] = {}; ///< of the normal and the tangents
    Vector<D> own{};        ///< jump of its fields along these, by the last `add` [m]
  };
  /// Sums over the points of a patch, each times its area and the weight of a node there [m2].
  struct Frame
  {
    double area = 0.0;
    double axes[D][D] = {}; ///< of the normal and the tangents
  };
  struct Patch
  {
    int crack = 0;
    double size = 0.0;                ///< of the points that act, undeformed [m2]
    double area = 0.0;                ///< of the nodes' shares [m2]
    std::vector<int> points;          ///< that act
    std::vector<Part> parts;          ///< of the mean jump, a node with two fields each
    bool touching = false;            ///< at the start of the step
    bool slid = false;                ///< then
    double gap = 0.0, pressure = 0.0; ///< then [m, Pa]
    Vector<D - 1> shear{};            ///< then [Pa]
    double normalMultiplier = 0.0;    ///< [Pa]
    Vector<D - 1> shearMultiplier{};  ///< [Pa]
    double weights = 0.0;             ///< of the nodes [m2]
    Vector<D> middle{};               ///< mean of their own jumps, by the last `add` [m]
    Vector<D> moved{};                ///< jump over the step by the last `add`: normal, tangents [m]
    Touch touch = Touch::Open;        ///< that `add` and `addStiffness` take
    Vector<D - 1> direction{};        ///< of the shear traction while sliding, of unit length or zero
    Return<D - 1> now{};              ///< tractions by the last `add`
  };

  Vector<D> tangent(int point, int which) const;
  void divide(const State<D>& state);
  void collect(const State<D>& state);
  void addJumps(Patch& patch, const std::map<int, Frame>& frames, const std::vector<FaceNode<D>>& nodes,
                const std::vector<double>& scale) const;
  Stiffness stiffnessOf(const Patch& patch) const;
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
  View<int*> patchOf_; ///< of each point
  std::vector<Patch> patches_;
  std::vector<std::string> names_;   ///< of cracks
  std::vector<Vector<D>> reference_; ///< of each point: where its first tangent points, before projection
};

} // namespace Rhegma::contact
