#include "surface/FrontPieces.hpp"

#include <algorithm>

namespace Rhegma::surface
{

std::vector<std::vector<Piece>> frontsOf(const CrackMesh<2>& mesh)
{
  std::vector<std::vector<Piece>> fronts;
  if (mesh.beyond.front()[1] == facet::front)
    fronts.push_back({{0, 1}});
  if (mesh.beyond.back()[0] == facet::front)
    fronts.push_back({{static_cast<int>(mesh.simplices.size()) - 1, 0}});
  return fronts;
}

/// A chain that does not close begins where no other piece ends.
std::vector<std::vector<Piece>> frontsOf(const CrackMesh<3>& mesh)
{
  const auto begin = [&](const Piece& p) { return mesh.simplices[p.simplex][(p.facet + 1) % 3]; };
  const auto end = [&](const Piece& p) { return mesh.simplices[p.simplex][(p.facet + 2) % 3]; };
  std::vector<Piece> rest;
  for (std::size_t s = 0; s < mesh.simplices.size(); ++s)
    for (int i = 0; i < 3; ++i)
      if (mesh.beyond[s][i] == facet::front)
        rest.push_back({static_cast<int>(s), i});
  std::vector<std::vector<Piece>> fronts;
  while (!rest.empty())
  {
    auto first = std::find_if(rest.begin(), rest.end(),
                              [&](const Piece& p) {
                                return std::none_of(rest.begin(), rest.end(),
                                                    [&](const Piece& q) { return end(q) == begin(p); });
                              });
    if (first == rest.end())
      first = rest.begin();
    std::vector<Piece> chain;
    for (auto next = first; next != rest.end();)
    {
      chain.push_back(*next);
      rest.erase(next);
      next = std::find_if(rest.begin(), rest.end(),
                          [&](const Piece& p) { return begin(p) == end(chain.back()); });
    }
    fronts.push_back(chain);
  }
  return fronts;
}

int middleVertex(const CrackMesh<2>& mesh, const std::vector<Piece>& pieces)
{
  return mesh.simplices[pieces[0].simplex][1 - pieces[0].facet];
}

int middleVertex(const CrackMesh<3>& mesh, const std::vector<Piece>& pieces)
{
  const Piece& middle = pieces[pieces.size() / 2];
  return mesh.simplices[middle.simplex][(middle.facet + 1) % 3];
}

} // namespace Rhegma::surface
