#pragma once
/// What the options --materials and --materials-markdown print of the library of materials.

#include <string>

namespace Rhegma::program
{

/// All materials with their constants, ranges, sources and validity.
std::string materialsAsText();

/// One material as a commented block of XML, to be pasted into the section Materials of a scene.
/// \throws UsageError with near names if there is no such material
std::string materialAsXml(const std::string& name);

/// Tables of all materials and of the sources, for docs/reference/materials.md.
std::string materialsAsMarkdown();

} // namespace Rhegma::program
