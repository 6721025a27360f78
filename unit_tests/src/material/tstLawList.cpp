#include "material/MaterialReader.hpp"
#include "material/Materials.hpp"

#include <gtest/gtest.h>

#include <string>
#include <type_traits>

namespace Rhegma
{
namespace
{

/// A law that only reports what it is given.
struct Probe : LawDefaults
{
  static constexpr const char* name = "Probe";
  static constexpr const char* meaning = "For tests.";
  static constexpr bool usesStep = true;
  template <int D>
  static constexpr int historySize = 3;
  template <int D>
  static constexpr int dissipationIndex = 2;
  template <int D>
  KOKKOS_INLINE_FUNCTION static constexpr Mean meanOf(int variable)
  {
    return variable == 0 ? Mean::Largest : variable == 1 ? Mean::Mass : Mean::Volume;
  }
  template <class Reader>
  static void read(const Reader& reader, Properties& m)
  {
    m.own[0] = reader.positive("Number", "number");
  }
  template <int D, Plane P>
  KOKKOS_INLINE_FUNCTION static bool stress(const LawStep& step, const Properties& m, double* F, double* tau,
                                            double* history)
  {
    tau[0] = (F[0] - step.before[0]) * m.own[0];
    tau[1] = step.temperature;
    history[2] += step.dt;
    return true;
  }
};

using WithProbe = LawList<NeoHookean, Probe, J2Plastic>;

struct NameCall
{
  template <class Law, int, Plane>
  std::string run() const
  {
    return Law::name;
  }
};

TEST(LawList, IndexFollowsTheOrder)
{
  EXPECT_EQ(indexIn<NeoHookean>(WithProbe{}), 0);
  EXPECT_EQ(indexIn<Probe>(WithProbe{}), 1);
  EXPECT_EQ(indexIn<J2Plastic>(WithProbe{}), 2);
  EXPECT_EQ(namesOf(WithProbe{}), "Neo-Hookean, Probe or J2 Plastic");
}

TEST(LawList, EachIndexReachesItsLaw)
{
  const char* const names[] = {"Neo-Hookean", "Probe", "J2 Plastic"};
  for (int law = 0; law < WithProbe::size; ++law)
  {
    EXPECT_EQ((withLaw<2, WithProbe>(law, Plane::Strain, NameCall{})), names[law]);
    EXPECT_EQ((withLaw<2, WithProbe>(law, Plane::Stress, NameCall{})), names[law]);
    EXPECT_EQ((withLaw<3, WithProbe>(law, Plane::Solid, NameCall{})), names[law]);
  }
}

TEST(LawList, LawsWithAStepGetIt)
{
  Teuchos::ParameterList list;
  list.set("Model", "Probe");
  list.set("Density", 1.0);
  list.set("Number", 4.0);
  const Properties m = readMaterial<WithProbe>(list, "Test", Plane::Solid);
  ASSERT_EQ(m.law, 1);
  const double before[9] = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  double F[9] = {1.5, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}, tau[6] = {}, history[3] = {};
  EXPECT_TRUE((updateStress<3, WithProbe>({before, 0.25, 310.0}, m, F, tau, history)));
  EXPECT_EQ(tau[0], 2.0);
  EXPECT_EQ(tau[1], 310.0);
  EXPECT_EQ((dissipatedByLaw<Probe, 3>(history)), 0.25);
}

TEST(LawList, AMaterialOfNoLawIsRefused)
{
  Teuchos::ParameterList list;
  list.set("Density", 1.0);
  list.set("Model", "Jelly");
  try
  {
    readMaterial<WithProbe>(list, "Test", Plane::Solid);
    FAIL();
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_STREQ(error.what(),
                 "Materials > Test > Model: is \"Jelly\"; write Neo-Hookean, Probe or J2 Plastic.");
  }
}

TEST(MergedHistory, FollowsTheMeanOfTheVariable)
{
  const double value[2] = {1.0, 4.0}, volume[2] = {0.25, 0.75}, mass[2] = {0.5, 0.5};
  EXPECT_EQ(merged(Probe::meanOf<2>(0), value, volume, mass), 4.0);
  EXPECT_EQ(merged(Probe::meanOf<2>(1), value, volume, mass), 2.5);
  EXPECT_EQ(merged(Probe::meanOf<2>(2), value, volume, mass), 3.25);
}

TEST(MergedHistory, OfMetalIsTheMeanOverVolume)
{
  Properties metal;
  metal.law = lawIndex<J2Plastic>;
  EXPECT_EQ(historySize<2>(metal), 6);
  EXPECT_TRUE(dissipates(metal));
  for (int k = 0; k < historySize<2>(metal); ++k)
    EXPECT_EQ(meanOfHistory<2>(metal, k), Mean::Volume);
  metal.law = lawIndex<LinearElastic>;
  EXPECT_EQ(historySize<3>(metal), 0);
  EXPECT_FALSE(dissipates(metal));
}

} // namespace
} // namespace Rhegma
