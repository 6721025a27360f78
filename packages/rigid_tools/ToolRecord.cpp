#include "rigid_tools/ToolRecord.hpp"

#include "archive/Archive.hpp"

#include <algorithm>

namespace Rhegma::rigid_tools
{

template <int D>
void ToolRecord<D>::add(const State<D>& state, const ToolSums<D>& sums)
{
  closed_ = sums.closed;
  cutSteps_ += sums.cut > 0 ? 1 : 0;
  mostCut_ = std::max(mostCut_, sums.cut);
  impulse_ = impulse_ + sums.impulse;
  dissipated_ += sums.dissipated;
  friction_ += sums.friction;
  work_ += sums.work;
  overlap_ = std::max(overlap_, sums.overlap);
  if (closed_ > 0 && firstTouch_ < 0.0)
    firstTouch_ = state.clock.time;
}

template <int D>
void ToolRecord<D>::sample(State<D>& state, const Tool<D>& tool)
{
  const double duration = state.clock.time - sampled_;
  force_ = (duration > 0.0 ? 1.0 / duration : 0.0) * (impulse_ - atSample_);
  largestForce_ = std::max(largestForce_, norm(force_));
  atSample_ = impulse_;
  sampled_ = state.clock.time;
  HistoryRow& row = state.sample.row;
  const std::string axes = "xyz";
  const Vector<D> position = tool.placement().centre + tool.placement().moved;
  for (int d = 0; d < D; ++d)
    row.emplace_back(tool.name() + "." + axes[d], position[d]);
  for (int d = 0; d < D; ++d)
    row.emplace_back(tool.name() + ".velocity_" + axes[d], tool.velocity().ofCentre[d]);
  for (int d = 0; d < D; ++d)
    row.emplace_back(tool.name() + ".force_" + axes[d], force_[d]);
  row.emplace_back(tool.name() + ".work", work_);
  row.emplace_back(tool.name() + ".friction", friction_);
}

template <int D>
nlohmann::json ToolRecord<D>::report(const Tool<D>& tool) const
{
  const auto asList = [](const Vector<D>& v) { return std::vector<double>(v.c, v.c + D); };
  return {{"name", tool.name()},
          {"position", asList(tool.placement().centre + tool.placement().moved)},
          {"velocity", asList(tool.velocity().ofCentre)},
          {"kinetic_energy", tool.kineticEnergy()},
          {"first_touch", firstTouch_ < 0.0 ? nlohmann::json() : nlohmann::json(firstTouch_)},
          {"closed_nodes", closed_},
          {"force", asList(force_)},
          {"largest_force", largestForce_},
          {"impulse", asList(impulse_)},
          {"work", work_},
          {"dissipated", dissipated_},
          {"friction", friction_},
          {"friction_heat", heated_},
          {"largest_overlap", overlap_},
          {"steps_with_less_friction", cutSteps_}};
}

template <int D>
std::string ToolRecord<D>::warning(const Tool<D>& tool) const
{
  if (cutSteps_ == 0)
    return "";
  return "Rigid Tools > " + tool.name() + ": in " + std::to_string(cutSteps_) + " step" +
         (cutSteps_ == 1 ? "" : "s") + " no velocity of the tool was found with which its law of friction " +
         "holds at all nodes; up to " + std::to_string(mostCut_) + " of them " +
         "slid with less friction. No energy is created, but friction is too small: give the tool a larger "
         "Mass, or a smaller friction coefficient";
}

template <int D>
void ToolRecord<D>::serialize(Archive& archive)
{
  archive("first_touch", firstTouch_);
  archive("dissipated", dissipated_);
  archive("friction", friction_);
  archive("friction_heat", heated_);
  archive("work", work_);
  archive("overlap", overlap_);
  archive("largest_force", largestForce_);
  archive("closed", closed_);
  archive("cut_steps", cutSteps_);
  archive("most_cut", mostCut_);
  archive("impulse", impulse_);
  archive("at_sample", atSample_);
  archive("sampled", sampled_);
  archive("force", force_);
}

template class ToolRecord<2>;
template class ToolRecord<3>;

} // namespace Rhegma::rigid_tools
