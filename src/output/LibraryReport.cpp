#include "output/LibraryReport.hpp"

#include "base/EntryValue.hpp"
#include "scene/FillFromLibrary.hpp"

#include <Teuchos_Array.hpp>

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
      else if (const auto* numbers = valueIf<Teuchos::Array<double>>(value.entry))
        one["values"][value.name] = std::vector<double>(numbers->begin(), numbers->end());
    summary["library"].push_back(one);
  }
}

} // namespace Rhegma
