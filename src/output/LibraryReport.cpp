#include "output/LibraryReport.hpp"

#include "base/EntryValue.hpp"
#include "scene/FillFromLibrary.hpp"

namespace Rhegma
{

void reportLibrary(const Teuchos::ParameterList& scene, const SceneSchema& schema, nlohmann::json& summary)
{
  for (const LibraryUse& use : libraryUses(scene, schema))
  {
    nlohmann::json one = {{"where", use.where}, {"material", use.material}, {"written", use.written}};
    one["values"] = nlohmann::json::object();
    for (const LibraryUse::Value& value : use.taken)
      if (const auto* number = valueIf<double>(value.entry))
        one["values"][value.name] = *number;
      else if (const auto* text = valueIf<std::string>(value.entry))
        one["values"][value.name] = *text;
    summary["library"].push_back(one);
  }
}

} // namespace Rhegma
