/// Scenes with many bodies and cracks: the work to read and check them is proportional to their number. It is
/// counted in allocations of memory and in bytes, not in seconds, so that a busy machine changes nothing.

#include "Scenes.hpp"

#include "scene/SceneParts.hpp"

#include <cstdlib>
#include <new>

namespace
{

/// Since the start of the program.
long allocations = 0;
double bytes = 0.0;

} // namespace

/// Not inlined: the compiler would take the pair of them for a mismatch.
[[gnu::noinline]] void* operator new(std::size_t size)
{
  ++allocations;
  bytes += static_cast<double>(size);
  if (void* const memory = std::malloc(size > 0 ? size : 1))
    return memory;
  throw std::bad_alloc();
}

[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

using namespace Rhegma;
using namespace Rhegma::SceneTests;

namespace
{

std::string listOf(const std::string& section, int count, const std::function<std::string(int)>& content)
{
  std::string text = "<ParameterList name=\"" + section + "\">";
  for (int k = 0; k < count; ++k)
    text += "<ParameterList name=\"Part " + std::to_string(k) + "\">" + content(k) + "</ParameterList>";
  return text + "</ParameterList>";
}

std::string numbers(const std::string& name, std::initializer_list<double> values)
{
  std::string text;
  for (const double value : values)
    text += (text.empty() ? "" : ", ") + std::to_string(value);
  return parameter(name, "Array(double)", "{" + text + "}");
}

std::string bodies(int count, const std::string& material)
{
  return listOf("Bodies", count,
                [&](int k)
                {
                  return parameter("Material", "string", material) + parameter("Shape", "string", "Box") +
                         numbers("Lower Corner", {double(k), 0.0}) + numbers("Upper Corner", {k + 0.5, 0.5});
                });
}

/// \param shape whether the cracks have one
std::string cracks(int count, bool shape)
{
  return listOf("Cracks", count,
                [&](int k) {
                  return shape ? numbers("Points", {k + 0.2, 0.2, k + 0.4, 0.2})
                               : parameter("Points", "string", "none");
                });
}

std::string sceneOf(int count, const std::string& parts)
{
  return "<ParameterList name=\"Rhegma\"><ParameterList name=\"Domain\">" +
         parameter("Dimension", "int", "2") + numbers("Lower Corner", {-1.0, -1.0}) +
         numbers("Upper Corner", {count + 1.0, 2.0}) + parameter("Cell Size", "double", "0.25") +
         "</ParameterList><ParameterList name=\"Time\">" + parameter("Final Time", "double", "1e-3") +
         "</ParameterList><ParameterList name=\"Materials\"><ParameterList name=\"Steel\">" +
         parameter("Model", "string", "Linear Elastic") + parameter("Density", "double", "7800") +
         parameter("Young Modulus", "double", "2.1e11") + parameter("Poisson Ratio", "double", "0.3") +
         "</ParameterList></ParameterList>" + parts + "</ParameterList>";
}

struct Cost
{
  long allocations;
  double bytes;
  std::size_t errors;
};

Cost costOf(const std::string& scene)
{
  const long allocationsBefore = allocations;
  const double bytesBefore = bytes;
  const SceneResult result = readSceneText(scene, {}, effectSchema());
  return {allocations - allocationsBefore, bytes - bytesBefore, result.errors.size()};
}

/// Four times as many parts take four times as much, but for what a scene without parts takes.
void expectProportional(const std::function<std::string(int)>& scene, int errorsPerPart)
{
  constexpr int few = 300, many = 4 * few;
  costOf(scene(few)); // what is made once
  const Cost small = costOf(scene(few)), large = costOf(scene(many));
  EXPECT_EQ(small.errors, std::size_t(few * errorsPerPart));
  EXPECT_EQ(large.errors, std::size_t(many * errorsPerPart));
  EXPECT_LT(double(large.allocations), 4.2 * double(small.allocations));
  EXPECT_LT(large.bytes, 4.4 * small.bytes); // arrays that grow take up to twice what they hold
}

} // namespace

TEST(ManyParts, OfBodies)
{
  expectProportional([](int n) { return sceneOf(n, bodies(n, "Steel")); }, 0);
}

TEST(ManyParts, OfBodiesWithErrors)
{
  expectProportional([](int n) { return sceneOf(n, bodies(n, "Iron")); }, 1);
}

TEST(ManyParts, OfCracks)
{
  expectProportional([](int n) { return sceneOf(n, bodies(1, "Steel") + cracks(n, true)); }, 0);
}

TEST(ManyParts, OfCracksWithErrors)
{
  expectProportional([](int n) { return sceneOf(n, bodies(1, "Steel") + cracks(n, false)); }, 1);
}

/// What a body takes in all: lists that are copied or texts that are made for messages alone would add to it.
TEST(ManyParts, ABodyTakesFewAllocations)
{
  const auto scene = [](int n) { return sceneOf(n, bodies(n, "Steel")); };
  const Cost small = costOf(scene(300)), large = costOf(scene(1300));
  EXPECT_LT(large.allocations - small.allocations, 1000 * 150);
}

TEST(SceneParts, ShowsAnEffectItsSectionAndTheCores)
{
  const SceneResult result =
      readSceneText(sceneOf(3, bodies(3, "Steel") + cracks(2, true)), {}, effectSchema());
  ASSERT_TRUE(result.errors.empty()) << all(result.errors);
  Teuchos::ParameterList& scene = *result.list;
  scene.sublist("Damping").set("Mass Rate", 3.0);
  const Teuchos::ParameterList before(scene);
  const double* const value = &scene.sublist("Time").get<double>("Final Time");
  {
    SceneParts parts(effectSchema(), scene);
    const Teuchos::ParameterList& cracks = parts.of("Cracks");
    EXPECT_TRUE(cracks.sublist("Cracks").isSublist("Part 1"));
    EXPECT_EQ(cracks.sublist("Bodies").numParams(), 3);
    EXPECT_FALSE(cracks.isSublist("Damping"));
    EXPECT_EQ(&cracks.sublist("Time").get<double>("Final Time"), value) << "a copy";
    const Teuchos::ParameterList& damping = parts.of("Damping");
    EXPECT_EQ(damping.sublist("Damping").get<double>("Mass Rate"), 3.0);
    EXPECT_FALSE(damping.isSublist("Cracks"));
    EXPECT_TRUE(scene.isSublist("Cracks"));
  }
  EXPECT_TRUE(Teuchos::haveSameValues(scene, before));
  EXPECT_EQ(&scene.sublist("Time").get<double>("Final Time"), value);
}
