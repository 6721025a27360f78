#include "scene/MaterialLibrary.hpp"

#include "base/Numbers.hpp"
#include "base/PairTable.hpp"
#include "scene/NearestName.hpp"
#include "scene/XmlReader.hpp"

#include <algorithm>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace Rhegma
{

namespace
{

/// The parts of a text between separators, without blanks at their ends.
std::vector<std::string> splitAt(const std::string& text, char separator)
{
  std::vector<std::string> parts;
  std::istringstream all(text);
  for (std::string part; std::getline(all, part, separator);)
    parts.push_back(trimmed(part));
  return parts;
}

/// Reads one file.
class FileReader
{
public:
  FileReader(const MaterialFile& file, MaterialLibrary& library)
      : name_(file.name), text_(file.text), xml_(text_), library_(library)
  {
  }

  void read()
  {
    try
    {
      for (XmlReader::Item item = xml_.next(); item != XmlReader::Item::End; item = xml_.next())
        if (item == XmlReader::Item::Opening)
          open();
        else if (item == XmlReader::Item::Closing && xml_.tag() == "ParameterList")
          --depth_;
        else if (item == XmlReader::Item::Text)
          fail("has a text outside of its tags");
    }
    catch (const XmlError& error)
    {
      fail(error.what());
    }
  }

private:
  [[noreturn]] void fail(const std::string& reason) const
  {
    throw std::invalid_argument("xml_inputs/materials/" + name_ + ", line " + std::to_string(xml_.line()) +
                                ": " + reason);
  }

  /// \param optional whether the attribute may be absent
  std::string attribute(const char* name, bool optional = false) const
  {
    const std::string* const value = xml_.find(name);
    if (value == nullptr && !optional)
      fail("<" + std::string(xml_.tag()) + "> has no attribute " + name);
    return value == nullptr ? std::string() : *value;
  }

  void open()
  {
    if (xml_.tag() == "ParameterList")
    {
      ++depth_;
      if (depth_ == 2)
        sources_ = attribute("name") == "Sources";
      if (depth_ == 2 && !sources_)
        addMaterial();
      if (depth_ > 2)
        fail("a list is nested too deep");
    }
    else if (depth_ < 2)
      fail("a parameter is outside of any material");
    else if (sources_)
      library_.sources.emplace_back(attribute("name"), attribute("value"));
    else if (xml_.tag() == "Parameter")
      library_.materials.back().constants.push_back({attribute("name"), attribute("type"), attribute("value"),
                                                     attribute("unit", true), attribute("range", true),
                                                     attribute("source")});
    else if (xml_.tag() == "Measured")
      library_.materials.back().measured.push_back(
          {attribute("name"), "", "", attribute("unit", true), attribute("range"), attribute("source")});
    else
      fail("<" + std::string(xml_.tag()) + "> is unknown");
  }

  void addMaterial()
  {
    LibraryMaterial one;
    one.name = attribute("name");
    one.title = attribute("title");
    one.laws = splitAt(attribute("laws"), ',');
    one.temperature = attribute("temperature");
    one.rate = attribute("rate");
    one.note = attribute("note", true);
    if (one.laws.empty() || library_.find(one.name) != nullptr)
      fail("\"" + one.name + "\" has no laws, or is there twice");
    library_.materials.push_back(one);
  }

  std::string name_, text_;
  XmlReader xml_;
  MaterialLibrary& library_;
  int depth_ = 0;
  bool sources_ = false;
};

} // namespace

double LibraryConstant::atRest() const
{
  if (!PairTable::isMeant(value))
    return parseReal(value).value_or(std::numeric_limits<double>::quiet_NaN());
  return PairTable(value, {"a speed and an energy", "speeds", " m/s", "", ""})(0.0);
}

const LibraryConstant* LibraryMaterial::find(const std::string& constant) const
{
  for (const LibraryConstant& one : constants)
    if (one.name == constant)
      return &one;
  return nullptr;
}

bool LibraryMaterial::hasLaw(const std::string& law) const
{
  return std::find(laws.begin(), laws.end(), law) != laws.end();
}

const LibraryMaterial* MaterialLibrary::find(const std::string& name) const
{
  for (const LibraryMaterial& one : materials)
    if (one.name == name)
      return &one;
  return nullptr;
}

std::vector<std::string> MaterialLibrary::names() const
{
  std::vector<std::string> all;
  for (const LibraryMaterial& one : materials)
    all.push_back(one.name);
  return all;
}

MaterialLibrary readMaterialLibrary(const std::vector<MaterialFile>& files)
{
  MaterialLibrary library;
  for (const MaterialFile& file : files)
    FileReader(file, library).read();
  return library;
}

const MaterialLibrary& materialLibrary()
{
  static const MaterialLibrary library = readMaterialLibrary(materialFiles());
  return library;
}

std::optional<std::pair<double, double>> rangeOf(const std::string& range)
{
  const std::string between = " to ";
  const std::size_t at = range.find(between);
  if (at == std::string::npos)
    return {};
  const auto lowest = parseReal(range.substr(0, at));
  const auto highest = parseReal(range.substr(at + between.size()));
  if (!lowest || !highest)
    return {};
  return std::make_pair(*lowest, *highest);
}

std::string unknownMaterial(const std::string& name)
{
  const std::vector<std::string> all = materialLibrary().names();
  // Names that have a word in common, such as all steels, and the one that is most like the given one.
  std::vector<std::string> near;
  const std::string nearest = nearestName(name, all);
  const std::vector<std::string> words = splitAt(lowerCase(name), ' ');
  for (const std::string& one : all)
  {
    const std::string text = lowerCase(one + " " + materialLibrary().find(one)->title);
    const bool common = std::any_of(words.begin(), words.end(),
                                    [&](const std::string& word)
                                    { return word.size() > 2 && text.find(word) != std::string::npos; });
    if (one == nearest || common)
      near.push_back(one);
  }
  return "the library has no material \"" + name + "\"; " +
         (near.empty() ? "it has " + asText(all, " and ") : "did you mean " + asText(near) + "?") +
         (near.empty() ? "." : " All are listed by rhegma --materials.");
}

} // namespace Rhegma
