#include "material/MaterialTable.hpp"

#include "material/MaterialReader.hpp"

namespace Rhegma
{

Properties makeProperties(const Teuchos::ParameterList& material, const std::string& name, Plane plane)
{
  return readMaterial<Laws>(material, name, plane);
}

} // namespace Rhegma
