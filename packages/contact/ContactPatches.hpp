#pragma once
/// The patches of face points over which contact acts in equilibrium.

#include "contact/FaceContact.hpp"
#include "contact/FaceNodes.hpp"

#include <map>
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

/// Part of the jump of a node's fields in the mean jump of a patch: of normal and tangents, along the axes.
template <int D>
struct PatchNode
{
  int plus = 0, minus = 0;         ///< nodes of its fields
  int plusRow = -1, minusRow = -1; ///< their rows
  double jump[D][D] = {};
  double weight = 0.0;    ///< size of its area [m2]
  double axes[D][D] = {}; ///< of the normal and the tangents
  Vector<D> own{};        ///< jump of its fields along these, by the last `add` [m]
};

/// A patch of face points: where it is, and how it touches.
template <int D>
struct ContactPatch
{
  int crack = 0;
  double size = 0.0;                ///< of the points that act, undeformed [m2]
  double area = 0.0;                ///< of the nodes' shares [m2]
  std::vector<int> points;          ///< that act
  std::vector<PatchNode<D>> parts;  ///< of the mean jump, a node with two fields each
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

/// The patches of all cracks, with the nodes that have two fields next to them.
template <int D>
class ContactPatches
{
public:
  /// \param contact whose points and history they have, and which must outlive them
  explicit ContactPatches(const FaceContact<D>& contact) : contact_(contact) {}

  /// Finds them anew at the start of a step. Needs the nodes of the step.
  void collect(const State<D>& state);

  std::vector<ContactPatch<D>>& all() { return patches_; }
  const std::vector<ContactPatch<D>>& all() const { return patches_; }

  /// Unit tangents at a point, the same for all of its patch but for the turn of its normal.
  Vector<D> tangent(int point, int which) const;

  /// Stores or loads the patch of each point.
  void serialize(Archive& archive);

private:
  /// Sums over the points of a patch, each times its area and the weight of a node there [m2].
  struct Frame
  {
    double area = 0.0;
    double axes[D][D] = {}; ///< of the normal and the tangents
  };

  void divide(const State<D>& state);
  void addJumps(ContactPatch<D>& patch, const std::map<int, Frame>& frames,
                const std::vector<FaceNode<D>>& nodes, const std::vector<double>& scale) const;

  const FaceContact<D>& contact_;
  View<int*> patchOf_; ///< of each point
  std::vector<ContactPatch<D>> patches_;
  std::vector<Vector<D>> reference_; ///< of each point: where its first tangent points, before projection
};

} // namespace Rhegma::contact
