#pragma once
/// The sample of a crack front for the history and the summary.

#include "energy_release/CrackClosure.hpp"
#include "energy_release/FrontTube.hpp"
#include "energy_release/ReadOptions.hpp"

#include <nlohmann/json.hpp>

#include <limits>

#include <string>
#include <vector>

namespace Rhegma::energy_release
{

/// A quantity at the nodes of a front.
using Along = std::vector<double>;

/// The last sample of a front.
template <int D>
struct FrontSample
{
  CrackFront<D> front;
  FrontTube tube;                       ///< none of a front that has ended
  Along J, modeI, modeII, modeIII;      ///< [J/m2], [Pa m^0.5]; empty in 3D where no node is left
  double tipOffset = 0.0;               ///< DomainIntegral (2D)
  bool isotropic = true;                ///< whether the material at it is
  bool closed = false;                  ///< whether crack closure is requested and can be computed (2D)
  CrackClosure closure{notYet, notYet}; ///< (2D)

  static constexpr double notYet = std::numeric_limits<double>::quiet_NaN(); ///< null in the summary

  FrontSample() = default;
  /// Of a front at which nothing has been computed yet.
  FrontSample(const CrackFront<D>& of, double value);

  /// Appends its columns to a row of the history. \param name of the front
  void addTo(HistoryRow& row, const std::string& name, const Options& options) const;

  /// Adds what it has to the entry of its front.
  void report(const Options& options, nlohmann::json& entry) const;

  /// Whether the faces are pressed together: K_I is negative, by more than a hundredth of G, as the
  /// compliance of closed faces that slide makes it.
  bool isClosed() const;

  /// Saves or loads it.
  void serialize(Archive& archive);
};

/// Mean of a quantity along a front: of the straight lines between its nodes; in 2D the quantity itself.
/// Nodes without a value are left out; notYet where none has one.
template <int D>
double meanAlong(const CrackFront<D>& front, const Along& values);

} // namespace Rhegma::energy_release
