#include "propagation/FrontState.hpp"

#include "archive/Archive.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace Rhegma::propagation
{

namespace
{

template <int D>
void storePath(PathStart<D>& start, std::vector<PathPoint<D>>& path, Archive& archive)
{
  std::vector<double> rows;
  for (const PathPoint<D>& point : path)
  {
    rows.push_back(point.time);
    rows.insert(rows.end(), point.position.c, point.position.c + D);
  }
  archive("path", rows);
  path.resize(rows.size() / (D + 1));
  for (std::size_t k = 0; k < path.size(); ++k)
  {
    path[k].time = rows[k * (D + 1)];
    std::copy_n(&rows[k * (D + 1) + 1], D, path[k].position.c);
  }
  archive("origin", start.position);
  archive("before", start.direction);
  archive("first_direction", start.first);
}

} // namespace

template <int D>
void FrontState<D>::startMotion()
{
  for (auto& [name, node] : nodes)
  {
    node.history.startMotion();
    node.increment = 0.0;
  }
}

template <int D>
bool FrontState<D>::running(const CrackFront<D>& front) const
{
  return !front.ended && std::any_of(front.nodes.begin(), front.nodes.end(),
                                     [&](const FrontNode<D>& node)
                                     {
                                       const auto own = nodes.find(node.name);
                                       return !node.stopped && own != nodes.end() &&
                                              own->second.history.running();
                                     });
}

template <int D>
bool FrontState<D>::hasAlmostStopped(const CrackFront<D>& front, double time) const
{
  return std::all_of(front.nodes.begin(), front.nodes.end(),
                     [&](const FrontNode<D>& node)
                     {
                       const auto own = nodes.find(node.name);
                       return node.stopped || own == nodes.end() ||
                              own->second.history.hasAlmostStopped(time, own->second.speedLimit);
                     });
}

template <int D>
std::pair<double, double> FrontState<D>::arrest() const
{
  std::pair<double, double> closest{0.0, 0.0};
  for (const auto& [name, node] : nodes)
    if (const auto own = node.history.arrest();
        own.second > 0.0 &&
        (closest.second == 0.0 || own.first * closest.second > closest.first * own.second))
      closest = own;
  return closest;
}

template <int D>
double FrontState<D>::settledSpeed() const
{
  double sum = 0.0;
  int count = 0;
  for (const auto& [name, node] : nodes)
    if (const double speed = node.history.settledSpeed(); speed > 0.0)
    {
      sum += speed;
      ++count;
    }
  return nodes.empty() ? lastSettledSpeed : sum / std::max(count, 1);
}

template <int D>
double FrontState<D>::closest() const
{
  double largest = 0.0;
  for (const auto& [name, node] : nodes)
    largest = std::max(largest, node.history.closest());
  return largest;
}

template <int D>
double FrontState<D>::early() const
{
  double largest = earlyOfFormer;
  for (const auto& [name, node] : nodes)
    largest = std::max(largest, node.history.early());
  return largest;
}

template <int D>
void FrontState<D>::count(const FrontHistory& history, int made)
{
  if (increments == 0 || history.firstTime() < firstTime)
    firstTime = history.firstTime();
  lastTime = std::max(lastTime, history.lastTime());
  increments += made;
}

template <int D>
void FrontState<D>::matchNodes(const CrackFront<D>& front)
{
  const bool same = front.nodes.size() == nodes.size() &&
                    std::all_of(front.nodes.begin(), front.nodes.end(),
                                [&](const FrontNode<D>& node) { return nodes.count(node.name) > 0; });
  if (same)
    return;
  lastSettledSpeed = settledSpeed();
  earlyOfFormer = early();
  std::map<int, FrontNodeState> now;
  for (const FrontNode<D>& node : front.nodes)
  {
    auto past = nodes.find(node.name);
    if (past == nodes.end())
      past = nodes.find(node.from);
    now[node.name] = past == nodes.end() ? FrontNodeState() : past->second;
  }
  nodes = std::move(now);
}

template <int D>
void FrontState<D>::serialize(Archive& archive)
{
  archive("increments", increments);
  archive("first", firstTime);
  archive("last", lastTime);
  archive("speed_limit", speedLimit);
  archive("last_settled_speed", lastSettledSpeed);
  archive("early", earlyOfFormer);
  archive("start_release", first.release);
  archive("start_mode_i", first.modeI);
  archive("start_mode_ii", first.modeII);
  archive("start_mode_iii", first.modeIII);
  archive("start_held", first.held);
  if constexpr (D == 2)
  {
    storePath(start, path, archive);
    archive("hoop_load", hoop.load);
    archive("hoop_intensity", hoop.intensity);
    archive("contour_release", contours.release);
    archive("contour_ratio", contours.ratio);
    archive("contour_time", contours.time);
  }
  for (auto& [name, node] : nodes)
  {
    const Archive::Group group(archive, "front node " + std::to_string(name));
    node.history.serialize(archive);
    archive("speed_limit", node.speedLimit);
    archive("increment", node.increment);
    archive("straight_length", node.straightLength);
    if constexpr (D == 2)
    {
      archive("aim_angle", node.aim.angle);
      archive("aim_drive", node.aim.drive);
      archive("aim_weight", node.aim.weight);
    }
  }
}

template struct FrontState<2>;
template struct FrontState<3>;

} // namespace Rhegma::propagation
