#include "plan/Plan.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>

namespace Rhegma
{

namespace
{

bool contains(const Quantities& list, const Quantity& quantity)
{
  return std::any_of(list.begin(), list.end(), [&](const Quantity& q) { return &q == &quantity; });
}

bool contains(const std::vector<Read>& list, const Quantity& quantity)
{
  return std::any_of(list.begin(), list.end(), [&](const Read& r) { return r.quantity == &quantity; });
}

/// Whether a must run before b.
template <int D>
bool precedes(const Call<D>& a, const Call<D>& b)
{
  for (const Quantity& q : a.writes)
    if (contains(b.reads, q) || contains(b.addsTo, q))
      return true;
  for (const Quantity& q : a.addsTo)
    if (contains(b.reads, q) && !contains(b.writes, q))
      return true;
  return false;
}

template <int D>
void refuseAmbiguity(const std::vector<Call<D>>& calls)
{
  for (std::size_t a = 0; a < calls.size(); ++a)
    for (std::size_t b = a + 1; b < calls.size(); ++b)
      for (const Quantity& q : calls[a].writes)
        if (contains(calls[b].writes, q) && !contains(calls[a].reads, q) && !contains(calls[b].reads, q))
          throw std::logic_error("\"" + calls[a].label + "\" and \"" + calls[b].label + "\" both write the " +
                                 q.name + " and nothing says in which order");
}

/// The quantities of a call, by reads, writes and additions.
template <int D>
std::array<std::vector<const Quantity*>, 3> listed(const Call<D>& call)
{
  std::array<std::vector<const Quantity*>, 3> lists;
  for (const Read& read : call.reads)
    lists[0].push_back(read.quantity);
  for (const Quantity& q : call.writes)
    lists[1].push_back(&q);
  for (const Quantity& q : call.addsTo)
    lists[2].push_back(&q);
  return lists;
}

/// Refuses wrong declarations of calls: a read without a writer, and duplicates.
template <int D>
void checkQuantities(const std::vector<Effect<D>>& effects)
{
  std::set<const Quantity*> written;
  for (const Effect<D>& effect : effects)
  {
    for (const Quantity& q : effect.provides)
      written.insert(&q);
    for (const Call<D>& call : effect.calls)
      for (const Quantities& list : {call.writes, call.addsTo})
        for (const Quantity& q : list)
          written.insert(&q);
  }
  std::map<std::string, const Quantity*> named;
  for (const Effect<D>& effect : effects)
    for (const Call<D>& call : effect.calls)
    {
      const auto refuse = [&](const Quantity& q, const std::string& why)
      {
        throw std::logic_error("effect " + effect.name + ", stage " + stageName(call.stage) + ", call \"" +
                               call.label + "\", quantity \"" + q.name + "\": " + why);
      };
      for (const Read& read : call.reads)
        if (!read.optional && written.count(read.quantity) == 0)
          refuse(*read.quantity, "it is read and no call of the plan writes it");
      for (const auto& list : listed(call))
        for (auto q = list.begin(); q != list.end(); ++q)
        {
          if (std::count(list.begin(), q, *q) > 0)
            refuse(**q, "the call lists it twice");
          if (named.emplace((*q)->name, *q).first->second != *q)
            refuse(**q, "another quantity has this name");
        }
    }
}

/// ": reads a, b; writes c", or nothing.
template <int D>
std::string describeQuantities(const Call<D>& call)
{
  static const char* const verbs[] = {"reads ", "writes ", "adds to "};
  std::string text;
  const auto lists = listed(call);
  for (int k = 0; k < 3; ++k)
    for (const Quantity* q : lists[k])
      text += (q != lists[k].front() ? ", " : (text.empty() ? ": " : "; ") + std::string(verbs[k])) + q->name;
  return text;
}

void printField(const Field& field, std::ostream& out)
{
  out << "  " << field.name << " (" << field.components << (field.unit.empty() ? "" : ", " + field.unit)
      << "): " << field.meaning << "\n";
}

} // namespace

const char* stageName(Stage stage)
{
  static const char* names[numStages] = {"BetweenSteps",    "Scatter",     "BeforeSolve",
                                         "Solve",           "AfterSolve",  "Gather",
                                         "AfterProjection", "OnParticles", "Observe"};
  return names[static_cast<int>(stage)];
}

std::vector<Stage> stageOrder(UpdateScheme scheme)
{
  if (scheme == UpdateScheme::Usf)
    return {Stage::BetweenSteps, Stage::Scatter,     Stage::AfterProjection,
            Stage::OnParticles,  Stage::BeforeSolve, Stage::Solve,
            Stage::AfterSolve,   Stage::Gather,      Stage::Observe};
  return {Stage::BetweenSteps, Stage::Scatter,         Stage::BeforeSolve, Stage::Solve,  Stage::AfterSolve,
          Stage::Gather,       Stage::AfterProjection, Stage::OnParticles, Stage::Observe};
}

template <int D>
std::vector<Call<D>> orderCalls(std::vector<Call<D>> calls)
{
  refuseAmbiguity(calls);
  std::vector<Call<D>> ordered;
  while (!calls.empty())
  {
    const auto next = std::find_if(calls.begin(), calls.end(),
                                   [&](const Call<D>& candidate)
                                   {
                                     return std::none_of(calls.begin(), calls.end(),
                                                         [&](const Call<D>& other) {
                                                           return &other != &candidate &&
                                                                  precedes(other, candidate) &&
                                                                  !precedes(candidate, other);
                                                         });
                                   });
    if (next == calls.end())
      throw std::logic_error("\"" + calls.front().label +
                             "\" and other calls of its stage wait for each other");
    ordered.push_back(*next);
    calls.erase(next);
  }
  return ordered;
}

template <int D>
void Plan<D>::run(Stage stage, State<D>& state)
{
  run(stage, state, false);
}

template <int D>
void Plan<D>::runPass(Stage stage, State<D>& state)
{
  run(stage, state, true);
}

template <int D>
void Plan<D>::run(Stage stage, State<D>& state, bool onlyOfEachPass)
{
  const int s = static_cast<int>(stage);
  if (calls[s].empty())
    return;
  Kokkos::Timer timer;
  Kokkos::Profiling::pushRegion(std::string("rhegma::") + stageName(stage));
  for (const Call<D>& call : calls[s])
    if (call.ofEachPass || !onlyOfEachPass)
      call.run(state);
  ExecSpace().fence();
  Kokkos::Profiling::popRegion();
  seconds[s] += timer.seconds();
}

template <int D>
Plan<D> makePlan(std::vector<Effect<D>> effects)
{
  Plan<D> plan;
  std::set<std::string> names;
  for (const Effect<D>& effect : effects)
    for (const Field& field : effect.adds)
      if (names.insert(field.name).second)
        plan.fields.push_back(field);
  for (const Effect<D>& effect : effects)
    for (const std::string& field : effect.needs)
      if (names.count(field) == 0)
        throw std::invalid_argument("the effect \"" + effect.name + "\" needs the field \"" + field +
                                    "\", which nothing in this scene adds");
  checkQuantities(effects);
  for (int s = 0; s < numStages; ++s)
  {
    std::vector<Call<D>> calls;
    for (const Effect<D>& effect : effects)
      for (const Call<D>& call : effect.calls)
        if (static_cast<int>(call.stage) == s)
          calls.push_back(call);
    plan.calls[s] = orderCalls<D>(calls);
  }
  plan.effects = std::move(effects);
  return plan;
}

template <int D>
std::string printPlan(const Plan<D>& plan, const State<D>& state)
{
  std::ostringstream out;
  out << "Effects:";
  for (const Effect<D>& effect : plan.effects)
    out << (&effect == &plan.effects.front() ? " " : ", ") << effect.name;
  out << "\nFields of each of " << state.particles.size() << " particles:\n";
  for (const Field& field : state.particles.fields())
    printField(field, out);
  if (!state.mesh.nodalFields.empty())
    out << "Fields that nodes keep from step to step:\n";
  for (const NodalField& nodal : state.mesh.nodalFields.fields())
    printField(nodal.field, out);
  out << "Stages of a step:\n";
  const bool twice = state.method.scheme == UpdateScheme::Usavg;
  for (const Stage stage : stageOrder(state.method.scheme))
  {
    const auto& calls = plan.calls[static_cast<int>(stage)];
    if (calls.empty())
      continue;
    out << "  " << stageName(stage) << ":\n";
    for (const Call<D>& call : calls)
      out << "    " << call.label << (twice && call.ofEachPass ? " (before the forces too)" : "")
          << describeQuantities(call) << "\n";
  }
  return out.str();
}

template std::vector<Call<2>> orderCalls(std::vector<Call<2>>);
template std::vector<Call<3>> orderCalls(std::vector<Call<3>>);
template struct Plan<2>;
template struct Plan<3>;
template Plan<2> makePlan(std::vector<Effect<2>>);
template Plan<3> makePlan(std::vector<Effect<3>>);
template std::string printPlan(const Plan<2>&, const State<2>&);
template std::string printPlan(const Plan<3>&, const State<3>&);

} // namespace Rhegma
