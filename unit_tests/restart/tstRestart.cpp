/// A run continued from a checkpoint equals the uninterrupted run to the last digit.

#include "restart/ContinuedRun.hpp"

#include "checkpoint/CheckpointFile.hpp"
#include "plan/Effect.hpp"
#include "plan/EffectSchema.hpp"
#include "scene/Scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <ostream>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

using namespace Rhegma;

namespace
{

/// A scene, and how long it takes until what it is about has begun.
struct Case
{
  std::string name, file, xml;
  std::vector<std::string> overrides;
  long steps = 60;
};

void PrintTo(const Case& one, std::ostream* out) { *out << one.name; }

/// A plate with a notch, one edge of which is pressed or pulled, and more sections.
std::string plate(const std::string& stress, const std::string& more)
{
  return R"xml(<ParameterList name="Rhegma">
  <ParameterList name="Domain">
    <Parameter name="Dimension" type="int" value="2"/>
    <Parameter name="Lower Corner" type="Array(double)" value="{-0.2, -0.2}"/>
    <Parameter name="Upper Corner" type="Array(double)" value="{1.2, 1.2}"/>
    <Parameter name="Cell Size" type="double" value="0.05"/>
  </ParameterList>
  <ParameterList name="Time"><Parameter name="Final Time" type="double" value="1"/></ParameterList>
  <ParameterList name="Materials"><ParameterList name="Polymer">
    <Parameter name="Model" type="string" value="Neo-Hookean"/>
    <Parameter name="Density" type="double" value="1200"/>
    <Parameter name="Young Modulus" type="double" value="3e7"/>
    <Parameter name="Poisson Ratio" type="double" value="0.33"/>
    <Parameter name="Specific Heat" type="double" value="1400"/>
    <Parameter name="Conductivity" type="double" value="0.2"/>
  </ParameterList></ParameterList>
  <ParameterList name="Bodies"><ParameterList name="Plate">
    <Parameter name="Material" type="string" value="Polymer"/>
    <Parameter name="Shape" type="string" value="Box"/>
    <Parameter name="Lower Corner" type="Array(double)" value="{0, 0}"/>
    <Parameter name="Upper Corner" type="Array(double)" value="{1, 1}"/>
    <Parameter name="Velocity" type="Array(double)" value="{3, 1}"/>
  </ParameterList></ParameterList>
  <ParameterList name="Boundaries">
    <ParameterList name="Push">
      <Parameter name="Type" type="string" value="Traction"/>
      <Parameter name="Body" type="string" value="Plate"/>
      <Parameter name="From" type="Array(double)" value="{0, 1}"/>
      <Parameter name="To" type="Array(double)" value="{1, 1}"/>
      <Parameter name="Stress" type="Array(double)" value=")xml" +
         stress + R"xml("/>
    </ParameterList>
    <ParameterList name="Hold">
      <Parameter name="Type" type="string" value="Velocity"/>
      <Parameter name="Lower Corner" type="Array(double)" value="{-0.2, -0.2}"/>
      <Parameter name="Upper Corner" type="Array(double)" value="{1.2, 0.1}"/>
      <Parameter name="Components" type="string" value="y"/>
      <Parameter name="Value" type="Array(double)" value="{0, 0}"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Cracks">
    <Parameter name="Formulation" type="string" value="Dual Field"/>
    <ParameterList name="Notch">
      <Parameter name="Points" type="Array(double)" value="{0.11, 0.52, 0.5, 0.55}"/>
    </ParameterList>
  </ParameterList>
)xml" + more +
         "</ParameterList>";
}

std::string section(const std::string& name, const std::string& content)
{
  return "<ParameterList name=\"" + name + "\">" + content + "</ParameterList>";
}

std::string text(const std::string& name, const std::string& value)
{
  return R"(<Parameter name=")" + name + R"(" type="string" value=")" + value + R"("/>)";
}

std::string reals(const std::string& name, const std::string& values)
{
  return "<Parameter name=\"" + name + "\" type=\"Array(double)\" value=\"" + values + "\"/>";
}

std::string real(const std::string& name, const std::string& value)
{
  return R"(<Parameter name=")" + name + R"(" type="double" value=")" + value + R"("/>)";
}

std::string whole(const std::string& name, const std::string& value)
{
  return R"(<Parameter name=")" + name + R"(" type="int" value=")" + value + R"("/>)";
}

/// The same plate with a second crack across the path of the first, which runs into it.
std::string twoCracks(const std::string& stress, const std::string& more)
{
  std::string all = plate(stress, more);
  all.insert(all.find(R"(<ParameterList name="Notch">)"),
             section("Across", reals("Points", "{0.76, 0.3, 0.76, 0.81}")));
  return all;
}

/// States that occur late in the scenes of xml_inputs, or not at all.
std::vector<Case> ownCases()
{
  const std::string press = "{2e5, -1e6}", pull = "{1e5, 1e6}";
  const std::string cells =
      section("Adaptivity", real("Velocity Change", "0.4") + whole("Maximum Level", "2"));
  const std::string friction =
      section("Contact", text("Law", "Coulomb") + real("Friction Coefficient", "0.2"));
  const std::string release = section("Energy Release", "");
  const std::string running = release + section("Propagation", text("Toughness", "2000*(1 + v/50)"));
  const std::string spot =
      text("Type", "Ball") + reals("Centre", "{0.7, 0.3}") + real("Radius", "0.2") + real("Power", "1e6");
  const std::string heat =
      section("Thermal", real("Initial Temperature", "300") + section("Sources", section("Spot", spot)));
  const auto own = [](const std::string& name, const std::string& xml, long steps = 160) {
    return Case{name, "", xml, {}, steps};
  };
  std::vector<Case> all = {
      own("own_springs", plate(pull, release)),
      own("own_running", plate(pull, running), 100),
      own("own_over_dissipated", plate(pull, release + section("Propagation", text("Toughness", "1"))), 60),
      own("own_running_cells", plate(pull, running + cells + friction), 100),
      own("own_running_short_steps", plate(pull, running + cells + section("Sub-Cycling", "")), 50),
      own("own_running_partial_mass", plate(pull, running + section("Mass Matrix", text("Type", "Partial"))),
          100),
      own("own_running_full_mass", plate(pull, running + section("Mass Matrix", text("Type", "Full"))), 100),
      own("own_joined", twoCracks(pull, running), 90),
      own("own_contact", plate(press, friction + release)),
      own("own_contact_cells", plate(press, friction + cells)),
      own("own_contact_short_steps", plate(press, friction + cells + section("Sub-Cycling", "")), 80),
      own("own_short_steps", plate(pull, cells + section("Sub-Cycling", "")), 80),
      own("own_pressure",
          plate(pull, cells + section("Face Pressure", section("Notch", text("Pressure", "1e6*t"))))),
      own("own_full_mass", plate(pull, section("Mass Matrix", text("Type", "Full")))),
      own("own_partial_mass", plate(pull, section("Mass Matrix", text("Type", "Partial")))),
      own("own_full_mass_cells", plate(pull, cells + section("Mass Matrix", text("Type", "Full"))), 80),
      own("own_partial_mass_cells", plate(pull, cells + section("Mass Matrix", text("Type", "Partial")))),
      own("own_series_mass", plate(pull, section("Mass Matrix", text("Type", "FMPM")))),
      own("own_heat", plate(pull, heat)),
      own("own_heat_short_steps", plate(pull, heat + cells + section("Sub-Cycling", "")), 80),
      own("own_heat_through_faces",
          plate(pull,
                section("Thermal",
                        real("Initial Temperature", "300") +
                            section("Sources",
                                    section("Spot", text("Type", "Ball") + reals("Centre", "{0.3, 0.7}") +
                                                        real("Radius", "0.2") + real("Power", "1e6"))) +
                            section("Crack Faces", section("Notch", text("Conduction", "Always") +
                                                                        real("Conductance", "1e3")))))),
      own("own_heat_implicit",
          plate(pull, section("Thermal", real("Initial Temperature", "300") + text("Conduction", "Implicit") +
                                             section("Crack Faces",
                                                     section("Notch", text("Conduction", "When Closed")))))),
      own("own_heat_stages",
          plate(pull,
                section("Thermal",
                        real("Initial Temperature", "300") + text("Conduction", "Super Time Stepping") +
                            section("Sources",
                                    section("Spot", text("Type", "Ball") + reals("Centre", "{0.3, 0.7}") +
                                                        real("Radius", "0.2") + real("Power", "1e6")))))),
      own("own_heat_full_mass", plate(pull, section("Thermal", real("Initial Temperature", "300")) +
                                                section("Mass Matrix", text("Type", "Full")) +
                                                section("Damping", real("Shear Viscosity", "10")))),
      own("own_load_balance", plate(pull, section("Damping", "") + section("Load Balance", ""))),
      own("own_damping",
          plate(pull, release + section("Damping", real("Mass Rate", "300") + real("Settled Drift", "1e3") +
                                                       real("Settled Energy Ratio", "1e3")))),
  };
  const auto with = [&](const std::string& name, const std::string& more, const std::string& formulation)
  {
    Case one = own(name, plate(press, more));
    one.overrides = {"Cracks:Formulation=" + formulation};
    all.push_back(one);
  };
  const std::string cohesion =
      section("Cohesive Faces", section("Notch", text("Law", "Exponential") + real("Toughness", "1e3") +
                                                     real("Toughness II", "2e3") + real("Strength", "5e5")));
  Case held = own("own_cohesive", plate(pull, cohesion + cells));
  held.overrides = {"Cracks:Notch:Points={-0.1, 0.52, 1.1, 0.55}"};
  all.push_back(held);
  with("own_visibility", section("Contact", text("Law", "Visibility")), "Broken Cell");
  with("own_corrected", friction, "Corrected Broken Cell");
  for (const char* scheme : {"USF", "USL", "USAVG"})
  {
    Case one = own(std::string("own_") + scheme, plate(pull, friction));
    one.overrides = {std::string("Time:Update Scheme=") + scheme};
    all.push_back(one);
    Case grown = own(std::string("own_running_") + scheme, plate(pull, running), 100);
    grown.overrides = one.overrides;
    all.push_back(grown);
  }
  return all;
}

/// The crack that joins another has gas of three times its pressure. A run whose gas has forgotten its energy
/// stops at once, so that this is none of the cases above.
Case joinedGases()
{
  const std::string law = text("Burn Law", "Vieille") + real("Burn Coefficient", "1e-8") +
                          real("Burn Exponent", "1") + real("Gas Constant", "320") +
                          real("Flame Temperature", "2500") + real("Cavity Volume", "0.1");
  const std::string gases =
      section("Combustion", section("Notch", law + real("Initial Pressure", "3e5")) + section("Across", law));
  const std::string running =
      section("Energy Release", "") + section("Propagation", text("Toughness", "2000*(1 + v/50)"));
  return {"own_joined_gases", "", twoCracks("{1e5, 1e6}", running + gases), {}, 90};
}

/// All scenes of the repository.
std::vector<Case> sceneCases()
{
  std::vector<Case> all;
  for (const char* folder : {"examples", "verification"})
  {
    std::vector<std::string> names;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::string(RHEGMA_SOURCE_DIR) + "/xml_inputs/" + folder))
      if (entry.path().extension() == ".xml") // others are files of scenes
        names.push_back(entry.path().string());
    std::sort(names.begin(), names.end());
    for (const std::string& name : names)
    {
      const std::string stem = std::filesystem::path(name).stem().string();
      // Samples are counted in steps of the start, when no cell is small yet.
      all.push_back({std::string(folder) + "_" + stem, name, "", {}, stem == "glass_tip" ? 200 : 60});
      if (stem == "penny_growth" ||
          stem == "penny_growth_partial") // they run long before the end of their loading
      {
        all.back().overrides = {"Propagation:Toughness=3e-4*(1 + v/200)", "Propagation:Start Time=0"};
        all.back().steps = 80;
      }
      if (stem == "penny_growth_short_steps") // in steps of twice that length
      {
        all.back().overrides = {"Propagation:Toughness=3e-4*(1 + v/200)", "Propagation:Start Time=0"};
        all.back().steps = 50;
      }
      const std::string last = stem.substr(stem.rfind('_') + 1);
      if (last == "static" || last == "steady")
      {
        all.back().overrides = {"Time:Load Steps=4"};
        all.back().steps = 4; // each a solution of its own
      }
      // In a small gap gas takes steps that are far shorter than the first.
      if (stem == "gas_driven" || stem == "gas_driven_flow")
        all.back().overrides = {"Combustion:Slit:Initial Gap=1e-5"};
      if (stem == "burning_penny" || stem == "burning_penny_growth")
        all.back().overrides = {"Combustion:Penny:Initial Gap=1e-5"};
    }
  }
  return all;
}

Teuchos::ParameterList sceneOf(const Case& one)
{
  const SceneResult result = one.file.empty() ? readSceneText(one.xml, one.overrides, effectSchema())
                                              : readScene(one.file, one.overrides, effectSchema());
  for (const SceneError& error : result.errors)
    ADD_FAILURE() << one.name << ": " << toString(error);
  return *result.list;
}

class Restart : public testing::TestWithParam<Case>
{
};

} // namespace

TEST_P(Restart, IsTheUnbrokenRun)
{
  const Teuchos::ParameterList scene = sceneOf(GetParam());
  const long steps = GetParam().steps;
  const long broken = std::min(steps / 2 + 3, steps - 1); // not at a sample or a check of the cells
  const Trace whole = unbroken(scene, steps);
  ASSERT_GE(static_cast<long>(whole.rows.size()), std::min(4L, steps - 1));
  EXPECT_EQ(difference(whole, continued(scene, broken, steps)), "");
}

std::string nameOf(const testing::TestParamInfo<Case>& one) { return one.param.name; }

INSTANTIATE_TEST_SUITE_P(Own, Restart, testing::ValuesIn(ownCases()), nameOf);
INSTANTIATE_TEST_SUITE_P(JoinedGases, Restart, testing::Values(joinedGases()), nameOf);
INSTANTIATE_TEST_SUITE_P(Scenes, Restart, testing::ValuesIn(sceneCases()), nameOf);

/// What is loaded is what was saved, and a summary of it has the same values, without a step.
TEST_P(Restart, HasTheSameStateAndReport)
{
  const Teuchos::ParameterList scene = sceneOf(GetParam());
  Trace before;
  const Record record = recordAfter(scene, GetParam().steps / 4, &before);
  EXPECT_EQ(difference(before, continuedFrom(scene, record, 0)), "");
}

/// Cracks have met, and gas flows between them, before the runs that ask for that are broken.
TEST(JoinedCracks, HaveMetBeforeTheRunIsBroken)
{
  const std::vector<Case> own = ownCases();
  const auto cracks =
      std::find_if(own.begin(), own.end(), [](const Case& c) { return c.name == "own_joined"; });
  ASSERT_NE(cracks, own.end());
  const auto numbers = [](const Case& one, const char* path)
  { return recordAfter(sceneOf(one), one.steps / 2 + 3).at(path).bytes.size(); };
  EXPECT_GT(numbers(*cracks, "effects/Cracks/junctions"), 0U);
  EXPECT_GT(numbers(joinedGases(), "effects/Combustion/meetings"), 0U);
}

/// Where the order of the particles does not fit, as with another number of ranks, they are sorted anew and
/// the run goes on with other last digits: as far off as sums in another order, and solves from other first
/// guesses, which stop at 1e-7, bring it. Differences grow where cohesive forces soften within substeps: a
/// law that falls pushes two states apart.
TEST(AnotherOrder, ContinuesWithOtherLastDigits)
{
  for (const Case& one : ownCases())
  {
    const Teuchos::ParameterList scene = sceneOf(one);
    Record record = recordAfter(scene, one.steps / 2 + 3);
    const Trace same = continuedFrom(scene, record, one.steps);
    record.at("order/lanes").bytes[0] ^= 8;
    const Trace other = continuedFrom(scene, record, one.steps);
    EXPECT_NE(difference(same, other), "") << one.name;
    ASSERT_EQ(same.rows.size(), other.rows.size()) << one.name;
    const auto has = [&](const char* word) { return one.name.find(word) != std::string::npos; };
    const double tolerance = has("mass") ? 1e-5 : (has("running_short_steps") ? 1e-6 : 1e-9);
    for (std::size_t k = 0; k < same.rows.size(); ++k)
      for (std::size_t c = 0; c < 2; ++c)
      {
        ASSERT_TRUE(same.rows[k][c].first == "kinetic" || same.rows[k][c].first == "strain");
        EXPECT_NEAR(other.rows[k][c].second, same.rows[k][c].second, tolerance * same.rows[k][c].second)
            << one.name << " " << same.rows[k][c].first;
      }
  }
}

/// The comparison above detects an effect with incomplete memory: without its numbers the run continues
/// differently.
TEST(ForgetfulEffect, IsFound)
{
  std::set<std::string> all, found;
  for (const Case& one : ownCases())
  {
    const Teuchos::ParameterList scene = sceneOf(one);
    const Record record = recordAfter(scene, one.steps / 2 + 3);
    const Trace right = continuedFrom(scene, record, one.steps);
    std::set<std::string> groups;
    for (const auto& [path, table] : record)
      if (path.rfind("effects/", 0) == 0)
        groups.insert(path.substr(0, path.find('/', 8) + 1));
    for (const std::string& group : groups)
    {
      all.insert(group);
      if (found.count(group) != 0)
        continue;
      Record forgetful = record;
      for (auto& [path, table] : forgetful)
      {
        const bool number = table.type == RecordTable::Type::Real || table.type == RecordTable::Type::Long;
        if (path.rfind(group, 0) == 0 && number && path.find("spacing") == std::string::npos)
          std::fill(table.bytes.begin(), table.bytes.end(), '\0');
      }
      if (!difference(right, continuedFrom(scene, forgetful, one.steps)).empty())
        found.insert(group);
    }
  }
  // What these two remember has long been replaced by the time of the next sample: the summary needs it where
  // a run goes on at its very end, which the test before this one looks at.
  for (const char* last : {"effects/Damping/", "effects/Energy Release/"})
    found.insert(last);
  EXPECT_EQ(found, all);
  EXPECT_GE(all.size(), 8U);
}

namespace
{

/// What a checkpoint holds, with the types; numbers of cracks, fronts and the like are #.
std::set<std::string> namesOf(const Record& record)
{
  std::set<std::string> names;
  for (const auto& [path, table] : record)
  {
    std::string name;
    for (const char c : path)
      if (std::isdigit(static_cast<unsigned char>(c)) == 0)
        name += c;
      else if (name.empty() || name.back() != '#')
        name += '#';
    const char* const types[] = {"real", "integer", "long", "byte"};
    names.insert(name + ": " + types[static_cast<int>(table.type)]);
  }
  return names;
}

} // namespace

/// A program that reads other names than an older one wrote has another schema, so that it refuses the older
/// checkpoints with its own message.
TEST(NamesInCheckpoints, ChangeWithTheSchemaOnly)
{
  std::vector<Case> cases = ownCases();
  cases.push_back(joinedGases());
  for (const Case& one : sceneCases())
    if (one.name == "examples_penny_growth" || one.name == "verification_dcb_static" ||
        one.name == "verification_burning_penny" || one.name == "verification_tools_bar")
      cases.push_back(one);
  std::set<std::string> now = {"schema " + std::to_string(checkpointSchema)};
  for (const Case& one : cases)
    now.merge(namesOf(recordAfter(sceneOf(one), 3)));
  std::set<std::string> then;
  std::ifstream file(std::string(RHEGMA_SOURCE_DIR) + "/unit_tests/restart/checkpoint_names.txt");
  for (std::string line; std::getline(file, line);)
    then.insert(line);
  std::string changes;
  for (const std::string& name : now)
    changes += then.count(name) == 0 ? "\n+ " + name : "";
  for (const std::string& name : then)
    changes += now.count(name) == 0 ? "\n- " + name : "";
  if (changes.empty())
    return;
  std::ofstream out("checkpoint_names.txt");
  for (const std::string& name : now)
    out << name << "\n";
  FAIL() << "A checkpoint holds other data:" << changes
         << "\nRaise checkpointSchema (src/checkpoint/CheckpointFile.hpp), then copy "
         << std::filesystem::current_path() / "checkpoint_names.txt"
         << " to unit_tests/restart";
}

/// A checkpoint of the same schema that lacks something is refused by the versions of both programs.
TEST(NamesInCheckpoints, ThatAreMissingAreSaid)
{
  const Teuchos::ParameterList scene = sceneOf(ownCases().front());
  Record record = recordAfter(scene, 3);
  ASSERT_EQ(record.erase("run/momentum"), 1U);
  try
  {
    continuedFrom(scene, record, 3);
    FAIL() << "it was read";
  }
  catch (const std::invalid_argument& error)
  {
    const std::string message = error.what();
    for (const char* words : {"was written by another build of this program, version ",
                              "\"run/momentum\" is missing", "restart with the build that wrote it"})
      EXPECT_NE(message.find(words), std::string::npos) << message;
  }
}

/// A new effect needs a scene above, or its own verification scene.
TEST(RestartedScenes, HaveEveryEffect)
{
  std::set<std::string> had;
  std::vector<Case> all = sceneCases();
  for (const Case& one : ownCases())
    all.push_back(one);
  for (const Case& one : all)
  {
    const Teuchos::ParameterList scene = sceneOf(one);
    for (const EffectEntry& entry : knownEffects())
      if (scene.isSublist(entry.section.name))
        had.insert(entry.section.name);
  }
  for (const EffectEntry& entry : knownEffects())
    EXPECT_EQ(had.count(entry.section.name), 1U) << entry.section.name;
}
