#include "output/Snapshot.hpp"

namespace Rhegma
{

Snapshot partOfAll(const Ranks& ranks, Snapshot own)
{
  if (!ranks.many())
    return own;
  for (OutputMesh& mesh : own.meshes)
  {
    // A row per rank: the number of rows of each table there.
    const int tables = static_cast<int>(mesh.data.size());
    std::vector<double> rows(static_cast<std::size_t>(tables) * ranks.size(), 0.0);
    double* const here = rows.data() + static_cast<std::size_t>(tables) * ranks.rank();
    for (int t = 0; t < tables; ++t)
    {
      DataSet& set = mesh.data[t];
      if (mesh.onAllRanks && ranks.rank() > 0)
      {
        set.real.clear();
        set.whole.clear();
      }
      here[t] = static_cast<double>(set.rows());
    }
    ranks.sum(rows.data(), static_cast<int>(rows.size()));
    std::size_t points = 0;
    for (int t = 0; t < tables; ++t)
    {
      DataSet& set = mesh.data[t];
      for (int r = 0; r < ranks.size(); ++r)
      {
        const auto of = static_cast<std::size_t>(rows[static_cast<std::size_t>(tables) * r + t]);
        set.before += r < ranks.rank() ? of : 0;
        set.others += r == ranks.rank() ? 0 : of;
      }
      points = set.role == DataSet::Role::Points ? set.before : points;
    }
    for (DataSet& set : mesh.data)
      if (set.role == DataSet::Role::Cells)
        for (int& point : set.whole)
          point += static_cast<int>(points);
  }
  return own;
}

} // namespace Rhegma
