#pragma once
/// The patches of face points over which contact acts in equilibrium.

#include "contact/FaceContact.hpp"
#include "contact/PatchFrames.hpp"
#include "parallel/Ranks.hpp"

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
  bool ofThisRank = true;          ///< whether this rank owns the node
  Vector<D> position{};            ///< [m]
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
  bool isWide = false;              ///< whether nodes lie too far apart to be coupled on several ranks
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
  int opened = 0, slipped = 0;      ///< how often it did so in the iterations of this step
  Vector<D - 1> direction{};        ///< of the shear traction while sliding, of unit length or zero
  Vector<D - 1> slipThen{};         ///< slip over the step when it got this direction [m]
  double slideRadius = 0.0;         ///< slip sideways, over which the direction would turn by one radian [m]
  Return<D - 1> now{};              ///< tractions by the last `add`
};

/// The patches of all cracks, with the nodes that have two fields next to them.
///
/// On several ranks all have all patches with the same means. Of the nodes of a patch a rank has those in its
/// window, among them all that are coupled with its own.
template <int D>
class ContactPatches
{
public:
  /// \param contact whose points and history they have, and which must outlive them
  explicit ContactPatches(const FaceContact<D>& contact) : contact_(contact) {}

  /// Finds them anew at the start of a step. Needs the nodes of the step. Collective.
  void collect(const State<D>& state);

  std::vector<ContactPatch<D>>& all() { return patches_; }
  const std::vector<ContactPatch<D>>& all() const { return patches_; }
  const Ranks& ranks() const { return ranks_; }

  /// Whether two nodes of a patch are coupled: all are on one rank.
  bool areCoupled(const ContactPatch<D>& patch, const PatchNode<D>& a, const PatchNode<D>& b) const;

  /// Unit tangents at a point, the same for all of its patch but for the turn of its normal.
  Vector<D> tangent(int point, int which) const;

  /// Stores or loads the patch of each point.
  void serialize(Archive& archive);

private:
  void divide(const State<D>& state);
  /// The frames of all patches. \param nodes with two fields
  PatchFrames<D> framesOf(const State<D>& state, const std::vector<FaceNode<D>>& nodes) const;
  /// Sums the areas of the patches' nodes over the ranks. \param scale of each node
  void sumAreas(const State<D>& state, const PatchFrames<D>& frames, const std::vector<FaceNode<D>>& nodes,
                const std::vector<double>& scale);
  void addJumps(const State<D>& state, ContactPatch<D>& patch, const std::map<int, PatchFrame<D>>& frames,
                const std::vector<FaceNode<D>>& nodes, const std::vector<double>& scale) const;
  /// Means of the points' gaps and tractions at the start of the step.
  void addHistory(const State<D>& state, ContactPatch<D>& patch) const;

  const FaceContact<D>& contact_;
  View<int*> patchOf_; ///< of each point
  std::vector<ContactPatch<D>> patches_;
  Ranks ranks_;                      ///< that have parts of them
  double mostApart_ = 0.0;           ///< of nodes that are coupled, along an axis [m]
  std::vector<Vector<D>> reference_; ///< of each point: where its first tangent points, before projection
};

} // namespace Rhegma::contact
