#pragma once
/// Parameters of the law Ogden: their description in a scene, and their reading.

#include "material/LawParameters.hpp"

#include <vector>

namespace Rhegma
{

/// Indices in Properties::own of the law Ogden.
namespace OgdenNumber
{
constexpr int terms = 6; ///< at most
enum
{
  modulus = 0,                ///< of each term [Pa]
  exponent = modulus + terms, ///< of each term [-]
  count = exponent + terms,   ///< of terms
  size
};
static_assert(size <= lawNumbers);
} // namespace OgdenNumber

template <class Section>
void describeOgden(Section& s)
{
  describeDensity(s);
  s.realArray("Moduli").unit("Pa").meaning(
      "mu_p of each term of the stored energy sum mu_p / alpha_p (l1^alpha_p + l2^alpha_p + l3^alpha_p - 3), "
      "l "
      "the isochoric principal stretches; 1 to 6 terms. The shear modulus at small strain is half the sum of "
      "mu_p alpha_p.");
  s.realArray("Exponents").meaning("alpha_p of each term, of the sign of its modulus.");
  s.real("Bulk Modulus")
      .orTable()
      .unit("Pa")
      .positive()
      .meaning("Bulk modulus K; the energy of the volume is K/2 (J - 1)^2.");
  describeEntropic(s);
}

namespace detail
{

/// Refuses a term whose stress does not rise with stretch. \param p counts from 0
template <class Reader>
void checkOgdenTerm(const Reader& reader, int p, double modulus, double exponent)
{
  const std::string term = "term " + std::to_string(p + 1);
  if (exponent == 0.0)
    reader.refuse("Exponents", "has 0 in " + term + ", which stores no energy; remove the term.");
  if (!(modulus * exponent > 0.0))
    reader.refuse("Moduli", "has " + Reader::text(modulus) + " Pa in " + term + ", with the exponent " +
                                Reader::text(exponent) + ": mu_p alpha_p > 0 fails, " +
                                Reader::text(modulus * exponent) +
                                " <= 0, and its stress would fall with strain; give a modulus of the "
                                "sign of the exponent.");
}

} // namespace detail

template <class Reader>
void readOgden(const Reader& reader, Properties& m)
{
  const std::vector<double> moduli = reader.numbers("Moduli"), exponents = reader.numbers("Exponents");
  constexpr std::size_t most = OgdenNumber::terms;
  if (moduli.empty() || moduli.size() > most)
    reader.refuse("Moduli", "has " + std::to_string(moduli.size()) + " numbers; give the moduli of 1 to " +
                                std::to_string(most) + " terms [Pa].");
  if (exponents.size() != moduli.size())
    reader.refuse("Exponents", "has " + std::to_string(exponents.size()) + " numbers, but Moduli has " +
                                   std::to_string(moduli.size()) + "; give one exponent for each modulus.");
  for (std::size_t p = 0; p < moduli.size(); ++p)
  {
    detail::checkOgdenTerm(reader, static_cast<int>(p), moduli[p], exponents[p]);
    m.own[OgdenNumber::modulus + p] = moduli[p];
    m.own[OgdenNumber::exponent + p] = exponents[p];
    m.mu += 0.5 * moduli[p] * exponents[p];
  }
  m.own[OgdenNumber::count] = static_cast<double>(moduli.size());
  m.bulk = reader.positive("Bulk Modulus", "bulk modulus [Pa]");
  m.lambda = m.bulk - 2.0 / 3.0 * m.mu;
  if (m.lambda < 0.0)
    reader.refuse("Bulk Modulus", "is " + Reader::text(m.bulk) +
                                      " Pa; this law is for nearly incompressible material, and K >= 2/3 mu "
                                      "fails with the shear modulus mu = 1/2 sum mu_p alpha_p = " +
                                      Reader::text(m.mu) + " Pa; give at least " +
                                      Reader::text(2.0 / 3.0 * m.mu) + ".");
}

} // namespace Rhegma
