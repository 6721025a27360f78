#include "archive/Archive.hpp"
#include "cracks/SurfaceGrowth.hpp"

#include <algorithm>

namespace Rhegma::cracks
{

using namespace surface;

std::vector<double> SurfaceGrowth::toughnessAlong(const CrackSet<3>& set, int front) const
{
  const std::vector<FrontStation<3>>& stations = set.fronts[front].stations;
  const std::size_t f = front;
  const double last = f < lastToughness_.size() ? lastToughness_[f] : 0.0;
  std::vector<double> along(std::max<std::size_t>(1, stations.size()), last);
  if (f >= marks_.size())
    return along;
  const std::vector<Mark>& marks = marks_[f];
  for (std::size_t k = 0; k < marks.size(); ++k)
  {
    if (marks[k].toughness > 0.0)
    {
      along[k] = marks[k].toughness;
      continue;
    }
    double shortest = 1e300;
    for (std::size_t other = 0; other < marks.size(); ++other)
    {
      const double distance = norm(stations[other].position - stations[k].position);
      if (marks[other].toughness > 0.0 && distance < shortest)
      {
        shortest = distance;
        along[k] = marks[other].toughness;
      }
    }
  }
  return along;
}

void SurfaceGrowth::keep(State<3>& state, Archive& archive)
{
  CrackSet<3>& set = state.cracks;
  std::vector<int> sizes, triangles, stations, counts;
  std::vector<double> vertices, numbers;
  if (!archive.loads())
  {
    for (const Crack& crack : read(set))
    {
      sizes.insert(sizes.end(), {static_cast<int>(crack.surface.vertices.size()),
                                 static_cast<int>(crack.surface.triangles.size())});
      for (const auto& t : crack.surface.triangles)
        triangles.insert(triangles.end(), t.begin(), t.end());
      for (const Vector<3>& x : crack.surface.vertices)
        vertices.insert(vertices.end(), x.c, x.c + 3);
    }
    for (std::size_t f = 0; f < set.fronts.size(); ++f)
    {
      const CrackFront<3>& front = set.fronts[f];
      counts.push_back(static_cast<int>(front.stations.size()));
      for (std::size_t k = 0; k < front.stations.size(); ++k)
      {
        const FrontStation<3>& s = front.stations[k];
        stations.insert(stations.end(),
                        {s.vertex - set.cracks[front.crack].firstVertex, s.facet >= 0 ? 1 : 0, s.name, s.from,
                         s.halted ? 1 : 0, s.advances ? 1 : 0, marks_[f][k].landed ? 1 : 0});
        numbers.insert(numbers.end(),
                       {s.speed, s.temperature, s.driving.release, s.driving.modeI, s.driving.modeII,
                        s.driving.modeIII, s.driving.hoopAngle, marks_[f][k].toughness});
      }
    }
  }
  constexpr std::size_t whole = 7, real = 8; // numbers of a station
  archive("sizes", sizes, 2);
  archive("triangles", triangles, 3);
  archive("places", vertices, 3);
  archive("counts", counts);
  archive("stations", stations, whole);
  archive("station_numbers", numbers, real);
  archive("last_toughness", lastToughness_);
  if (!archive.loads())
    return;
  std::vector<Crack> cracks(set.cracks.size());
  std::size_t vertex = 0, corner = 0;
  for (std::size_t c = 0; c < cracks.size() && 2 * c + 1 < sizes.size(); ++c)
  {
    GrowingSurface& surface = cracks[c].surface;
    for (int v = 0; v < sizes[2 * c]; ++v, vertex += 3)
      surface.vertices.push_back({vertices.at(vertex), vertices.at(vertex + 1), vertices.at(vertex + 2)});
    for (const Vector<3>& x : surface.vertices)
      surface.faces.push_back({x, x}); // loaded next
    for (int t = 0; t < sizes[2 * c + 1]; ++t, corner += 3)
      surface.triangles.push_back({triangles.at(corner), triangles.at(corner + 1), triangles.at(corner + 2)});
    surface.prepare();
  }
  marks_.assign(set.fronts.size(), {});
  lastToughness_.resize(set.fronts.size(), 0.0);
  told_.resize(set.fronts.size(), false);
  toldHalted_.resize(set.fronts.size(), false);
  std::size_t row = 0;
  for (std::size_t f = 0; f < set.fronts.size(); ++f)
  {
    FrontLines<3> lines;
    set.fronts[f].stations.clear();
    for (int k = 0; k < counts.at(f); ++k, ++row)
    {
      const int* of = &stations.at(whole * row);
      const double* value = &numbers.at(real * row);
      FrontPoint<3> point;
      FrontStation<3> station;
      point.origin = k;
      point.vertex = of[0];
      point.joined = of[1] != 0;
      point.name = of[2];
      point.from = of[3];
      point.stopped = station.halted = of[4] != 0;
      station.advances = of[5] != 0;
      point.landed = of[6] != 0;
      station.speed = value[0];
      station.temperature = value[1];
      station.driving = {value[2], value[3], value[4], value[5], value[6]};
      point.toughness = value[7];
      told_[f] = told_[f] || point.landed;
      toldHalted_[f] = toldHalted_[f] || (point.stopped && !point.landed);
      lines.push_back(point);
      set.fronts[f].stations.push_back(station);
    }
    cracks[set.fronts[f].crack].fronts.push_back(lines);
    cracks[set.fronts[f].crack].numbers.push_back(static_cast<int>(f));
  }
  write(set, cracks, state.mesh.grid.spacing);
}

} // namespace Rhegma::cracks
