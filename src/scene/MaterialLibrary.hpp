#pragma once
/// The library of materials: constants with their sources, from xml_inputs/materials
/// (docs/reference/materials.md).

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Rhegma
{

/// A file of xml_inputs/materials.
struct MaterialFile
{
  const char* name;
  const char* text;
};

/// All files; CMake makes this function of them.
const std::vector<MaterialFile>& materialFiles();

/// A constant of a material, as its file has it.
struct LibraryConstant
{
  std::string name;   ///< that of the parameter of a scene; of a measured quantity any
  std::string type;   ///< "double" or "string"; empty for a measured quantity
  std::string value;  ///< a number in `unit`, or a text such as a table; empty for a measured quantity
  std::string unit;   ///< empty for a pure number
  std::string range;  ///< "1.17 to 1.20" in `unit`, between which values of the literature lie
  std::string source; ///< keys of sources, with semicolons between them

  /// The number, in `unit`; of a table of a front's speed the value at rest; else not a number.
  double atRest() const;
};

struct LibraryMaterial
{
  std::string name;
  std::string title;             ///< what it is, in a few words
  std::vector<std::string> laws; ///< values of Model, the usual one first
  std::string temperature, rate; ///< ranges of validity
  std::string note;              ///< what a user must know, for example that a law is an approximation
  std::vector<LibraryConstant> constants;
  /// Quantities that follow from constants and were measured themselves, with their ranges.
  std::vector<LibraryConstant> measured;

  /// The constant of a name, or null.
  const LibraryConstant* find(const std::string& constant) const;
  bool hasLaw(const std::string& law) const;
};

struct MaterialLibrary
{
  std::vector<LibraryMaterial> materials;
  std::vector<std::pair<std::string, std::string>> sources; ///< key and citation

  /// The material of a name, or null.
  const LibraryMaterial* find(const std::string& name) const;
  std::vector<std::string> names() const;
};

/// Reads files of materials. \throws std::invalid_argument with the file and what is wrong in it
MaterialLibrary readMaterialLibrary(const std::vector<MaterialFile>& files);

/// The library of this program.
const MaterialLibrary& materialLibrary();

/// Both ends of a range, or nothing where the text is none.
std::optional<std::pair<double, double>> rangeOf(const std::string& range);

/// The message for a name that is not in the library; it lists near names, or all.
std::string unknownMaterial(const std::string& name);

} // namespace Rhegma
