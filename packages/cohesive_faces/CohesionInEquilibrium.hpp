#pragma once
/// Cohesion of faces over a step of equilibrium.

#include "cohesive_faces/FaceCohesion.hpp"
#include "parallel/Ranks.hpp"
#include "state/StepForce.hpp"

#include <string>
#include <vector>

namespace Rhegma::cohesive_faces
{

/// The tractions of the face points at a trial displacement over the step, with the tangent of the law. The
/// jump of a point is linear in the displacement of the nodes of its stencils.
///
/// The law has kinks, at which damage begins, ends and stops growing. In an iteration each point stays on one
/// smooth branch, also beyond its ends, and `update` chooses the branches anew, so that Newton's method is
/// one of semismooth equations (Qi and Sun, Math. Program. 58 (1993) 353): a search along its change would
/// often find no decrease across kinks. A point whose branch changes again and again keeps the secant of the
/// last iteration instead.
///
/// On several ranks all have the jumps of all points. Where the faces of a point lie on two ranks, each adds
/// the block of its own face alone, and of the tangent only the secant: more iterations to the same
/// equilibrium.
template <int D>
class CohesionInEquilibrium : public StepForce<D>
{
public:
  using typename StepForce<D>::Values;
  using typename StepForce<D>::Groups;
  using typename StepForce<D>::AddBlock;

  /// \param cohesion whose points and history it uses, and must outlive it
  explicit CohesionInEquilibrium(FaceCohesion<D>& cohesion) : cohesion_(cohesion) {}

  Groups begin(const State<D>& state, const View<int*>& rowOf) override;
  void add(const Values& displacement, const Values& force) override;
  bool addStiffness(bool symmetric, const AddBlock& addBlock) override;
  bool update() override;
  bool hasBranches() const override { return true; }
  std::string reason() const override;

  /// Gives the points what the last `add` found.
  void accept(const State<D>& state);

private:
  /// Part of the jump of a point.
  struct Part
  {
    int row;       ///< of the unknowns
    double weight; ///< negative on side -1
  };
  struct Point
  {
    int index = 0, crack = 0;
    double area = 0.0; ///< [m2]
    bool whole = true; ///< whether both of its faces are of this rank
    Vector<D> axes[D]; ///< normal and tangents
    std::vector<Part> parts;
  };
  Cohesion<D> meanAt(const Point& point) const;

  FaceCohesion<D>& cohesion_;
  std::vector<Point> points_;
  std::vector<FoundPoint<D>> found_; ///< of all points, by the last `add`
  std::vector<Branch> branch_;       ///< of all points
  std::vector<int> changes_;         ///< of the branch of each point in this step
  std::vector<double> held_;         ///< secant fraction of a point whose branch has changed too often
  std::vector<double> jumps_;        ///< D numbers a point [m]
  std::vector<std::string> names_;   ///< of cracks
  Ranks ranks_;
};

} // namespace Rhegma::cohesive_faces
