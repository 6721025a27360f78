#include "geometry/Shape.hpp"

#include "base/MemoryNeed.hpp"
#include "geometry/ShapeFile.hpp"
#include "geometry/VoxelFile.hpp"

#include <Teuchos_Array.hpp>

#include <stdexcept>
#include <string>
#include <vector>

namespace Rhegma
{
namespace Geometry
{
namespace
{

using Teuchos::ParameterEntry;
using Teuchos::ParameterList;
using Array = Teuchos::Array<double>;

/// The section's path as users write it: `Bodies > Beam`.
std::string where(const ParameterList& list)
{
  std::string path = list.name();
  for (std::size_t at = path.find("->"); at != std::string::npos; at = path.find("->", at))
    path.replace(at, 2, " > ");
  const std::string top = "Rhegma > ";
  return path.compare(0, top.size(), top) == 0 ? path.substr(top.size()) : path;
}

[[noreturn]] void fail(const ParameterList& list, const std::string& parameter, const std::string& message)
{
  throw std::invalid_argument(where(list) + " > " + parameter + ": " + message);
}

std::string needed(int numbers) { return std::to_string(numbers) + " numbers (type=\"Array(double)\")"; }

/// A parameter, or null: it is absent, or an empty array.
const ParameterEntry* find(const ParameterList& list, const std::string& name)
{
  const ParameterEntry* const entry = list.getEntryPtr(name);
  const bool empty =
      entry != nullptr && entry->isType<Array>() && Teuchos::getValue<Array>(*entry).size() == 0;
  return empty ? nullptr : entry;
}

bool has(const ParameterList& list, const std::string& name) { return find(list, name) != nullptr; }

void mustBeFinite(const ParameterList& list, const std::string& name, double value)
{
  if (!std::isfinite(value))
    fail(list, name, "a number is infinite or not a number; give finite coordinates in metres.");
}

double number(const ParameterList& list, const std::string& name)
{
  const ParameterEntry* const entry = find(list, name);
  if (entry == nullptr)
    fail(list, name, "is missing; the shape needs this number (type=\"double\").");
  if (!entry->isType<double>())
    fail(list, name, "must be one number (type=\"double\").");
  const double value = Teuchos::getValue<double>(*entry);
  mustBeFinite(list, name, value);
  return value;
}

std::string text(const ParameterList& list, const std::string& name, const char* allowed)
{
  const ParameterEntry* const entry = list.getEntryPtr(name);
  if (entry == nullptr || !entry->isType<std::string>())
    fail(list, name, std::string("is missing; write one of ") + allowed + " (type=\"string\").");
  return Teuchos::getValue<std::string>(*entry);
}

/// \param what is needed, as a function that makes the text, which is for messages only
template <class What>
const Array& numbers(const ParameterList& list, const std::string& name, const What& what)
{
  const ParameterEntry* const entry = list.getEntryPtr(name);
  if (entry != nullptr && !entry->isType<Array>())
    fail(list, name, "must be " + what() + ".");
  // Read once: its type's name is put together each time.
  const Array* const found = entry == nullptr ? nullptr : &Teuchos::getValue<Array>(*entry);
  if (found == nullptr || found->size() == 0)
    fail(list, name, "is missing; the shape needs " + what() + ".");
  const Array& array = *found;
  for (const double value : array)
    mustBeFinite(list, name, value);
  return array;
}

template <int D>
Vector<D> vector(const ParameterList& list, const std::string& name)
{
  const Array& values = numbers(list, name, [] { return needed(D); });
  if (values.size() != D)
    fail(list, name,
         "has " + std::to_string(values.size()) + " numbers; in " + std::to_string(D) + "D it must be " +
             needed(D) + ".");
  Vector<D> result;
  for (int d = 0; d < D; ++d)
    result[d] = values[d];
  return result;
}

double radius(const ParameterList& list)
{
  const double value = number(list, "Radius");
  if (!(value > 0.0))
    fail(list, "Radius", "must be positive.");
  return value;
}

template <int D>
Box<D> readBox(const ParameterList& list)
{
  Box<D> box{{vector<D>(list, "Lower Corner"), vector<D>(list, "Upper Corner")}};
  for (int d = 0; d < D; ++d)
    if (!(box.corners.upper[d] > box.corners.lower[d]))
      fail(list, "Upper Corner", std::string("must lie above Lower Corner along ") + "xyz"[d] + ".");
  return box;
}

template <int D>
Cylinder<D> readCylinder(const ParameterList& list)
{
  if (D == 2)
    fail(list, "Shape", "a Cylinder exists in 3D only; write Ball for a disk or Box for a bar.");
  Cylinder<D> cylinder{vector<D>(list, "From"), vector<D>(list, "To"), radius(list)};
  if (!(norm(cylinder.to - cylinder.from) > 0.0))
    fail(list, "To", "is the same point as From; give the two ends of the cylinder's axis.");
  return cylinder;
}

template <int D>
Polygon<D> readPolygon(const ParameterList& list)
{
  const Array& flat =
      numbers(list, "Points",
              [] { return std::string("pairs of numbers x, y, x, y, ... (type=\"Array(double)\")"); });
  if (flat.size() % 2 != 0 || flat.size() < 6)
    fail(list, "Points",
         "has " + std::to_string(flat.size()) +
             " numbers; a polygon needs x and y of at least three points.");
  Polygon<D> polygon;
  for (Array::size_type i = 0; i < flat.size(); i += 2)
    polygon.points.push_back({{flat[i], flat[i + 1]}});
  if (norm(polygon.points.front() - polygon.points.back()) == 0.0)
    polygon.points.pop_back(); // a closing point that repeats the first
  if (polygon.points.size() < 3 || signedArea(polygon.points) == 0.0)
    fail(list, "Points", "the polygon has no area; its points must not lie on one line.");
  const auto crossing = crossingEdges(polygon.points);
  if (crossing[0] >= 0)
    fail(list, "Points",
         "the edge after point " + std::to_string(crossing[0]) + " meets the edge after point " +
             std::to_string(crossing[1]) +
             " (counted from 0); write the points in order around the outline.");
  if (D == 3)
  {
    polygon.bottom = number(list, "Bottom");
    polygon.top = number(list, "Top");
    if (!(polygon.top > polygon.bottom))
      fail(list, "Top", "must be larger than Bottom.");
  }
  return polygon;
}

template <int D>
FileShape<D> readFile(const ParameterList& list)
{
  const ParameterEntry* const entry = list.getEntryPtr("File");
  if (entry == nullptr || !entry->isType<std::string>())
    fail(list, "File", "is missing; write the path of the file (type=\"string\").");
  FileShape<D> shape{nullptr, has(list, "Scale") ? number(list, "Scale") : 1.0,
                     has(list, "Origin") ? vector<D>(list, "Origin") : Vector<D>{}};
  if (!(shape.scale > 0.0))
    fail(list, "Scale", "must be positive.");
  try
  {
    shape.solid = readSolid<D>(Teuchos::getValue<std::string>(*entry)).solid;
  }
  catch (const std::invalid_argument& wrong)
  {
    fail(list, "File", wrong.what() + std::string("."));
  }
  return shape;
}

template <int D>
VoxelShape<D> readVoxelShape(const ParameterList& list)
{
  const ParameterEntry *const file = list.getEntryPtr("File"), *const value = list.getEntryPtr("Value");
  if (file == nullptr || !file->isType<std::string>())
    fail(list, "File", "is missing; write the path of the file (type=\"string\").");
  if (value == nullptr || !value->isType<int>())
    fail(list, "Value", "is missing; write the value of the body's voxels (type=\"int\").");
  VoxelShape<D> shape{nullptr, number(list, "Voxel Size"),
                      has(list, "Corner") ? vector<D>(list, "Corner") : Vector<D>{}};
  if (!(shape.size > 0.0))
    fail(list, "Voxel Size", "must be positive.");
  try
  {
    shape.phase = readVoxels<D>(Teuchos::getValue<std::string>(*file), Teuchos::getValue<int>(*value),
                                freeMemoryBytes());
  }
  catch (const std::invalid_argument& wrong)
  {
    fail(list, "File", wrong.what() + std::string("."));
  }
  return shape;
}

template <int D>
Primitive<D> readPrimitive(const ParameterList& list)
{
  const char* const allowed =
      D == 2 ? "Box, Ball, Polygon, File, Voxels" : "Box, Ball, Cylinder, Polygon, File, Voxels";
  const std::string name = text(list, "Shape", allowed);
  if (name == "Box")
    return readBox<D>(list);
  if (name == "Ball")
    return Ball<D>{vector<D>(list, "Centre"), radius(list)};
  if (name == "Cylinder")
    return readCylinder<D>(list);
  if (name == "Polygon")
    return readPolygon<D>(list);
  if (name == "File")
    return readFile<D>(list);
  if (name == "Voxels")
    return readVoxelShape<D>(list);
  fail(list, "Shape", "\"" + name + "\" is no shape; write one of " + std::string(allowed) + ".");
}

template <int D>
Axes<D> readAxes(const ParameterList& list)
{
  const double degrees = has(list, "Rotation") ? number(list, "Rotation") : 0.0;
  if constexpr (D == 2)
    return turnedAxes(degrees);
  else
  {
    const Vector<3> about =
        has(list, "Rotation Axis") ? vector<3>(list, "Rotation Axis") : Vector<3>{{0.0, 0.0, 1.0}};
    if (!(norm(about) > 0.0))
      fail(list, "Rotation Axis", "must not be zero; {0, 0, 1} rotates about z.");
    return turnedAxes(degrees, about);
  }
}

template <int D>
Part<D> readPart(const ParameterList& list)
{
  Part<D> part{readPrimitive<D>(list), {readAxes<D>(list), Vector<D>{}}, Operation::Add};
  const auto* const voxels = std::get_if<VoxelShape<D>>(&part.primitive); // of which all values turn together
  part.frame.centre = has(list, "Rotation Centre") ? vector<D>(list, "Rotation Centre")
                      : voxels != nullptr          ? voxels->middle()
                                                   : part.ownBounds().centre();
  return part;
}

/// The base and the operations, in order.
template <int D>
std::vector<Part<D>> readParts(const ParameterList& body)
{
  std::vector<Part<D>> parts{readPart<D>(body)};
  if (body.isSublist("Operations"))
  {
    const ParameterList& operations = body.sublist("Operations");
    for (const auto& entry : operations)
    {
      if (!entry.second.isList())
        fail(operations, entry.first, "is not a list; every operation is a ParameterList with a Shape.");
      const ParameterList& list = operations.sublist(entry.first);
      const std::string operation = text(list, "Operation", "Add, Cut");
      if (operation != "Add" && operation != "Cut")
        fail(list, "Operation", "\"" + operation + "\" is no operation; write one of Add, Cut.");
      parts.push_back(readPart<D>(list));
      parts.back().operation = operation == "Add" ? Operation::Add : Operation::Cut;
    }
  }
  return parts;
}

} // namespace
} // namespace Geometry

template <int D>
Shape<D> makeShape(const Teuchos::ParameterList& body)
{
  return Shape<D>(Geometry::readParts<D>(body));
}

template Shape<2> makeShape<2>(const Teuchos::ParameterList&);
template Shape<3> makeShape<3>(const Teuchos::ParameterList&);

} // namespace Rhegma
