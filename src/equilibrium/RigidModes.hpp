#pragma once
/// Rigid motions that no support prevents.

#include "equilibrium/RowOwners.hpp"
#include "state/StepForce.hpp"

#include <algorithm>
#include <string>

namespace Rhegma::equilibrium
{

/// Number of rigid motions: translations, then rotations about the axes (z in 2D).
template <int D>
constexpr int rigidMotions = D == 2 ? 3 : 6;

/// A rigid motion of a piece, as coefficients of translations and of rotations about its centre times its
/// size.
template <int D>
struct RigidMode
{
  int piece = 0;
  Vector<D> centre{}; ///< of mass [m]
  double size = 1.0;  ///< of the piece [m]
  double coefficient[rigidMotions<D>] = {};

  /// Motion of a point.
  Vector<D> at(const Vector<D>& x) const
  {
    Vector<D> u{};
    const Vector<D> arm = (1.0 / size) * (x - centre);
    for (int d = 0; d < D; ++d)
      u[d] = coefficient[d];
    if constexpr (D == 2)
    {
      u[0] -= coefficient[2] * arm[1];
      u[1] += coefficient[2] * arm[0];
    }
    else
      for (int d = 0; d < 3; ++d)
        u[d] +=
            coefficient[3 + (d + 1) % 3] * arm[(d + 2) % 3] - coefficient[3 + (d + 2) % 3] * arm[(d + 1) % 3];
    return u;
  }

  /// Whether it is no mere translation.
  bool turns() const
  {
    bool any = false;
    for (int m = D; m < rigidMotions<D>; ++m)
      any = any || std::fabs(coefficient[m]) > 1e-9;
    return any;
  }

  /// Such as "can move along x" or "can turn freely about z". A motion that turns is named by its axis alone:
  /// that its centre moves says where the axis is.
  std::string asText() const;
};

/// The free motions of all pieces, orthogonal to each other. Collective.
/// \param resisted directions in which something other than a support holds a piece
template <int D>
std::vector<RigidMode<D>> freeModes(const std::vector<int>& pieceOf, int pieces,
                                    const std::vector<Vector<D>>& position, const std::vector<double>& mass,
                                    const Held& held, const RowOwners& owners,
                                    const std::vector<HeldDirection<D>>& resisted = {});

/// Takes from forces what would accelerate free pieces: f -= M R (R^T M R)^-1 R^T f, R the modes at the
/// current positions. Collective. \param force on all rows, the same on all ranks that have one
template <int D>
void removeResultants(const std::vector<RigidMode<D>>& modes, const std::vector<int>& pieceOf,
                      const std::vector<Vector<D>>& position, const std::vector<double>& mass,
                      const RowOwners& owners, const View<double*>& force);

/// What of the forces on a free piece does not balance: the resultants that accelerate it. The forces are
/// those on its nodes that its stress does not exert: loads, and of front springs and closed faces what they
/// exert when the step starts. Fractions are the largest of those of each free motion: the work of the forces
/// on it over the sum of |force| |motion|, with which none of them would balance another.
struct Imbalance
{
  int piece = 0;
  double force = 0.0;  ///< along the free translations [N]
  double moment = 0.0; ///< about the axes of the free rotations [N m]
  double fractionOfForce = 0.0, fractionOfMoment = 0.0;

  double fraction() const { return std::max(fractionOfForce, fractionOfMoment); }
  /// Such as "a moment of 3 N m (12 % of the forces on it)". \param least fraction from which one is named
  std::string asText(double least) const;
};

/// Imbalance of the forces on each piece that has a free motion. Collective. \param force as for
/// `removeResultants`
template <int D>
std::vector<Imbalance> findImbalances(const std::vector<RigidMode<D>>& modes, const std::vector<int>& pieceOf,
                                      const std::vector<Vector<D>>& position, const std::vector<double>& mass,
                                      const RowOwners& owners, const View<double*>& force);

/// As many unknowns (D * row + axis) as there are modes, which prevent the motions of their pieces when held.
/// Nodes that a piece hardly touches are not among them. Collective. \return those that this rank has
template <int D>
std::vector<int> unknownsOfMotions(const std::vector<RigidMode<D>>& modes, const std::vector<int>& pieceOf,
                                   const std::vector<Vector<D>>& position, const std::vector<double>& mass,
                                   const RowOwners& owners);

} // namespace Rhegma::equilibrium
