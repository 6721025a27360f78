/// An effect that a scene does not ask for leaves no trace in its run: no field, no kernel, no memory, no
/// stage.
///
/// What belongs to an effect is read from its sources (labels of kernels and views in packages/NAME) and from
/// the effect as the registry makes it (fields, calls). Each effect must show in a scene with its section, so
/// the check can fail, and in no scene without.

#include "KernelProfile.hpp"
#include "plan/EffectSchema.hpp"
#include "plan/KnownEffects.hpp"
#include "scene/Scene.hpp"
#include "step/Run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>

using namespace Rhegma;

namespace
{

using Names = std::set<std::string>;

/// A square that flies and turns, 100 cells. Without a load, because loads take kernels that cracks take too.
const char* const bare = R"xml(
  <ParameterList name="Domain">
    <Parameter name="Dimension" type="int" value="2"/>
    <Parameter name="Lower Corner" type="Array(double)" value="{-0.4, -0.4}"/>
    <Parameter name="Upper Corner" type="Array(double)" value="{1.4, 1.4}"/>
    <Parameter name="Cell Size" type="double" value="0.1"/>
  </ParameterList>
  <ParameterList name="Time">
    <Parameter name="Final Time" type="double" value="1e-3"/>
  </ParameterList>
  <ParameterList name="Materials">
    <ParameterList name="Polymer">
      <Parameter name="Model" type="string" value="Linear Elastic"/>
      <Parameter name="Density" type="double" value="1200"/>
      <Parameter name="Young Modulus" type="double" value="3e9"/>
      <Parameter name="Poisson Ratio" type="double" value="0.33"/>
      <Parameter name="Specific Heat" type="double" value="1400"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Bodies">
    <ParameterList name="Plate">
      <Parameter name="Material" type="string" value="Polymer"/>
      <Parameter name="Shape" type="string" value="Box"/>
      <Parameter name="Lower Corner" type="Array(double)" value="{0, 0}"/>
      <Parameter name="Upper Corner" type="Array(double)" value="{1, 1}"/>
      <Parameter name="Velocity" type="Array(double)" value="{3, 1}"/>
      <Parameter name="Angular Velocity" type="Array(double)" value="{20}"/>
    </ParameterList>
  </ParameterList>
)xml";

const std::string cracks = R"xml(
  <ParameterList name="Cracks">
    <ParameterList name="Notch"><Parameter name="Points" type="Array(double)" value="{0, 0.5, 0.5, 0.5}"/></ParameterList>
  </ParameterList>
)xml";

/// The sections that each effect needs, its own last.
const std::map<std::string, std::string> sectionsOf = {
    {"Cracks", cracks},
    {"Adaptivity", R"xml(<ParameterList name="Adaptivity"><ParameterList name="Corner">
       <Parameter name="Lower Corner" type="Array(double)" value="{0, 0}"/>
       <Parameter name="Upper Corner" type="Array(double)" value="{0.3, 0.3}"/>
       <Parameter name="Level" type="int" value="1"/></ParameterList></ParameterList>)xml"},
    {"Sub-Cycling", R"xml(<ParameterList name="Adaptivity"><ParameterList name="Corner">
       <Parameter name="Lower Corner" type="Array(double)" value="{0, 0}"/>
       <Parameter name="Upper Corner" type="Array(double)" value="{0.3, 0.3}"/>
       <Parameter name="Level" type="int" value="1"/></ParameterList></ParameterList>
       <ParameterList name="Sub-Cycling"/>)xml"},
    {"Combustion", cracks + R"xml(<ParameterList name="Combustion"><ParameterList name="Notch">
       <Parameter name="Burn Law" type="string" value="Vieille"/>
       <Parameter name="Burn Coefficient" type="double" value="1e-8"/>
       <Parameter name="Burn Exponent" type="double" value="0.9"/>
       <Parameter name="Gas Constant" type="double" value="320"/>
       <Parameter name="Flame Temperature" type="double" value="2500"/>
       <Parameter name="Initial Gap" type="double" value="1e-3"/></ParameterList></ParameterList>)xml"},
    {"Contact", cracks + "<ParameterList name=\"Contact\"/>"},
    {"Cohesive Faces", R"xml(<ParameterList name="Cracks"><ParameterList name="Joint">
       <Parameter name="Points" type="Array(double)" value="{0, 0.5, 1, 0.5}"/></ParameterList></ParameterList>
       <ParameterList name="Cohesive Faces"><ParameterList name="Joint">
       <Parameter name="Toughness" type="double" value="100"/>
       <Parameter name="Strength" type="double" value="1e5"/></ParameterList></ParameterList>)xml"},
    {"Measure",
     cracks + R"xml(<ParameterList name="Measure"><ParameterList name="Side Energy"/></ParameterList>)xml"},
    {"Propagation", cracks + R"xml(<ParameterList name="Energy Release"/>
       <ParameterList name="Propagation"><Parameter name="Toughness" type="string" value="100"/></ParameterList>)xml"},
    {"Damping", R"xml(<ParameterList name="Damping"><Parameter name="Mass Rate" type="double" value="10"/>
       <Parameter name="Shear Viscosity" type="double" value="1"/></ParameterList>)xml"},
    {"Energy Release", cracks + R"xml(<ParameterList name="Energy Release">
       <Parameter name="Inner Radius" type="double" value="0.2"/>
       <Parameter name="Outer Radius" type="double" value="0.4"/></ParameterList>)xml"},
    {"Face Pressure", cracks + R"xml(<ParameterList name="Face Pressure"><ParameterList name="Notch">
       <Parameter name="Pressure" type="string" value="1e5"/></ParameterList></ParameterList>)xml"},
    {"Thermal", R"xml(<ParameterList name="Thermal">
       <Parameter name="Initial Temperature" type="double" value="300"/>
       <ParameterList name="Sources"><ParameterList name="Spot">
       <Parameter name="Type" type="string" value="Ball"/>
       <Parameter name="Centre" type="Array(double)" value="{0.5, 0.5}"/>
       <Parameter name="Radius" type="double" value="0.3"/>
       <Parameter name="Power" type="double" value="1"/></ParameterList></ParameterList></ParameterList>)xml"},
    {"Body Contact", "<ParameterList name=\"Body Contact\"/>"},
    {"Rigid Tools", R"xml(<ParameterList name="Rigid Tools"><ParameterList name="Wall">
       <Parameter name="Shape" type="string" value="Box"/>
       <Parameter name="Lower Corner" type="Array(double)" value="{-0.2, -0.2}"/>
       <Parameter name="Upper Corner" type="Array(double)" value="{1.2, -0.05}"/></ParameterList></ParameterList>)xml"},
    {"Load Balance", "<ParameterList name=\"Load Balance\"/>"},
    {"Mass Matrix", R"xml(<ParameterList name="Mass Matrix">
       <Parameter name="Type" type="string" value="Full"/></ParameterList>)xml"},
};

bool hasScene(const std::string& effect) { return sectionsOf.count(effect) > 0; }

/// What a run of a few steps, the last with a sample, left behind.
struct Trace
{
  Names kernels, memory, fields, calls, effects;
  std::string plan;
};

Trace runScene(const std::string& sections)
{
  const SceneResult scene =
      readSceneText("<ParameterList name=\"Rhegma\">" + std::string(bare) + sections + "</ParameterList>", {},
                    effectSchema());
  for (const SceneError& error : scene.errors)
    ADD_FAILURE() << toString(error);
  Trace trace;
  const KernelProfile profile;
  Run<2> run(*scene.list);
  run.initialize();
  for (int step = 0; step < 3; ++step)
    run.step(1e-3, step == 2);
  trace.kernels = profile.kernels();
  trace.memory = profile.memory();
  for (const Field& field : run.state().particles.fields())
    trace.fields.insert(field.name);
  for (const auto& stage : run.plan().calls)
    for (const Call<2>& call : stage)
      trace.calls.insert(call.label);
  for (const std::string& name : run.effectNames())
    trace.effects.insert(name);
  trace.plan = printPlan(run.plan(), run.state());
  return trace;
}

const Trace& traceWith(const std::string& effect)
{
  static std::map<std::string, Trace> traces;
  if (traces.count(effect) == 0)
    traces[effect] = runScene(effect.empty() ? "" : sectionsOf.at(effect));
  return traces[effect];
}

/// Labels "rhegma::..." in the sources below a folder of the repository.
Names labelsIn(const std::string& position)
{
  namespace fs = std::filesystem;
  const fs::path path = fs::path(RHEGMA_SOURCE_DIR) / position;
  std::vector<fs::path> files;
  if (fs::is_directory(path))
    for (const auto& entry : fs::recursive_directory_iterator(path))
      files.push_back(entry.path());
  else
    files.push_back(path);
  Names labels;
  const std::regex label("\"(rhegma::[^\"]+)\"");
  for (const fs::path& file : files)
  {
    std::ifstream in(file);
    std::ostringstream text;
    text << in.rdbuf();
    const std::string source = text.str();
    for (std::sregex_iterator found(source.begin(), source.end(), label), end; found != end; ++found)
      labels.insert((*found)[1]);
  }
  return labels;
}

std::string folderOf(std::string effect)
{
  for (char& c : effect)
    c = c == ' ' || c == '-' ? '_' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return "packages/" + effect;
}

Names common(const Names& a, const Names& b)
{
  Names both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::inserter(both, both.end()));
  return both;
}

Names minus(const Names& a, const Names& b)
{
  Names rest;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::inserter(rest, rest.end()));
  return rest;
}

std::string asText(const Names& names)
{
  std::string all;
  for (const std::string& name : names)
    all += (all.empty() ? "" : ", ") + name;
  return all;
}

/// Fields and calls of an effect, from the effect itself.
Names fieldsOf(const std::string& effect)
{
  Names names;
  for (const EffectEntry& entry : knownEffects())
    if (entry.section.name == effect)
    {
      const SceneResult scene = readSceneText("<ParameterList name=\"Rhegma\">" + std::string(bare) +
                                                  sectionsOf.at(effect) + "</ParameterList>",
                                              {}, effectSchema());
      for (const Field& field : entry.make2(*scene.list, declaredOptions(*scene.list)).adds)
        names.insert(field.name);
    }
  return names;
}

Names callsOf(const std::string& effect)
{
  Names names;
  for (const EffectEntry& entry : knownEffects())
    if (entry.section.name == effect)
    {
      const SceneResult scene = readSceneText("<ParameterList name=\"Rhegma\">" + std::string(bare) +
                                                  sectionsOf.at(effect) + "</ParameterList>",
                                              {}, effectSchema());
      for (const Call<2>& call : entry.make2(*scene.list, declaredOptions(*scene.list)).calls)
        names.insert(call.label);
    }
  return names;
}

/// One effect: its name in the registry.
class AbsentEffects : public testing::TestWithParam<std::string>
{
};

std::vector<std::string> effectNames()
{
  std::vector<std::string> names;
  for (const EffectEntry& entry : knownEffects())
    names.push_back(entry.section.name);
  return names;
}

} // namespace

TEST_P(AbsentEffects, HasASceneHere)
{
  EXPECT_TRUE(hasScene(GetParam())) << "write a scene of " << GetParam() << " into sectionsOf";
  EXPECT_TRUE(std::filesystem::is_directory(std::filesystem::path(RHEGMA_SOURCE_DIR) / folderOf(GetParam())));
}

/// The reverse of what follows, without which that would mean nothing.
TEST_P(AbsentEffects, ShowsWithItsSection)
{
  const std::string effect = GetParam();
  if (!hasScene(effect))
    GTEST_SKIP() << "HasASceneHere fails for " << effect;
  const Trace& trace = traceWith(effect);
  EXPECT_EQ(trace.effects.count(effect), 1u);
  // Propagation decides on the host: its folder has no kernel.
  EXPECT_EQ(labelsIn(folderOf(effect)).empty(), effect == "Propagation");
  EXPECT_EQ(common(labelsIn(folderOf(effect)), trace.kernels).empty(), labelsIn(folderOf(effect)).empty())
      << "no kernel of " << folderOf(effect) << " ran; there ran " << asText(trace.kernels);
  EXPECT_EQ(asText(minus(fieldsOf(effect), trace.fields)), "");
  // Measure acts at the start and in the report alone.
  EXPECT_EQ(callsOf(effect).empty(), effect == "Measure");
  EXPECT_EQ(asText(minus(callsOf(effect), trace.calls)), "");
  for (const std::string& call : callsOf(effect))
    EXPECT_NE(trace.plan.find(call), std::string::npos) << call << " is not in\n" << trace.plan;
  for (const std::string& field : fieldsOf(effect))
    EXPECT_NE(trace.plan.find("  " + field + " ("), std::string::npos) << field << " is not in\n"
                                                                       << trace.plan;
}

TEST_P(AbsentEffects, LeavesNoTraceWithoutItsSection)
{
  const std::string effect = GetParam();
  if (!hasScene(effect))
    GTEST_SKIP() << "HasASceneHere fails for " << effect;
  std::vector<std::string> scenes = {""}; // the bare scene
  for (const std::string& name : effectNames())
    if (hasScene(name))
      scenes.push_back(name);
  int looked = 0;
  for (const std::string& other : scenes)
  {
    const Trace& trace = traceWith(other);
    if (trace.effects.count(effect) > 0)
      continue;
    ++looked;
    SCOPED_TRACE("in the scene " + (other.empty() ? "without effects" : "of " + other));
    EXPECT_EQ(asText(common(labelsIn(folderOf(effect)), trace.kernels)), "");
    EXPECT_EQ(asText(common(labelsIn(folderOf(effect)), trace.memory)), "");
    EXPECT_EQ(asText(common(fieldsOf(effect), trace.fields)), "");
    EXPECT_EQ(asText(common(callsOf(effect), trace.calls)), "");
    const std::string effects = trace.plan.substr(0, trace.plan.find('\n'));
    EXPECT_EQ((effects + ",").find(", " + effect + ","), std::string::npos) << effects;
    for (const std::string& call : callsOf(effect))
      EXPECT_EQ(trace.plan.find(call), std::string::npos) << trace.plan;
    for (const std::string& field : fieldsOf(effect))
      EXPECT_EQ(trace.plan.find("  " + field + " ("), std::string::npos) << trace.plan;
  }
  EXPECT_GE(looked, 1);
}

INSTANTIATE_TEST_SUITE_P(Registry, AbsentEffects, testing::ValuesIn(effectNames()),
                         [](const testing::TestParamInfo<std::string>& effect)
                         {
                           std::string name = effect.param;
                           name.erase(std::remove_if(name.begin(), name.end(),
                                                     [](char c) { return c == ' ' || c == '-'; }),
                                      name.end());
                           return name;
                         });

/// What the core keeps for effects alone: stored stencils and points on crack faces.
TEST(BareScene, RunsNoKernelThatServesEffects)
{
  for (const char* const source : {"src/transfer/Stencils.cpp", "src/transfer/FacePoints.cpp"})
  {
    const Names labels = labelsIn(source);
    ASSERT_FALSE(labels.empty()) << source;
    EXPECT_EQ(asText(common(labels, traceWith("").kernels)), "") << source;
    EXPECT_EQ(asText(common(labels, traceWith("").memory)), "") << source;
    EXPECT_FALSE(common(labels, traceWith("Contact").kernels).empty()) << source;
  }
  EXPECT_FALSE(traceWith("").kernels.empty());
  EXPECT_TRUE(traceWith("").effects.empty());
}

/// Damping has two parts, each a number of its own; a part that is zero is absent like an effect.
TEST(BareScene, HasNoViscousStressWithMassDampingAlone)
{
  const Trace mass = runScene(
      R"xml(<ParameterList name="Damping"><Parameter name="Mass Rate" type="double" value="10"/></ParameterList>)xml");
  EXPECT_EQ(mass.kernels.count("rhegma::dampVelocity"), 1u);
  EXPECT_EQ(mass.kernels.count("rhegma::viscousStress"), 0u);
  EXPECT_EQ(asText(common(fieldsOf("Damping"), mass.fields)), "");
  EXPECT_EQ(traceWith("Damping").kernels.count("rhegma::viscousStress"), 1u);
}
