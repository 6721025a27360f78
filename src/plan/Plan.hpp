#pragma once
/// The calls of a step in their order.

#include "plan/Effect.hpp"

#include <array>
#include <string>
#include <vector>

namespace Rhegma
{

constexpr int numStages = 9;
const char* stageName(Stage stage);

/// Stages of one step in the order of an update scheme.
std::vector<Stage> stageOrder(UpdateScheme scheme);

/// Calls of one stage, ordered so that writers of a quantity, and calls that add to it, run before its
/// readers.
///
/// Throws std::logic_error where two calls write one quantity and neither reads what the other writes, or
/// where each of several calls waits for another.
template <int D>
std::vector<Call<D>> orderCalls(std::vector<Call<D>> calls);

/// All effects of a run, resolved.
template <int D>
struct Plan
{
  std::vector<Effect<D>> effects;
  std::array<std::vector<Call<D>>, numStages> calls;
  std::vector<Field> fields; ///< that effects add

  /// Runs the calls of one stage; the time that they take is added to the stage's seconds.
  void run(Stage stage, State<D>& state);
  /// Runs the calls of a stage that belong to each pass that strains particles.
  void runPass(Stage stage, State<D>& state);
  std::array<double, numStages> seconds{};

private:
  void run(Stage stage, State<D>& state, bool onlyOfEachPass);
};

/// Resolves the effects of a scene. Throws std::invalid_argument when a field is needed that nothing adds;
/// std::logic_error, with effect, stage and quantity, where a call reads what no call writes, lists a
/// quantity twice, or where two quantities have one name.
template <int D>
Plan<D> makePlan(std::vector<Effect<D>> effects);

/// The plan as text: effects, fields of the particles, calls of each stage and what they read and write.
template <int D>
std::string printPlan(const Plan<D>& plan, const State<D>& state);

} // namespace Rhegma
