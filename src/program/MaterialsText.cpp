#include "program/MaterialsText.hpp"

#include "base/Numbers.hpp"
#include "base/PairTable.hpp"
#include "base/ShortNumber.hpp"
#include "plan/EffectSchema.hpp"
#include "program/Options.hpp"
#include "scene/DerivedConstants.hpp"
#include "scene/MaterialLibrary.hpp"
#include "scene/NearestName.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace Rhegma::program
{

namespace
{

/// Four digits, without an exponent for large numbers.
std::string fourDigits(double value)
{
  const double last = std::pow(10.0, std::max(0.0, std::floor(std::log10(std::fabs(value))) - 3.0));
  return value < 1e4 ? formatShort(value) : formatReal(last * std::round(value / last));
}

/// The number of a measured quantity that follows from the constants, in its unit.
std::string derivedText(const DerivedConstants& d, const std::string& quantity)
{
  if (quantity == "Longitudinal Wave Speed")
    return fourDigits(d.longitudinal);
  if (quantity == "Shear Wave Speed")
    return fourDigits(d.shear);
  if (quantity == "Rayleigh Wave Speed")
    return fourDigits(d.rayleigh);
  return d.intensity ? fourDigits(1e-6 * *d.intensity) : "-";
}

std::string inColumn(const std::string& text, std::size_t width)
{
  return text + std::string(text.size() < width ? width - text.size() : 1, ' ');
}

std::string withUnit(const std::string& value, const std::string& unit)
{
  return unit.empty() ? value : value + " " + unit;
}

/// A line of a constant, or of a quantity that follows from constants.
std::string line(const std::string& name, const std::string& value, const LibraryConstant& constant,
                 const char* range)
{
  return "    " + inColumn(name, 25) + inColumn(withUnit(value, constant.unit), 24) +
         inColumn(constant.range.empty() ? "" : range + constant.range, 28) + constant.source + "\n";
}

std::string sourcesAsText(const std::string& start)
{
  std::string text;
  for (const auto& [key, citation] : materialLibrary().sources)
    text += start + key + ": " + citation + "\n";
  return text;
}

std::string parameterXml(const LibraryConstant& constant)
{
  return "<Parameter name=\"" + constant.name + "\" type=\"" + constant.type + "\" value=\"" +
         constant.value + "\"" +
         (constant.type == "double" && !constant.unit.empty() ? " unit=\"" + constant.unit + "\"" : "") +
         "/>";
}

std::string evidence(const LibraryConstant& constant)
{
  return (constant.range.empty() ? "" : constant.range + ": ") + constant.source;
}

/// Whether a law of the scene has a parameter.
bool lawHas(const std::string& law, const std::string& parameter)
{
  const Section* materials = effectSchema().root().findSection("Materials");
  const Section& material = materials->entry.front();
  const Section* variant = material.findVariant(law);
  return material.findParameter(parameter) != nullptr ||
         (variant != nullptr && variant->findParameter(parameter) != nullptr);
}

/// Citations of the sources that a material names.
std::string citations(const LibraryMaterial& material)
{
  std::string named;
  for (const auto* list : {&material.constants, &material.measured})
    for (const LibraryConstant& constant : *list)
      named += "; " + constant.source + ";";
  std::string text;
  for (const auto& [key, citation] : materialLibrary().sources)
    if (named.find("; " + key + ";") != std::string::npos)
      text += "       " + key + ": " + citation + "\n";
  return text;
}

} // namespace

std::string materialsAsText()
{
  std::string text =
      "Materials of the library. Use one with Materials > NAME > Material From Library and "
      "Propagation >\nToughness From Library. Numbers: value, range of the literature, sources "
      "(listed at the end).\n\n";
  for (const LibraryMaterial& material : materialLibrary().materials)
  {
    const DerivedConstants derived = deriveConstants(material, effectSchema());
    text += material.name + ": " + material.title + "\n    Laws: " + Rhegma::asText(material.laws, ", ") +
            ". Valid for " + material.temperature + "; rate: " + material.rate + ".\n" +
            (material.note.empty() ? "" : "    " + material.note + "\n");
    for (const LibraryConstant& constant : material.constants)
      text += line(constant.name, constant.value, constant, "");
    for (const LibraryConstant& quantity : material.measured)
      text += line(quantity.name, derivedText(derived, quantity.name), quantity, "measured ");
    text += "\n";
  }
  return text + "Sources:\n" + sourcesAsText("  ");
}

std::string materialAsXml(const std::string& name)
{
  const LibraryMaterial* found = materialLibrary().find(name);
  if (found == nullptr)
    throw UsageError("--materials: " + unknownMaterial(name));
  std::string text = "<!-- " + found->name + ": " + found->title + ".\n     Valid for " + found->temperature +
                     "; rate: " + found->rate + "." + (found->note.empty() ? "" : "\n     " + found->note) +
                     "\n     After each number: range of the literature, and sources:\n" + citations(*found) +
                     "-->\n<ParameterList name=\"" + found->name + "\">\n";
  text += "  <Parameter name=\"Model\" type=\"string\" value=\"" + found->laws.front() + "\"/>" +
          (found->laws.size() > 1
               ? " <!-- or " + Rhegma::asText({found->laws.begin() + 1, found->laws.end()}) + " -->"
               : "") +
          "\n";
  std::string others;
  for (const LibraryConstant& constant : found->constants)
    if (lawHas(found->laws.front(), constant.name))
      text += "  " + parameterXml(constant) + " <!-- " + evidence(constant) + " -->\n";
    else if (constant.name == "Toughness")
      others += "<!-- In the section Propagation: " + parameterXml(constant) + " (J/m2; " +
                evidence(constant) + ") -->\n";
    else
      text += "  <!-- of another law: " + parameterXml(constant) + " (" + evidence(constant) + ") -->\n";
  return text + "</ParameterList>\n" + others;
}

std::string materialsAsMarkdown()
{
  std::string text =
      "| Material | Laws | Density [kg/m3] | E [GPa] | nu | Yield [MPa] | c_L, c_S, c_R [m/s] | "
      "Gc at rest [J/m2] | K_Ic [MPa m^0.5] | Temperature |\n"
      "|:--|:--|--:|--:|--:|--:|--:|--:|--:|:--|\n";
  for (const LibraryMaterial& material : materialLibrary().materials)
  {
    const DerivedConstants d = deriveConstants(material, effectSchema());
    const LibraryConstant* yield = material.find("Yield Stress");
    const LibraryConstant* toughness = material.find("Toughness");
    const bool bySpeed = toughness != nullptr && PairTable::isMeant(toughness->value);
    text += "| " + material.name + " | " + Rhegma::asText(material.laws, ", ") + " | " +
            fourDigits(d.density) + " | " + fourDigits(1e-9 * d.young) + " | " + fourDigits(d.poisson) +
            " | " + (yield == nullptr ? "" : yield->value) + " | " + fourDigits(d.longitudinal) + ", " +
            fourDigits(d.shear) + ", " + fourDigits(d.rayleigh) + " | " +
            (d.toughness ? fourDigits(*d.toughness) : "") + (bySpeed ? ", by speed" : "") + " | " +
            (d.intensity ? fourDigits(1e-6 * *d.intensity) : "") + " | " + material.temperature + " |\n";
  }
  return text;
}

} // namespace Rhegma::program
