#include "base/ReadList.hpp"
#include "boundary/BodySurface.hpp"
#include "plausibility/Judges.hpp"
#include "scene/TimeFunction.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <unordered_map>

namespace Rhegma
{

namespace
{

/// A load of a group that acts on the same points.
template <int D>
struct Acting
{
  std::string name;
  Vector<D> force{}; ///< at a history of 1 [N]
  std::string history;
};

/// The points on which a load acts, as a text: all parameters that are not its size.
std::string pointsOf(const Teuchos::ParameterList& list)
{
  std::ostringstream text;
  for (const auto& entry : list)
  {
    const std::string& name = entry.first;
    if (name != "Force" && name != "Stress" && name != "Pressure" && name != "History" && name != "From" &&
        name != "To")
    {
      text << name << "=";
      entry.second.leftshift(text, false);
      text << ";";
    }
  }
  if (list.isParameter("From") && list.isParameter("To")) // from either end
  {
    std::ostringstream from, to;
    from << list.get<Teuchos::Array<double>>("From");
    to << list.get<Teuchos::Array<double>>("To");
    text << std::min(from.str(), to.str()) << std::max(from.str(), to.str());
  }
  return text.str();
}

/// Whether the forces add up to nothing at all times of the run, and each is something.
template <int D>
bool cancel(const std::vector<Acting<D>>& loads, double end)
{
  constexpr int times = 64;
  constexpr double roundOff = 1e-12;
  std::vector<TimeFunction> histories;
  for (const Acting<D>& load : loads)
    histories.push_back(TimeFunction::parse(load.history));
  double most = 0.0;
  for (int k = 0; k <= times; ++k)
  {
    Vector<D> sum{};
    double sizes = 0.0;
    for (std::size_t i = 0; i < loads.size(); ++i)
    {
      const Vector<D> force = histories[i](end * k / times) * loads[i].force;
      sum = sum + force;
      sizes += norm(force);
    }
    if (norm(sum) > roundOff * sizes)
      return false;
    most = std::max(most, sizes);
  }
  return most > 0.0;
}

} // namespace

template <int D>
Messages judgeCancelling(const JudgedScene<D>& judged)
{
  Messages messages;
  if (!judged.scene.isSublist("Boundaries"))
    return messages;
  const Teuchos::ParameterList& section = judged.scene.sublist("Boundaries");
  std::unordered_map<std::string, std::vector<Acting<D>>> groups;
  std::vector<std::string> order; // that of the scene
  for (const std::string& name : sublistNames(section))
  {
    const Teuchos::ParameterList& list = section.sublist(name);
    const std::string type = list.get<std::string>("Type");
    if ((type != "Traction" && type != "Point Load" && type != "Line Load") || choosesSurface(list))
      continue; // of a pressure on a closed surface the resultant says nothing
    const std::string points = pointsOf(list);
    std::vector<Acting<D>>& group = groups[points];
    if (group.empty())
      order.push_back(points);
    group.push_back({name, forceOf<D>(judged.scene, list), list.get<std::string>("History")});
  }
  const double end = judged.scene.sublist("Time").template get<double>("Final Time");
  for (const std::string& points : order)
  {
    const std::vector<Acting<D>>& group = groups[points];
    if (group.size() > 1 && cancel(group, end))
      messages.push_back("Boundaries > " + group.front().name +
                         ": it acts on the same points as Boundaries > " + group.back().name +
                         (group.size() > 2 ? " and others" : "") +
                         ", and their forces add up to nothing at all times, so they load nothing; check "
                         "their signs and positions");
  }
  return messages;
}

template Messages judgeCancelling(const JudgedScene<2>&);
template Messages judgeCancelling(const JudgedScene<3>&);

} // namespace Rhegma
