#pragma once
/// What bodies have exchanged since the start, for the energy balance, the history and the summary.

#include "body_contact/InterfacePoints.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace Rhegma
{
class Archive;
}

namespace Rhegma::body_contact
{

/// A pair of groups that is reported.
template <int D>
struct ReportedPair
{
  std::string name;                ///< in the history and the summary
  int one = 0, other = 0;          ///< numbers of groups; below 0: all pairs together
  std::vector<std::string> bodies; ///< names of the two groups, as the scene lists them
  double sign = 1.0; ///< -1: the scene lists the second group first, so that its forces are on the first one
  double firstTouch = -1.0; ///< when they first pressed on each other [s]; below 0: not yet
  double dissipated = 0.0;  ///< kinetic energy that contact took [J]
  double friction = 0.0;    ///< the part of it along the faces [J]
  double heated = 0.0;      ///< the part of that which became heat of the bodies [J]
  double passed = 0.0;      ///< heat from the first group to the second [J]
  bool interface = false;   ///< whether an interface joins them
  double stored = 0.0;      ///< elastic energy of their interface now [J]
  double overlap = 0.0;     ///< largest so far [m]
  int closed = 0;           ///< nodes at which they press on each other now
  Vector<D> impulse{};      ///< on the second group so far [N s]
  Vector<D> atSample{};     ///< the same at the last sample [N s]
  double sampled = 0.0;     ///< time of that sample [s]
  Vector<D> force{};        ///< its mean between the last two samples [N]
};

/// Records of pairs.
template <int D>
class ContactRecord
{
public:
  /// \param named pairs with a list of their own \param groups of bodies \param heats whether particles have
  /// temperatures
  ContactRecord(const std::vector<NamedPair>& named, const BondedGroups& groups, bool heats);

  /// Adds what pairs have exchanged in this step, and the energy to the balance.
  void add(State<D>& state, const NodalPairs<D>& pairs, const InterfacePoints<D>& interfaces);
  /// Adds the forces since the last sample to the history.
  void sample(State<D>& state);
  void report(nlohmann::json& summary) const;           ///< writes the summary's entries
  void warnOfInsulation(nlohmann::json& summary) const; ///< names pairs that touched and pass no heat
  void serialize(Archive& archive);                     ///< saves or loads it

private:
  std::vector<ReportedPair<D>> pairs_; ///< the first is of all pairs together
  bool heats_;
};

} // namespace Rhegma::body_contact
