#include "output/Xdmf.hpp"

#include "archive/Archive.hpp"

#include <algorithm>
#include <cstdio>
#include <zlib.h>

namespace Rhegma
{

namespace
{

std::string escaped(const std::string& text)
{
  std::string safe;
  for (const char c : text)
    switch (c)
    {
    case '&':
      safe += "&amp;";
      break;
    case '<':
      safe += "&lt;";
      break;
    case '"':
      safe += "&quot;";
      break;
    default:
      safe += c;
    }
  return safe;
}

/// Where the numbers of a table are. \param position file and group of its mesh
std::string dataItem(const DataSet& data, const std::string& position)
{
  std::string text = "<DataItem Format=\"HDF\" Dimensions=\"" + std::to_string(data.rowsOfAll());
  if (data.columns > 1)
    text += " " + std::to_string(data.columns);
  text +=
      data.integer ? "\" NumberType=\"Int\" Precision=\"4\">" : "\" NumberType=\"Float\" Precision=\"8\">";
  return text + escaped(position + "/" + data.name) + "</DataItem>";
}

/// Six components are written as a matrix: XDMF's Tensor6 has another order than VTK's, and some readers fill
/// it up to nine.
const char* attributeType(int columns)
{
  return columns == 1 ? "Scalar" : columns == 3 ? "Vector" : columns == 9 ? "Tensor" : "Matrix";
}

std::string attribute(const DataSet& data, const std::string& position)
{
  return "        <Attribute Name=\"" + escaped(data.name) + "\" AttributeType=\"" +
         attributeType(data.columns) + "\" Center=\"" +
         (data.role == DataSet::Role::OnCells ? "Cell" : "Node") + "\">" + dataItem(data, position) +
         "</Attribute>\n";
}

std::string topology(const OutputMesh& mesh, const std::string& position)
{
  std::string text;
  for (const DataSet& data : mesh.data)
    if (data.role == DataSet::Role::Cells)
      text = "        <Topology TopologyType=\"" + mesh.topology + "\" NumberOfElements=\"" +
             std::to_string(data.rowsOfAll()) + "\" NodesPerElement=\"" + std::to_string(data.columns) +
             "\">" + dataItem(data, position) + "</Topology>\n";
  return text;
}

/// \param position file and group of the mesh
std::string grid(const OutputMesh& mesh, double time, const std::string& position)
{
  char digits[40];
  std::snprintf(digits, sizeof digits, "%.17g", time);
  std::string text = "      <Grid Name=\"" + mesh.name + "\" GridType=\"Uniform\">\n";
  text += "        <Time Value=\"" + std::string(digits) + "\"/>\n";
  text += topology(mesh, position);
  for (const DataSet& data : mesh.data)
    if (data.role == DataSet::Role::Points)
      text += "        <Geometry GeometryType=\"XYZ\">" + dataItem(data, position) + "</Geometry>\n";
    else if (data.role != DataSet::Role::Cells)
      text += attribute(data, position);
  return text + "      </Grid>\n";
}

} // namespace

void XdmfDocument::add(const Snapshot& snapshot, const std::string& group)
{
  for (const OutputMesh& mesh : snapshot.meshes)
  {
    auto collection = std::find_if(collections_.begin(), collections_.end(),
                                   [&mesh](const Collection& c) { return c.name == mesh.name; });
    if (collection == collections_.end())
      collection = collections_.insert(collection, {mesh.name, ""});
    collection->grids += grid(mesh, snapshot.time, file_ + ":/" + group + "/" + mesh.name);
  }
}

void XdmfDocument::serialize(Archive& archive)
{
  std::vector<std::string> names, grids;
  for (const Collection& collection : collections_)
  {
    names.push_back(collection.name);
    grids.push_back(collection.grids);
  }
  archive("collections", names);
  archive("grids", grids);
  collections_.clear();
  for (std::size_t k = 0; k < std::min(names.size(), grids.size()); ++k)
    collections_.push_back({names[k], grids[k]});
}

std::string XdmfDocument::text() const
{
  std::string all = "<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">\n  <Domain>\n";
  for (const Collection& collection : collections_)
    all += "    <Grid Name=\"" + collection.name +
           "\" GridType=\"Collection\" CollectionType=\"Temporal\">\n" + collection.grids + "    </Grid>\n";
  all += "  </Domain>\n</Xdmf>\n";
  // So that rhegma-check sees damage.
  return all + "<!-- crc32 of the lines above: " +
         std::to_string(crc32(0, reinterpret_cast<const Bytef*>(all.data()), static_cast<uInt>(all.size()))) +
         " -->\n";
}

} // namespace Rhegma
