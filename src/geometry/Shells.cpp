#include "geometry/Shells.hpp"

#include "base/Counted.hpp"
#include "base/Numbers.hpp"
#include "geometry/HalfEdges.hpp"

#include <algorithm>
#include <stdexcept>

namespace Rhegma::Geometry
{

namespace
{

/// Whether a triangle goes from corner a to corner b.
bool goesAlong(const std::array<int, 3>& v, int a, int b)
{
  return (v[0] == a && v[1] == b) || (v[1] == a && v[2] == b) || (v[2] == a && v[0] == b);
}

void findShell(const Simplices<3>& surface, const std::vector<std::array<int, 3>>& neighbours, int first,
               Shells& shells)
{
  std::vector<int> pending{first};
  shells.of[first] = shells.count;
  while (!pending.empty())
  {
    const int t = pending.back();
    pending.pop_back();
    for (int i = 0; i < 3; ++i)
    {
      const int u = neighbours[t][i], a = surface.items[t][(i + 1) % 3], b = surface.items[t][(i + 2) % 3];
      const bool differs = goesAlong(surface.items[u], a, b);
      const char turned = differs ? !shells.turned[t] : shells.turned[t];
      if (shells.of[u] < 0)
      {
        shells.of[u] = shells.count;
        shells.turned[u] = turned;
        pending.push_back(u);
      }
      else if (shells.turned[u] != turned)
        throw std::invalid_argument("the surface at " + placeInFile(surface.points[a]) +
                                    " has only one side, as a Moebius strip; the surface of a solid has two");
    }
  }
}

/// A shell, as its triangles face in the file.
struct Facing
{
  int first = -1; ///< its first triangle
  int triangles = 0;
  int turned = 0;      ///< that are oriented against the first
  int odd = -1;        ///< the first of the smaller number of those that face alike
  double volume = 0.0; ///< if all faced as the first
  double area = 0.0;
  bool flat = false; ///< it has no volume
  int sign() const { return volume > 0.0 ? 1 : -1; }
  bool mostAreTurned() const { return 2 * turned > triangles; }
  /// Whether most of its triangles face outwards.
  bool outwards() const { return (sign() > 0) != mostAreTurned(); }
  int fewer() const { return std::min(turned, triangles - turned); }
};

std::vector<Facing> facingOf(const Simplices<3>& surface, const Shells& shells, double resolution)
{
  std::vector<Facing> found(shells.count);
  for (int t = 0; t < static_cast<int>(surface.items.size()); ++t)
  {
    Facing& shell = found[shells.of[t]];
    if (shell.first < 0)
      shell.first = t;
    const Vector<3> normal = surface.normalOf(t);
    const Vector<3> from = surface.points[surface.items[shell.first][0]];
    ++shell.triangles;
    shell.turned += shells.turned[t];
    shell.volume +=
        (shells.turned[t] ? -1.0 : 1.0) / 6.0 * dot(surface.points[surface.items[t][0]] - from, normal);
    shell.area += 0.5 * norm(normal);
  }
  for (int t = static_cast<int>(surface.items.size()) - 1; t >= 0; --t)
    if (Facing& shell = found[shells.of[t]]; (shells.turned[t] != 0) != shell.mostAreTurned())
      shell.odd = t;
  for (Facing& shell : found)
    shell.flat = !(std::abs(shell.volume) > resolution * shell.area);
  return found;
}

Vector<3> firstPoint(const Simplices<3>& surface, int t) { return surface.points[surface.items[t][0]]; }

void refuseAmbiguous(const Simplices<3>& surface, const std::vector<Facing>& facing,
                     const std::vector<std::vector<int>>& around)
{
  for (std::size_t k = 0; k < facing.size(); ++k)
    for (const int outer : around[k])
      if (!facing[k].flat && around[outer].size() + 1 == around[k].size() &&
          facing[outer].outwards() == facing[k].outwards())
        throw std::invalid_argument(
            "the shell at " + placeInFile(firstPoint(surface, facing[k].first)) +
            " lies inside another shell and has the same orientation: turn its triangles if "
            "it is a cavity, or leave it out if it is material");
}

void addNotes(const Simplices<3>& surface, const std::vector<Facing>& facing,
              const std::vector<std::vector<int>>& around, std::vector<std::string>& notes)
{
  int odd = 0, insideOut = 0, at = -1;
  for (std::size_t k = 0; k < facing.size(); ++k)
  {
    if (facing[k].flat)
      continue;
    odd += facing[k].fewer();
    if (at < 0)
      at = facing[k].fewer() > 0 ? facing[k].odd : -1;
    insideOut += facing[k].outwards() != (around[k].size() % 2 == 0) ? 1 : 0;
  }
  if (odd > 0)
    notes.push_back(counted(odd, "triangle") + (odd == 1 ? ", at " : ", such as that at ") +
                    placeInFile(firstPoint(surface, at)) + (odd == 1 ? ", was" : ", were") +
                    " oriented against the triangles around and turned");
  if (insideOut > 0)
    notes.push_back("the surface is inside out (" + counted(insideOut, "shell") + "); it was turned");
}

/// Removes triangles of shells that are marked.
void removeShells(Simplices<3>& surface, const std::vector<int>& of, const std::vector<char>& gone)
{
  std::size_t kept = 0;
  for (std::size_t t = 0; t < surface.items.size(); ++t)
    if (gone[of[t]] == 0)
      surface.items[kept++] = surface.items[t];
  surface.items.resize(kept);
}

} // namespace

template <int D>
std::string placeInFile(const Vector<D>& x)
{
  std::string text;
  for (int d = 0; d < D; ++d)
    text += (d == 0 ? "(" : ", ") + formatReal(x[d]);
  return text + ")";
}

Shells findShells(const Simplices<3>& surface)
{
  const auto neighbours = HalfEdges(surface.items).neighbours();
  Shells shells{0, std::vector<int>(surface.items.size(), -1), std::vector<char>(surface.items.size(), 0)};
  for (int t = 0; t < static_cast<int>(surface.items.size()); ++t)
    if (shells.of[t] < 0)
    {
      findShell(surface, neighbours, t, shells);
      ++shells.count;
    }
  return shells;
}

template <int D>
std::vector<std::vector<int>> shellsAround(const Simplices<D>& surface, const SimplexTree<D>& tree,
                                           const std::vector<int>& shell, int count)
{
  std::vector<std::vector<int>> around(count);
  std::vector<char> done(count, 0);
  for (std::size_t t = 0; t < surface.items.size() && count > 1; ++t)
  {
    const int own = shell[t];
    if (done[own] != 0)
      continue;
    done[own] = 1;
    std::vector<int> met;
    tree.meetRay(surface.points[surface.items[t][0]], [&](int item, int) { met.push_back(shell[item]); });
    std::sort(met.begin(), met.end());
    for (std::size_t k = 0; k < met.size();)
    {
      const auto end = std::upper_bound(met.begin() + k, met.end(), met[k]);
      const std::size_t times = end - met.begin() - k;
      if (met[k] != own && times % 2 == 1)
        around[own].push_back(met[k]);
      k += times;
    }
  }
  return around;
}

void orientShells(Simplices<3>& surface, const Shells& shells, double resolution,
                  std::vector<std::string>& notes)
{
  const std::vector<Facing> facing = facingOf(surface, shells, resolution);
  std::vector<std::vector<int>> around(shells.count);
  if (shells.count > 1)
    around = shellsAround(surface, SimplexTree<3>(surface), shells.of, shells.count);
  refuseAmbiguous(surface, facing, around);
  addNotes(surface, facing, around, notes);
  std::vector<char> gone(shells.count, 0);
  int flat = 0;
  for (int k = 0; k < shells.count; ++k)
  {
    gone[k] = facing[k].flat ? 1 : 0;
    flat += gone[k];
  }
  for (std::size_t t = 0; t < surface.items.size(); ++t)
  {
    const int k = shells.of[t];
    const bool wanted = around[k].size() % 2 == 0; // outwards
    if ((facing[k].sign() > 0) != wanted ? shells.turned[t] == 0 : shells.turned[t] != 0)
      std::swap(surface.items[t][1], surface.items[t][2]);
  }
  if (flat == 0)
    return;
  removeShells(surface, shells.of, gone);
  if (surface.items.empty())
    throw std::invalid_argument("the surface encloses no volume");
  notes.push_back(counted(flat, "shell") + " without volume " + (flat == 1 ? "was" : "were") + " left out");
}

template std::string placeInFile(const Vector<2>&);
template std::string placeInFile(const Vector<3>&);
template std::vector<std::vector<int>> shellsAround(const Simplices<2>&, const SimplexTree<2>&,
                                                    const std::vector<int>&, int);
template std::vector<std::vector<int>> shellsAround(const Simplices<3>&, const SimplexTree<3>&,
                                                    const std::vector<int>&, int);

} // namespace Rhegma::Geometry
