#include "material/MaterialTable.hpp"

#include "material/MaterialReader.hpp"
#include "material/Materials.hpp"

namespace Rhegma
{

namespace
{

struct RefusesHeat
{
  const Properties& properties;
  template <class Law, int, Plane>
  const char* run() const
  {
    return Law::refusesHeat(properties);
  }
};

struct FirstYield
{
  const Properties& properties;
  template <class Law, int, Plane>
  double run() const
  {
    return Law::firstYield(properties);
  }
};

template <class... Law>
bool anyWarms(const std::string& model, LawList<Law...> /*list*/)
{
  return ((Law::warms && model == Law::name) || ...);
}

template <class... Law>
std::vector<std::string> damagingLaws(LawList<Law...> /*list*/)
{
  std::vector<std::string> names;
  const auto add = [&](bool damages, const char* name)
  {
    if (damages)
      names.emplace_back(name);
  };
  (add(Law::damages, Law::name), ...);
  return names;
}

} // namespace

Properties makeProperties(const Teuchos::ParameterList& material, const std::string& name, Plane plane)
{
  return readMaterial<Laws>(material, name, plane);
}

bool warmsWithoutHeat(const std::string& model) { return anyWarms(model, Laws{}); }

const std::vector<std::string>& lawsWithDamage()
{
  static const std::vector<std::string> names = damagingLaws(Laws{});
  return names;
}

const char* refusesHeat(const Properties& properties)
{
  return withLaw<3>(properties.law, Plane::Solid, RefusesHeat{properties});
}

double firstYield(const Properties& properties)
{
  return withLaw<3>(properties.law, Plane::Solid, FirstYield{properties});
}

} // namespace Rhegma
