#include "state/Migration.hpp"

#include "state/Subdomain.hpp"

#include <Tpetra_Distributor.hpp>

#include <algorithm>

namespace Rhegma
{

namespace
{

/// Numbers of a particle: all components of all fields.
int rowWidth(const FieldTable& particles)
{
  int width = 0;
  for (const Field& field : particles.fields())
    width += field.components;
  return width;
}

/// Copies particles `which(0) ..` to rows, field after field; whole numbers are exact in a double.
void pack(const FieldTable& particles, const View<int*>& which, const View<double*>& rows)
{
  const int width = rowWidth(particles), count = static_cast<int>(which.extent(0));
  int at = 0;
  for (const Field& field : particles.fields())
  {
    const int first = at, components = field.components;
    const auto range = Kokkos::RangePolicy<ExecSpace>(0, count);
    if (field.integer)
    {
      const auto values = particles.integer(field.name);
      Kokkos::parallel_for(
          "rhegma::parallel::packWhole", range,
          KOKKOS_LAMBDA(const int i) { rows(i * width + first) = values(which(i)); });
    }
    else
    {
      const auto values = particles.table(field.name);
      Kokkos::parallel_for(
          "rhegma::parallel::packReal", range, KOKKOS_LAMBDA(const int i) {
            for (int c = 0; c < components; ++c)
              rows(i * width + first + c) = values(which(i), c);
          });
    }
    at += components;
  }
}

/// Copies rows to particles begin, begin + 1, ...
void unpack(const FieldTable& particles, int begin, const View<double*>& rows)
{
  const int width = rowWidth(particles), count = static_cast<int>(rows.extent(0)) / width;
  int at = 0;
  for (const Field& field : particles.fields())
  {
    const int first = at, components = field.components;
    const auto range = Kokkos::RangePolicy<ExecSpace>(0, count);
    if (field.integer)
    {
      const auto values = particles.integer(field.name);
      Kokkos::parallel_for(
          "rhegma::parallel::unpackWhole", range,
          KOKKOS_LAMBDA(const int i) { values(begin + i) = static_cast<int>(rows(i * width + first)); });
    }
    else
    {
      const auto values = particles.table(field.name);
      Kokkos::parallel_for(
          "rhegma::parallel::unpackReal", range, KOKKOS_LAMBDA(const int i) {
            for (int c = 0; c < components; ++c)
              values(begin + i, c) = rows(i * width + first + c);
          });
    }
    at += components;
  }
}

View<int*> toDevice(const std::vector<int>& list)
{
  View<int*> view("rhegma::parallel::list", list.size());
  const auto host = Kokkos::create_mirror_view(view);
  std::copy(list.begin(), list.end(), host.data());
  Kokkos::deep_copy(view, host);
  return view;
}

} // namespace

template <int D>
std::vector<int> ownersOf(const State<D>& state, const Division<D>& division)
{
  const auto position = onHost(state.particles.template real<D>(fields::position));
  std::vector<int> owner(state.particles.size());
  for (std::size_t p = 0; p < owner.size(); ++p)
  {
    Vector<D> x;
    for (int d = 0; d < D; ++d)
      x[d] = position(p, d);
    int cell[D];
    division.cellAt(x, cell);
    owner[p] = division.ownerOf(cell);
  }
  return owner;
}

template <int D>
void keepParticles(State<D>& state, const std::vector<int>& stay)
{
  state.particles.reorder(toDevice(stay));
}

template <int D>
void sendParticles(State<D>& state, const std::vector<int>& owner)
{
  std::vector<int> stay, leave;
  for (std::size_t p = 0; p < owner.size(); ++p)
    (owner[p] == state.ranks.rank() ? stay : leave).push_back(static_cast<int>(p));
  std::stable_sort(leave.begin(), leave.end(), [&](int a, int b) { return owner[a] < owner[b]; });
  std::vector<int> to;
  to.reserve(leave.size());
  for (const int p : leave)
    to.push_back(owner[p]);

  const std::size_t width = rowWidth(state.particles);
  const View<double*> leaving("rhegma::parallel::leaving", leave.size() * width);
  pack(state.particles, toDevice(leave), leaving);
  keepParticles(state, stay);
  Tpetra::Distributor distributor(state.ranks.comm());
  const std::size_t arrivals = distributor.createFromSends(Teuchos::arrayViewFromVector(to));
  const View<double*> arriving("rhegma::parallel::arriving", arrivals * width);
  const View<const double*> sent = leaving;
  distributor.doPostsAndWaits(sent, width, arriving);
  state.particles.resize(static_cast<int>(stay.size() + arrivals));
  unpack(state.particles, static_cast<int>(stay.size()), arriving);
}

template <int D>
void migrateParticles(State<D>& state)
{
  if (state.mesh.subdomain)
    sendParticles(state, ownersOf(state, state.mesh.subdomain->division));
}

template std::vector<int> ownersOf(const State<2>&, const Division<2>&);
template std::vector<int> ownersOf(const State<3>&, const Division<3>&);
template void keepParticles(State<2>&, const std::vector<int>&);
template void keepParticles(State<3>&, const std::vector<int>&);
template void sendParticles(State<2>&, const std::vector<int>&);
template void sendParticles(State<3>&, const std::vector<int>&);
template void migrateParticles(State<2>&);
template void migrateParticles(State<3>&);

} // namespace Rhegma
