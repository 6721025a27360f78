#include "body_contact/ContactRecord.hpp"

#include "archive/Archive.hpp"
#include "base/Numbers.hpp"

#include <algorithm>

namespace Rhegma::body_contact
{

namespace
{

/// Up to so many groups all pairs have columns, else those with a list of their own.
constexpr int fewGroups = 4;

} // namespace

template <int D>
ContactRecord<D>::ContactRecord(const std::vector<NamedPair>& named, const BondedGroups& groups, bool heats)
    : heats_(heats)
{
  const auto add = [&](const std::string& name, int one, int other, bool inverted, bool interface)
  {
    ReportedPair<D> pair;
    pair.name = name;
    pair.one = one;
    pair.other = other;
    if (one >= 0)
      pair.bodies = {groups.names[inverted ? other : one], groups.names[inverted ? one : other]};
    pair.sign = inverted ? -1.0 : 1.0;
    pair.interface = interface;
    pairs_.push_back(pair);
  };
  add("contact", -1, -1, false,
      std::any_of(named.begin(), named.end(),
                  [](const NamedPair& pair) { return pair.interface.has_value(); }));
  for (const NamedPair& pair : named)
    add(pair.name, pair.one, pair.other, pair.inverted, pair.interface.has_value());
  if (groups.count() > fewGroups)
    return;
  for (int a = 0; a < groups.count(); ++a)
    for (int b = a + 1; b < groups.count(); ++b)
      if (std::none_of(named.begin(), named.end(),
                       [&](const NamedPair& pair) { return pair.one == a && pair.other == b; }))
        add(groups.names[a] + " - " + groups.names[b], a, b, false, false);
}

template <int D>
void ContactRecord<D>::add(State<D>& state, const NodalPairs<D>& pairs, const InterfacePoints<D>& interfaces)
{
  for (ReportedPair<D>& pair : pairs_)
  {
    // With two groups the only pair is all pairs.
    const bool again = pairs_.size() == 2 && pair.one >= 0;
    const ReportedPair<D>& first = pairs_.front();
    const PairSums<D> sums =
        again || pairs.count == 0 ? PairSums<D>{} : sumPairs(pairs, pair.one, pair.other);
    if (again)
    {
      pair.firstTouch = first.firstTouch;
      pair.dissipated = first.dissipated;
      pair.stored = first.stored;
      pair.friction = first.friction;
      pair.heated = first.heated;
      pair.passed = first.passed;
      pair.overlap = first.overlap;
      pair.closed = first.closed;
      pair.impulse = first.impulse;
      continue;
    }
    pair.closed = sums.closed;
    pair.impulse = pair.impulse + sums.impulse;
    const double before = pair.stored;
    pair.stored = pair.interface ? energyOfInterfaces(interfaces, pair.one, pair.other) : 0.0;
    const double lost = sums.dissipated - (pair.stored - before);
    pair.dissipated += lost;
    pair.friction += sums.friction;
    pair.heated += sums.heated;
    pair.passed += sums.passed;
    pair.overlap = std::max(pair.overlap, sums.overlap);
    if (sums.closed > 0 && pair.firstTouch < 0.0)
      pair.firstTouch = state.clock.time;
    if (pair.one >= 0)
      continue;
    state.energy.contact += lost - sums.heated;
    if (pair.interface)
      state.energy.springs = pair.stored;
  }
}

template <int D>
void ContactRecord<D>::sample(State<D>& state)
{
  const char* const columns[] = {".contact_force_x", ".contact_force_y", ".contact_force_z"};
  if (pairs_.front().interface)
    state.sample.row.emplace_back("interfaces", pairs_.front().stored);
  for (ReportedPair<D>& pair : pairs_)
  {
    const double duration = state.clock.time - pair.sampled;
    pair.force = (duration > 0.0 ? pair.sign / duration : 0.0) * (pair.impulse - pair.atSample);
    pair.atSample = pair.impulse;
    pair.sampled = state.clock.time;
    if (pair.one < 0)
      continue;
    for (int d = 0; d < D; ++d)
      state.sample.row.emplace_back(pair.name + columns[d], pair.force[d]);
    state.sample.row.emplace_back(pair.name + ".friction", pair.friction);
    if (heats_)
    {
      state.sample.row.emplace_back(pair.name + ".friction_heat", pair.heated);
      state.sample.row.emplace_back(pair.name + ".heat_passed", pair.sign * pair.passed);
    }
  }
}

template <int D>
void ContactRecord<D>::report(nlohmann::json& summary) const
{
  nlohmann::json& friction = summary["energy"]["friction"]; // of faces of cracks, too
  friction = pairs_.front().friction + (friction.is_number() ? friction.get<double>() : 0.0);
  if (pairs_.front().interface)
    summary["energy"]["interfaces"] = pairs_.front().stored;
  summary["body_contact"] = nlohmann::json::array();
  for (const ReportedPair<D>& pair : pairs_)
  {
    if (pair.one < 0)
      continue;
    const Vector<D> impulse = pair.sign * pair.impulse;
    summary["body_contact"].push_back(
        {{"name", pair.name},
         {"bodies", pair.bodies},
         {"first_touch", pair.firstTouch < 0.0 ? nlohmann::json() : nlohmann::json(pair.firstTouch)},
         {"closed_nodes", pair.closed},
         {"force", std::vector<double>(pair.force.c, pair.force.c + D)},
         {"impulse", std::vector<double>(impulse.c, impulse.c + D)},
         {"dissipated", pair.dissipated},
         {"friction", pair.friction},
         {"largest_overlap", pair.overlap}});
    if (pair.interface)
      summary["body_contact"].back()["stored"] = pair.stored;
    if (heats_)
    {
      summary["body_contact"].back()["friction_heat"] = pair.heated;
      summary["body_contact"].back()["heat_passed"] = pair.sign * pair.passed;
    }
  }
}

template <int D>
void ContactRecord<D>::warnOfInsulation(nlohmann::json& summary) const
{
  for (const ReportedPair<D>& pair : pairs_)
    if (pair.one >= 0 && pair.firstTouch >= 0.0)
      summary["warnings"].push_back("Body Contact: " + pair.bodies[0] + " and " + pair.bodies[1] +
                                    " touch from " + readableTime(pair.firstTouch) +
                                    " on, and no heat passes between them; give Conductance, or write 0 if "
                                    "that is meant");
}

template <int D>
void ContactRecord<D>::serialize(Archive& archive)
{
  for (std::size_t k = 0; k < pairs_.size(); ++k)
  {
    const Archive::Group group(archive, std::to_string(k));
    ReportedPair<D>& pair = pairs_[k];
    archive("first_touch", pair.firstTouch);
    archive("dissipated", pair.dissipated);
    archive("friction", pair.friction);
    if (heats_)
    {
      archive("friction_heat", pair.heated);
      archive("heat_passed", pair.passed);
    }
    if (pair.interface)
      archive("stored", pair.stored);
    archive("overlap", pair.overlap);
    archive("closed", pair.closed);
    archive("impulse", pair.impulse);
    archive("at_sample", pair.atSample);
    archive("sampled", pair.sampled);
    archive("force", pair.force);
  }
}

template class ContactRecord<2>;
template class ContactRecord<3>;

} // namespace Rhegma::body_contact
