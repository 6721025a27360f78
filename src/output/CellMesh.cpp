#include "output/CellMesh.hpp"

#include <algorithm>

namespace Rhegma
{

namespace
{

/// The order of corners that VTK and XDMF have.
constexpr int corners[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                               {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};

void sortUnique(std::vector<int>& numbers)
{
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

} // namespace

template <int D>
Mesh cellMesh(const Grid<D>& grid, const std::vector<double>& position)
{
  constexpr int perCell = D == 2 ? 4 : 8;
  std::vector<int> lowest; // node at the lowest corner of each cell
  for (std::size_t p = 0; 3 * p < position.size(); ++p)
  {
    int at[D];
    for (int d = 0; d < D; ++d)
      at[d] = static_cast<int>(grid.inCells(position[3 * p + d], d));
    lowest.push_back(grid.nodeIndex(at));
  }
  sortUnique(lowest);

  std::vector<int> corner; // nodes of one cell after another
  for (const int node : lowest)
    for (int k = 0; k < perCell; ++k)
    {
      int other = node;
      for (int d = 0; d < D; ++d)
        other += corners[k][d] * grid.stride[d];
      corner.push_back(other);
    }
  std::vector<int> nodes = corner;
  sortUnique(nodes);

  DataSet points{"points", DataSet::Role::Points, 3, false, std::vector<double>(3 * nodes.size(), 0.0), {}};
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    const Vector<D> x = grid.nodePosition(nodes[i]);
    for (int d = 0; d < D; ++d)
      points.real[3 * i + d] = x[d];
  }
  DataSet cells{"cells", DataSet::Role::Cells, perCell, true, {}, {}};
  for (const int node : corner)
    cells.whole.push_back(
        static_cast<int>(std::lower_bound(nodes.begin(), nodes.end(), node) - nodes.begin()));

  Mesh mesh{"leaves", D == 2 ? "Quadrilateral" : "Hexahedron", {}};
  mesh.data.push_back(std::move(points));
  mesh.data.push_back(std::move(cells));
  return mesh;
}

template Mesh cellMesh(const Grid<2>&, const std::vector<double>&);
template Mesh cellMesh(const Grid<3>&, const std::vector<double>&);

} // namespace Rhegma
