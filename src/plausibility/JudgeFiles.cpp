#include "base/EntryValue.hpp"
#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "geometry/Shape.hpp"
#include "geometry/ShapeFile.hpp"
#include "plausibility/Judges.hpp"

#include <algorithm>

namespace Rhegma
{

namespace
{

/// Largest extent of a body in metres from which its file seems to be in millimetres: parts of machines are
/// rarely larger, and rarely smaller than this in millimetres.
constexpr double seemsMillimetres = 2.0;

template <int D>
std::string extentsOf(const Geometry::Bounds<D>& bounds)
{
  std::string text;
  for (int d = 0; d < D; ++d)
    text += (d == 0 ? "" : " x ") + formatReal(bounds.upper[d] - bounds.lower[d]);
  return text + " m";
}

template <int D>
void judgeFile(const Teuchos::ParameterList& list, const Geometry::Part<D>& part, const std::string& where,
               Messages& messages)
{
  const std::string path = list.get<std::string>("File");
  for (const std::string& note : Geometry::readSolid<D>(path).notes)
    messages.push_back(where + " > File: " + path + ": " + note);
  const Geometry::Bounds<D> bounds = part.ownBounds();
  double largest = 0.0;
  for (int d = 0; d < D; ++d)
    largest = std::max(largest, bounds.upper[d] - bounds.lower[d]);
  if (!list.isParameter("Scale") && largest >= seemsMillimetres)
    messages.push_back(where + " > Scale: without it, numbers of the file are metres, so the shape is " +
                       extentsOf(bounds) + "; is the file in millimetres? Then write Scale = 0.001, else 1");
}

} // namespace

template <int D>
Messages judgeFiles(const Teuchos::ParameterList& scene)
{
  Messages messages;
  const Teuchos::ParameterList& section = scene.sublist("Bodies");
  for (const std::string& name : sublistNames(section))
  {
    const Teuchos::ParameterList& body = section.sublist(name);
    std::vector<std::pair<std::string, const Teuchos::ParameterList*>> lists{{"Bodies > " + name, &body}};
    if (body.isSublist("Operations"))
      for (const std::string& operation : sublistNames(body.sublist("Operations")))
        lists.emplace_back(lists.front().first + " > Operations > " + operation,
                           &body.sublist("Operations").sublist(operation));
    const auto isFile = [](const auto& list)
    { return list.second->template get<std::string>("Shape") == "File"; };
    if (std::none_of(lists.begin(), lists.end(), isFile))
      continue;
    const Shape<D> shape = makeShape<D>(body);
    for (std::size_t k = 0; k < lists.size(); ++k)
      if (isFile(lists[k]))
        judgeFile<D>(*lists[k].second, shape.parts()[k], lists[k].first, messages);
  }
  return messages;
}

template Messages judgeFiles<2>(const Teuchos::ParameterList&);
template Messages judgeFiles<3>(const Teuchos::ParameterList&);

} // namespace Rhegma
