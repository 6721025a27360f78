#include "parallel/NeighbourSums.hpp"

#include <Teuchos_DefaultMpiComm.hpp>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace Rhegma
{

namespace
{

constexpr int tag = 7310;

using Range = Kokkos::RangePolicy<ExecSpace>;

void fit(View<double*>& view, const std::string& label, std::size_t size)
{
  if (view.extent(0) < size)
    view = View<double*>(label, size);
}

} // namespace

NeighbourSums::NeighbourSums(const Ranks& ranks, const View<int*>& nodes,
                             const std::vector<std::vector<int>>& of)
    : ranks_(ranks), nodes_(nodes)
{
  std::vector<int> entries;
  for (int r = 0; r < ranks.size(); ++r)
  {
    if (of[r].empty())
      continue;
    const int begin = static_cast<int>(entries.size());
    entries.insert(entries.end(), of[r].begin(), of[r].end());
    neighbours_.push_back({r, begin, static_cast<int>(entries.size()), 0});
  }
  entry_ = View<int*>("rhegma::parallel::entries", entries.size());
  place_ = View<int*>("rhegma::parallel::places", entries.size() + 1);
  const auto host = Kokkos::create_mirror_view(entry_);
  std::copy(entries.begin(), entries.end(), host.data());
  Kokkos::deep_copy(entry_, host);
}

void NeighbourSums::sum(const SharedRows& rows, double* values, int width, int first, int count)
{
  const int fields = rows.second.extent(0) > 0 ? 2 : 1;
  const Columns columns{values, width, first, count, fields};
  const std::size_t most = entry_.extent(0) * fields * count, own = nodes_.extent(0) * fields * count;
  fit(sent_, "rhegma::parallel::sent", most);
  fit(received_, "rhegma::parallel::received", most);
  fit(total_, "rhegma::parallel::total", own);
  findPlaces(rows, fields);
  for (const Neighbour& to : neighbours_)
    pack(rows, columns, to);
  exchange(columns);
  const View<double*> total = total_;
  Kokkos::parallel_for(
      "rhegma::parallel::clear", Range(0, own), KOKKOS_LAMBDA(const int i) { total(i) = 0.0; });
  std::size_t k = 0;
  for (; k < neighbours_.size() && neighbours_[k].rank < ranks_.rank(); ++k)
    add(rows, columns, neighbours_[k]);
  addOwn(rows, columns);
  for (; k < neighbours_.size(); ++k)
    add(rows, columns, neighbours_[k]);
  const View<int*> nodes = nodes_;
  const SharedRows at = rows;
  Kokkos::parallel_for(
      "rhegma::parallel::unpack", Range(0, nodes.extent(0)), KOKKOS_LAMBDA(const int i) {
        for (int f = 0; f < fields; ++f)
        {
          const int row = at(nodes(i), f);
          for (int c = 0; row >= 0 && c < count; ++c)
            values[static_cast<std::size_t>(row) * width + first + c] = total((i * fields + f) * count + c);
        }
      });
}

void NeighbourSums::findPlaces(const SharedRows& rows, int fields)
{
  const View<int*> nodes = nodes_, entry = entry_, place = place_;
  const SharedRows at = rows;
  const int entries = static_cast<int>(entry.extent(0));
  // Rows of the nodes' own numbers are all sent: only of others do ranks know that all have the same.
  const bool all = rows.rowOf.extent(0) == 0;
  Kokkos::parallel_scan(
      "rhegma::parallel::places", Range(0, entries + 1),
      KOKKOS_LAMBDA(const int e, int& before, const bool final) {
        if (final)
          place(e) = before;
        for (int f = 0; e < entries && f < fields; ++f)
          before += all || at(nodes(entry(e)), f) >= 0 ? 1 : 0;
      });
  const auto host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, place_);
  for (Neighbour& neighbour : neighbours_)
    neighbour.filled = host(neighbour.end) - host(neighbour.begin);
}

void NeighbourSums::pack(const SharedRows& rows, const Columns& columns, const Neighbour& to)
{
  const View<int*> nodes = nodes_, entry = entry_, place = place_;
  const View<double*> sent = sent_;
  const SharedRows at = rows;
  const Columns of = columns;
  const bool all = rows.rowOf.extent(0) == 0;
  const int begin = to.begin, base = to.begin * of.fields * of.count;
  Kokkos::parallel_for(
      "rhegma::parallel::pack", Range(begin, to.end), KOKKOS_LAMBDA(const int e) {
        int i = base + (place(e) - place(begin)) * of.count;
        for (int f = 0; f < of.fields; ++f)
        {
          const int row = at(nodes(entry(e)), f);
          if (row < 0 && !all)
            continue;
          for (int c = 0; c < of.count; ++c)
            sent(i++) = row < 0 ? 0.0 : of.values[static_cast<std::size_t>(row) * of.width + of.first + c];
        }
      });
}

void NeighbourSums::add(const SharedRows& rows, const Columns& columns, const Neighbour& from)
{
  const View<int*> nodes = nodes_, entry = entry_, place = place_;
  const View<double*> received = received_, total = total_;
  const SharedRows at = rows;
  const Columns of = columns;
  const bool all = rows.rowOf.extent(0) == 0;
  const int begin = from.begin, base = from.begin * of.fields * of.count;
  Kokkos::parallel_for(
      "rhegma::parallel::add", Range(begin, from.end), KOKKOS_LAMBDA(const int e) {
        int i = base + (place(e) - place(begin)) * of.count;
        for (int f = 0; f < of.fields; ++f)
          if (all || at(nodes(entry(e)), f) >= 0)
            for (int c = 0; c < of.count; ++c)
              total((entry(e) * of.fields + f) * of.count + c) += received(i++);
      });
}

void NeighbourSums::addOwn(const SharedRows& rows, const Columns& columns)
{
  const View<int*> nodes = nodes_;
  const View<double*> total = total_;
  const SharedRows at = rows;
  const Columns of = columns;
  Kokkos::parallel_for(
      "rhegma::parallel::addOwn", Range(0, nodes.extent(0)), KOKKOS_LAMBDA(const int i) {
        for (int f = 0; f < of.fields; ++f)
        {
          const int row = at(nodes(i), f);
          for (int c = 0; row >= 0 && c < of.count; ++c)
            total((i * of.fields + f) * of.count + c) +=
                of.values[static_cast<std::size_t>(row) * of.width + of.first + c];
        }
      });
}

void NeighbourSums::exchange(const Columns& columns)
{
  const MPI_Comm all = *dynamic_cast<const Teuchos::MpiComm<int>&>(*ranks_.comm()).getRawMpiComm();
  const auto out = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, sent_);
  const auto in = Kokkos::create_mirror_view(received_);
  const int row = columns.count, room = columns.fields * columns.count;
  std::vector<MPI_Request> requests;
  requests.reserve(2 * neighbours_.size());
  const auto waiting = [&](auto start, double* buffer, const Neighbour& neighbour, int numbers)
  {
    MPI_Request request;
    start(buffer + static_cast<std::size_t>(neighbour.begin) * room, numbers, MPI_DOUBLE, neighbour.rank, tag,
          all, &request);
    requests.push_back(request);
  };
  // There is room for more than is expected, so that what is not expected is told.
  for (const Neighbour& neighbour : neighbours_)
    if (neighbour.filled > 0)
      waiting(MPI_Irecv, in.data(), neighbour, (neighbour.end - neighbour.begin) * room);
  const int expected = static_cast<int>(requests.size());
  for (const Neighbour& neighbour : neighbours_)
    if (neighbour.filled > 0)
      waiting(MPI_Isend, out.data(), neighbour, neighbour.filled * row);
  std::vector<MPI_Status> states(requests.size());
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), states.data());
  int k = 0;
  for (const Neighbour& neighbour : neighbours_)
    if (neighbour.filled > 0)
    {
      int came = 0;
      MPI_Get_count(&states[k++], MPI_DOUBLE, &came);
      if (came != neighbour.filled * row || k > expected)
        throw std::logic_error("two ranks differ about the rows of the nodes that they share");
    }
  Kokkos::deep_copy(received_, in);
}

} // namespace Rhegma
