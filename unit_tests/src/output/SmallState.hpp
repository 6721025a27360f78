#pragma once
/// A state of a few particles made by hand.

#include "material/Laws.hpp"
#include "state/State.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace Rhegma
{

/// Numbers of one field, one particle after another.
inline void fill(const BorrowedView<double**>& field, const std::vector<double>& values)
{
  const auto host = Kokkos::create_mirror_view(field);
  ASSERT_EQ(values.size(), host.size());
  std::copy(values.begin(), values.end(), host.data());
  Kokkos::deep_copy(field, host);
}

inline void fill(const BorrowedView<int*>& field, const std::vector<int>& values)
{
  const auto host = Kokkos::create_mirror_view(field);
  ASSERT_EQ(values.size(), host.size());
  std::copy(values.begin(), values.end(), host.data());
  Kokkos::deep_copy(field, host);
}

template <class AnyView, class T>
void fillView(const AnyView& view, const std::vector<T>& values)
{
  const auto host = Kokkos::create_mirror_view(view);
  ASSERT_EQ(values.size(), host.size());
  std::copy(values.begin(), values.end(), host.data());
  Kokkos::deep_copy(view, host);
}

/// Moduli of Lame of 3 Pa and 2 Pa.
inline Properties softSolid(int dimension)
{
  Properties m;
  m.law = lawIndex<LinearElastic>;
  m.plane = dimension == 2 ? Plane::Strain : Plane::Solid;
  m.density = 4.0;
  m.lambda = 3.0;
  m.mu = 2.0;
  m.bulk = m.lambda + 2.0 / 3.0 * m.mu;
  m.planeLambda = m.lambda;
  m.thicknessRatio = m.lambda / (m.lambda + 2.0 * m.mu);
  return m;
}

/// Particles at rest and undeformed at the origin of the domain (0,0,0) to (4,4,4) of cells of 1 m, in body 0
/// of two, of softSolid; volume 1/4 m3, mass 1 kg, edge 1/2 m.
template <int D>
State<D> smallState(int particles)
{
  State<D> state;
  state.method.plane = D == 2 ? Plane::Strain : Plane::Solid;
  Vector<D> lower{};
  Vector<D> upper{};
  for (int d = 0; d < D; ++d)
    upper[d] = 4.0;
  state.mesh.grid = makeGrid<D>(lower, upper, 1.0);
  FieldTable& table = state.particles;
  table.add({fields::position, D, "m", ""});
  table.add({fields::reference, D, "m", ""});
  table.add({fields::velocity, D, "m/s", ""});
  table.add({fields::mass, 1, "kg", ""});
  table.add({fields::volume, 1, "m3", ""});
  table.add({fields::deformation, gradientSize<D>, "", ""});
  table.add({fields::stress, symmetricSize<D>, "Pa", ""});
  table.add({fields::edge, D, "m", ""});
  table.add({fields::material, 1, "", "", true});
  table.add({fields::body, 1, "", "", true});
  table.add({fields::id, 1, "", "", true});
  table.resize(particles);
  std::vector<double> identity;
  for (int p = 0; p < particles; ++p)
    for (int i = 0; i < gradientSize<D>; ++i)
      identity.push_back(D == 2 ? (i == 0 || i >= 3 ? 1.0 : 0.0) : (i % 4 == 0 ? 1.0 : 0.0));
  fill(table.table(fields::deformation), identity);
  fill(table.table(fields::mass), std::vector<double>(particles, 1.0));
  fill(table.table(fields::volume), std::vector<double>(particles, 0.25));
  fill(table.table(fields::edge), std::vector<double>(particles * D, 0.5));
  for (const char* name : {"First", "Second"})
  {
    BodyInfo<D> body;
    body.name = name;
    for (int e = 0; e < D; ++e)
      for (int d = 0; d < D; ++d)
        body.axes[e][d] = e == d ? 1.0 : 0.0;
    state.bodies.info.push_back(body);
  }
  state.materials.names = {"Soft"};
  state.materials.properties = {softSolid(D)};
  state.materials.device = View<Properties*>("materials", 1);
  const auto host = Kokkos::create_mirror_view(state.materials.device);
  host(0) = state.materials.properties[0];
  Kokkos::deep_copy(state.materials.device, host);
  return state;
}

/// A folder that is removed at the end of the test.
class Folder
{
public:
  Folder()
  {
    std::string pattern = (std::filesystem::temp_directory_path() / "rhegma-test-XXXXXX").string();
    path_ = mkdtemp(pattern.data());
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string path(const std::string& name) const { return path_ + "/" + name; }
  const std::string& path() const { return path_; }

private:
  std::string path_;
};

inline std::string contents(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

} // namespace Rhegma
