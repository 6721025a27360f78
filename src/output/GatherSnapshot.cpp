#include "output/Snapshot.hpp"

namespace Rhegma
{

namespace
{

/// Points of ranks before this one.
int pointsBefore(const Ranks& ranks, const Mesh& mesh)
{
  std::vector<double> points(ranks.size(), 0.0);
  for (const DataSet& set : mesh.data)
    if (set.role == DataSet::Role::Points)
      points[ranks.rank()] = static_cast<double>(set.rows());
  ranks.sum(points.data(), ranks.size());
  double before = 0.0;
  for (int r = 0; r < ranks.rank(); ++r)
    before += points[r];
  return static_cast<int>(before);
}

} // namespace

Snapshot gatherSnapshot(const Ranks& ranks, Snapshot own)
{
  if (!ranks.many())
    return own;
  for (Mesh& mesh : own.meshes)
  {
    if (mesh.onAllRanks)
      continue;
    const int before = pointsBefore(ranks, mesh);
    for (DataSet& set : mesh.data)
    {
      if (set.role == DataSet::Role::Cells)
        for (int& point : set.whole)
          point += before;
      set.real = ranks.gather(set.real);
      set.whole = ranks.gather(set.whole);
    }
  }
  return own;
}

} // namespace Rhegma
