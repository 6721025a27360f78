#include "base/ParticleCopy.hpp"

#include <algorithm>

namespace Rhegma
{

namespace
{

template <class Borrowed>
void copyRows(const Borrowed& column, int components, std::vector<double>& values)
{
  const auto host = onHost(column);
  std::copy(host.data(), host.data() + column.extent(0) * components, values.begin());
}

} // namespace

ParticleCopy copyField(const FieldTable& table, const std::string& name)
{
  const std::vector<Field> fields = table.fields();
  const auto found =
      std::find_if(fields.begin(), fields.end(), [&](const Field& f) { return f.name == name; });
  if (found == fields.end())
  {
    std::string known;
    for (const Field& field : fields)
      known += (known.empty() ? "" : ", ") + field.name;
    throw std::invalid_argument("the particles of this scene have no field \"" + name + "\"; they have " +
                                known);
  }
  ParticleCopy copy{*found, table.size(), std::vector<double>(std::size_t(table.size()) * found->components)};
  if (found->integer)
    copyRows(table.integer(name), 1, copy.values);
  else
    copyRows(table.table(name), found->components, copy.values);
  return copy;
}

} // namespace Rhegma
