/// No effect and no part of the core looks up the section of an effect by its name: what does not go together
/// is said by rules (scene/Compatibility.hpp), and what one effect must know of another is declared
/// (plan/RunOptions.hpp).

#include "plan/EffectSchema.hpp"
#include "plan/KnownEffects.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

namespace
{

namespace fs = std::filesystem;
using namespace Rhegma;

std::string folderOf(const std::string& effect)
{
  std::string folder;
  for (const char c : effect)
    folder += c == ' ' || c == '-' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return folder;
}

std::string contentOf(const fs::path& file)
{
  std::ifstream in(file);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// The literals "name" of a source that no rule of a section has, and that are no value of a parameter.
int lookUps(const std::string& source, const std::string& name)
{
  const auto count = [&](const std::string& before)
  {
    const std::regex literal(before + "\"" + name + "\"");
    return static_cast<int>(
        std::distance(std::sregex_iterator(source.begin(), source.end(), literal), std::sregex_iterator()));
  };
  return count("") - count("(absent|present|given|is|isNot|above|below|satisfies|needs|namedAfter)\\(\\s*") -
         count("namesOf = ") -
         // Energy Release > Closure Recovery has a value of this name.
         (name == "Mass Matrix" ? count("choice == ") + count("\"Lumped\", ") : 0);
}

TEST(OwnSections, AreAllThatAnEffectLooksUp)
{
  const fs::path root(RHEGMA_SOURCE_DIR);
  for (const char* top : {"src", "packages"})
    for (const auto& entry : fs::recursive_directory_iterator(root / top))
    {
      const std::string extension = entry.path().extension().string();
      if (extension != ".cpp" && extension != ".hpp")
        continue;
      const std::string source = contentOf(entry.path());
      for (const EffectEntry& effect : builtInEffects())
      {
        const std::string& name = effect.section.name;
        if (entry.path().parent_path().filename() == folderOf(name))
          continue;
        EXPECT_EQ(lookUps(source, name), 0) << entry.path() << " names the section " << name;
      }
    }
}

TEST(OwnSections, FindsALookUp)
{
  EXPECT_EQ(lookUps("if (scene.isSublist(\"Thermal\"))", "Thermal"), 1);
  EXPECT_EQ(lookUps("s.refuse({when::present(\"Thermal\")}, why);", "Thermal"), 0);
}

/// Rules name sections and parameters that there are.
TEST(OwnSections, RulesAreAboutWhatASceneMayHave)
{
  const Section& root = effectSchema().root();
  for (const Section& section : root.sections)
    for (const Rule& rule : section.rules)
    {
      EXPECT_FALSE(rule.reason.empty());
      for (const Condition& condition : rule.conditions)
      {
        if (!condition.capability.empty())
          continue;
        const Section* at = nullptr;
        std::string rest = condition.section;
        for (const Section* level = &root; !rest.empty(); level = at)
        {
          const auto end = rest.find(" > ");
          const std::string name = rest.substr(0, end);
          rest = end == std::string::npos ? "" : rest.substr(end + 3);
          at = name == "*" && level->userNamed() ? &level->entry.front() : level->findSection(name);
          ASSERT_NE(at, nullptr) << condition.section;
        }
        bool known = condition.parameter.empty() || at->findParameter(condition.parameter) != nullptr;
        for (const Section& variant : at->variants)
          known = known || variant.findParameter(condition.parameter) != nullptr;
        EXPECT_TRUE(known) << condition.section << " > " << condition.parameter;
      }
    }
}

} // namespace
