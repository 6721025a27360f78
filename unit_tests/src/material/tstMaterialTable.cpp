/// From a scene's list to numbers, and a kernel that uses them.

#include "Cases.hpp"

namespace Rhegma
{
namespace Test
{

Teuchos::ParameterList steel()
{
  Teuchos::ParameterList list;
  list.set("Model", "J2 Plastic");
  list.set("Density", 7800.0);
  list.set("Young Modulus", 210.0e9);
  list.set("Poisson Ratio", 0.3);
  list.set("Yield Stress", 250.0e6);
  return list;
}

/// The message with which a list is refused; empty if it is accepted.
std::string refusal(const Teuchos::ParameterList& list, Plane plane = Plane::Solid)
{
  try
  {
    makeProperties(list, "Steel", plane);
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "";
}

TEST(MaterialTable, Moduli)
{
  const Elasticity e = elasticity(makeProperties(steel(), "Steel", Plane::Strain));
  EXPECT_NEAR(e.young, 210.0e9, 1.0e-3);
  EXPECT_NEAR(e.poisson, 0.3, 1.0e-15);
  EXPECT_NEAR(e.shear, 210.0e9 / 2.6, 1.0e-3);
  EXPECT_NEAR(e.lambda, 210.0e9 * 0.3 / (1.3 * 0.4), 1.0e-3);
  EXPECT_NEAR(e.effectiveModulus, 210.0e9 / 0.91, 1.0e-3);
  EXPECT_NEAR(e.constrainedModulus, 210.0e9 * 0.7 / (1.3 * 0.4), 1.0e-3);
}

TEST(MaterialTable, ModuliOfPlaneStress)
{
  const Elasticity e = elasticity(makeProperties(steel(), "Steel", Plane::Stress));
  EXPECT_NEAR(e.effectiveModulus, 210.0e9, 1.0e-3);
  EXPECT_NEAR(e.constrainedModulus, 210.0e9 / 0.91, 1.0e-3);
}

TEST(MaterialTable, ModuliOfRubber)
{
  const Elasticity e = elasticity(mooneyRivlin(Plane::Solid, 0.4e6, 0.1e6, 1.0e9));
  EXPECT_NEAR(e.shear, 1.0e6, 1.0e-9);
  EXPECT_NEAR(e.young, 9.0e15 / 3.001e9, 1.0e-6);
  EXPECT_NEAR(e.poisson, (3.0e9 - 2.0e6) / (6.0e9 + 2.0e6), 1.0e-15);
}

TEST(MaterialTable, HistoryOnlyWhereALawNeedsIt)
{
  EXPECT_EQ(LinearElastic::historySize<3>, 0);
  EXPECT_EQ(NeoHookean::historySize<2>, 0);
  EXPECT_EQ(MooneyRivlin::historySize<2>, 0);
  EXPECT_EQ(J2Plastic::historySize<2>, 6);
  EXPECT_EQ(J2Plastic::historySize<3>, 8);
}

TEST(MaterialTable, HardeningIsOptional)
{
  const Properties m = makeProperties(steel(), "Steel", Plane::Solid);
  EXPECT_EQ(m.own[J2Number::hardening], 0.0);
  EXPECT_EQ(m.own[J2Number::saturation], 0.0);
  EXPECT_EQ(yieldStress(m, 3.0), 250.0e6);
}

TEST(MaterialTable, RefusalsSayWhereAndWhat)
{
  struct Wrong
  {
    std::string parameter;
    double value;
    std::string says;
  };
  for (const Wrong& wrong :
       {Wrong{"Density", 0.0, "positive"}, Wrong{"Density", -1.0, "positive"},
        Wrong{"Young Modulus", -2.0, "positive"}, Wrong{"Poisson Ratio", 0.5, "below 0.5"},
        Wrong{"Poisson Ratio", -1.0, "above -1"}, Wrong{"Yield Stress", 0.0, "positive"},
        Wrong{"Hardening Modulus", -1.0, "zero or more"}, Wrong{"Density", std::nan(""), "finite"}})
  {
    Teuchos::ParameterList list = steel();
    list.set(wrong.parameter, wrong.value);
    const std::string message = refusal(list);
    EXPECT_EQ(message.find("Materials > Steel > " + wrong.parameter + ": "), 0u) << message;
    EXPECT_NE(message.find(wrong.says), std::string::npos) << message;
  }
}

TEST(MaterialTable, RefusesWhatIsMissing)
{
  Teuchos::ParameterList list = steel();
  list.remove("Poisson Ratio");
  EXPECT_NE(refusal(list).find("Materials > Steel > Poisson Ratio: a J2 Plastic material needs it"),
            std::string::npos);
  list = steel();
  list.set("Saturation Stress", 300.0e6);
  EXPECT_NE(refusal(list).find("Saturation Rate: is missing"), std::string::npos);
  list.set("Saturation Rate", 10.0);
  EXPECT_EQ(refusal(list), "");
  list.set("Saturation Stress", 200.0e6);
  EXPECT_NE(refusal(list).find("below the yield stress"), std::string::npos);
  EXPECT_NE(refusal(Teuchos::ParameterList()).find("Materials > Steel > Model: is missing"),
            std::string::npos);
}

TEST(MaterialTable, RefusesWrongModels)
{
  Teuchos::ParameterList list = steel();
  list.set("Model", "Jelly");
  EXPECT_NE(refusal(list).find("is \"Jelly\"; write Linear Elastic"), std::string::npos);
  list.set("Model", "Neo-Hookean");
  list.set("Poisson Ratio", -0.1);
  EXPECT_NE(refusal(list).find("from 0"), std::string::npos);
  list.set("Poisson Ratio", 0.0);
  EXPECT_EQ(refusal(list), "");
  list.set("Model", "Mooney-Rivlin");
  list.set("C10", 0.0);
  list.set("C01", 0.0);
  list.set("Bulk Modulus", 1.0e9);
  EXPECT_NE(refusal(list).find("is a fluid"), std::string::npos);
  list.set("C10", 1.0e9);
  EXPECT_NE(refusal(list).find("nearly incompressible"), std::string::npos);
}

/// A kernel over particles of four materials gives each the stress of its own law.
template <int D>
void stressKernel(const View<Properties*>& materials, const View<double * [gradientSize<D>]>& F,
                  const View<double * [symmetricSize<D>]>& tau, const View<double**>& history,
                  const View<double*>& speed)
{
  Kokkos::parallel_for(
      "rhegma::test::stress", Kokkos::RangePolicy<ExecSpace>(0, F.extent(0)), KOKKOS_LAMBDA(const int p) {
        updateStress<D>(materials(p), &F(p, 0), &tau(p, 0), &history(p, 0));
        speed(p) = waveSpeed<D>(materials(p), &F(p, 0), &history(p, 0)) +
                   storedEnergy<D>(materials(p), &F(p, 0), &history(p, 0)) +
                   dissipatedEnergy<D>(materials(p), &history(p, 0));
      });
}

template <class C>
void checkParticle(const Properties& m, int p, const View<double * [symmetricSize<C::D>]>& tau,
                   const View<double*>& speed, Gradient<C::D> F)
{
  constexpr int D = C::D;
  History<D> history{};
  const Symmetric<D> expected = stressOf<C>(m, F, history);
  const auto stress = onHost(tau);
  const auto number = onHost(speed);
  for (int i = 0; i < symmetricSize<D>; ++i)
    EXPECT_NEAR(stress(p, i), expected[i], 1.0e-13);
  EXPECT_NEAR(number(p),
              (C::Law::template waveSpeed<D, C::P>(m, F.data(), history.data()) +
               C::Law::template energy<D, C::P>(m, F.data(), history.data()) +
               dissipatedEnergy<D>(m, history.data())),
              1.0e-12);
}

template <int D, Plane P>
void checkKernel()
{
  const std::array<Properties, 4> list = {
      Case<LinearElastic, D, P>::material(), Case<NeoHookean, D, P>::material(),
      Case<MooneyRivlin, D, P>::material(), plastic(P, 2.6, 0.3, 0.02, 0.05)};
  const View<Properties*> materials("materials", 4);
  const View<double * [gradientSize<D>]> F("F", 4);
  const View<double * [symmetricSize<D>]> tau("tau", 4);
  const View<double**> history("history", 4, J2Plastic::historySize<D>);
  const View<double*> speed("speed", 4);
  const auto hostMaterials = Kokkos::create_mirror_view(materials);
  const auto hostF = Kokkos::create_mirror_view(F);
  const Gradient<D> deformation = Random().deformation<D>(0.9, 1.2);
  for (int p = 0; p < 4; ++p)
  {
    hostMaterials(p) = list[p];
    for (int i = 0; i < gradientSize<D>; ++i)
      hostF(p, i) = deformation[i];
  }
  Kokkos::deep_copy(materials, hostMaterials);
  Kokkos::deep_copy(F, hostF);
  stressKernel<D>(materials, F, tau, history, speed);
  checkParticle<Case<LinearElastic, D, P>>(list[0], 0, tau, speed, deformation);
  checkParticle<Case<NeoHookean, D, P>>(list[1], 1, tau, speed, deformation);
  checkParticle<Case<MooneyRivlin, D, P>>(list[2], 2, tau, speed, deformation);
  checkParticle<Case<J2Plastic, D, P>>(list[3], 3, tau, speed, deformation);
}

TEST(MaterialKernel, PlaneStrain) { checkKernel<2, Plane::Strain>(); }
TEST(MaterialKernel, PlaneStress) { checkKernel<2, Plane::Stress>(); }
TEST(MaterialKernel, Solid) { checkKernel<3, Plane::Solid>(); }

} // namespace Test
} // namespace Rhegma
