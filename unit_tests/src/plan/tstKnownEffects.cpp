/// Effects that an application adds.

#include "plan/EffectSchema.hpp"
#include "plan/KnownEffects.hpp"
#include "scene/Scene.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

using namespace Rhegma;

namespace
{

template <int D>
Effect<D> nothing(const Teuchos::ParameterList&)
{
  return {};
}

EffectEntry named(const std::string& name)
{
  return {Section(name, "Nothing at all."), {}, nothing<2>, nothing<3>};
}

bool knows(const SceneSchema& schema, const std::string& name)
{
  return schema.root().findSection(name) != nullptr;
}

} // namespace

TEST(KnownEffects, AcceptsOneOfTheApplication)
{
  const std::size_t builtIn = builtInEffects().size();
  const SceneSchema& before = effectSchema();
  const std::size_t known = knownEffects().size();
  ASSERT_FALSE(knows(before, "Own Effect"));
  addEffect(named("Own Effect"));
  EXPECT_EQ(knownEffects().size(), known + 1);
  EXPECT_EQ(knownEffects().back().section.name, "Own Effect");
  EXPECT_EQ(builtInEffects().size(), builtIn);
  EXPECT_TRUE(knows(effectSchema(), "Own Effect"));
  EXPECT_TRUE(knows(effectSchema(), builtInEffects().front().section.name));
  // References to the earlier schema stay valid.
  EXPECT_FALSE(knows(before, "Own Effect"));
}

TEST(KnownEffects, RefusesAnExistingNameAndHalfAnEffect)
{
  const std::size_t known = knownEffects().size();
  EXPECT_THROW(addEffect(named("Domain")), std::invalid_argument);
  EXPECT_THROW(addEffect(named(builtInEffects().front().section.name)), std::invalid_argument);
  EffectEntry half = named("Half an Effect");
  half.make3 = {};
  EXPECT_THROW(addEffect(half), std::invalid_argument);
  EXPECT_EQ(knownEffects().size(), known);
}
