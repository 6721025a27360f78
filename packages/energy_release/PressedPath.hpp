#pragma once
/// The contribution of a pressure on the faces of a crack to the domain integrals of a front in 2D.

#include "energy_release/AccelerationByPressure.hpp"
#include "energy_release/Contour.hpp"
#include "energy_release/CrackTipFields.hpp"

#include <vector>

namespace Rhegma::energy_release
{

/// The faces behind a front, as far as the weight q of the integrals reaches, and the pressure on them.
///
/// With the acceleration of nodes without the pressure (AccelerationByPressure.hpp) the domain integrals lack
/// the work of the pressure: with s the distance behind the front along the crack, [u] the jump from side -1
/// to side +1, n the normal from the one to the other,
///
///     J += int p n [u],s q ds,     M += int p n [w],s q ds,     R -= int p n [w] q ds.
///
/// The jump of Williams' field w is exact, so that the root singularity of [w],s is, too. In J the
/// derivative goes to p q by integration by parts: only openings at positions where q varies count, which are
/// accurate, where those in the cells of the front are not. The faces are loaded up to the tip of the crack
/// in the cells, to which J and K belong. Sources as for the domain integrals: Li, Shih and Needleman, Eng.
/// Fract. Mech. 21 (1985) 405; Karlsson and Bäcklund, Int. J. Fract. 14 (1978) R311.
class PressedPath
{
public:
  /// \param weight q Collective.
  PressedPath(const State<2>& state, const CrackFront<2>& front, const NodalWeight<2>& weight);

  /// Whether no pressure acts there.
  bool empty() const { return points_.empty(); }

  /// Of J [J/m2]. Collective.
  double release(const State<2>& state) const;

  /// Adds those of M and R to them, per thickness, for the modes I and II.
  /// \param offset how far the tip of the crack in the cells lies ahead of the front [m]
  void addInteraction(double offset, const TipModuli& moduli, double (&interaction)[2],
                      double (&reciprocal)[2]) const;

private:
  std::vector<Vector<2>> points_; ///< on the crack, from the front on
  std::vector<double> weights_;   ///< q at the points
  std::vector<Vector<2>> load_;   ///< the pressure times the normal between a point and the next [Pa]
  CrackFront<2> front_;
  NodalWeight<2> weight_;

  void cut(const State<2>& state, double reach);
  void findWeights(const State<2>& state);
};

} // namespace Rhegma::energy_release
