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

View<int*> onDevice(const std::string& label, const std::vector<int>& list)
{
  const View<int*> view(label, list.size());
  const auto host = Kokkos::create_mirror_view(view);
  std::copy(list.begin(), list.end(), host.data());
  Kokkos::deep_copy(view, host);
  return view;
}

/// Where a row is in the buffers: each neighbour's part has room for all rows of its entries.
KOKKOS_INLINE_FUNCTION int startOf(int firstEntry, int rowsBefore, const NeighbourSums::Columns& of)
{
  return (firstEntry * of.fields + rowsBefore) * of.count;
}

} // namespace

NeighbourSums::NeighbourSums(const Ranks& ranks, const View<int*>& nodes,
                             const std::vector<std::vector<int>>& of)
    : ranks_(ranks), nodes_(nodes)
{
  std::vector<int> entries, parts;
  std::vector<std::vector<int>> shares(nodes.extent(0));
  for (int r = 0; r < ranks.size(); ++r)
  {
    if (r == ranks.rank())
      for (std::vector<int>& list : shares)
        list.push_back(-1);
    if (of[r].empty())
      continue;
    const int begin = static_cast<int>(entries.size());
    for (const int node : of[r])
    {
      shares[node].push_back(static_cast<int>(entries.size()));
      entries.push_back(node);
      parts.push_back(begin);
    }
    neighbours_.push_back({r, begin, static_cast<int>(entries.size()), 0});
  }
  std::vector<int> begins = {0}, all;
  for (const std::vector<int>& list : shares)
  {
    all.insert(all.end(), list.begin(), list.end());
    begins.push_back(static_cast<int>(all.size()));
  }
  entry_ = onDevice("rhegma::parallel::entries", entries);
  part_ = onDevice("rhegma::parallel::parts", parts);
  begin_ = onDevice("rhegma::parallel::begins", begins);
  share_ = onDevice("rhegma::parallel::shares", all);
  place_ = View<int*>("rhegma::parallel::places", entries.size() + 1);
}

void NeighbourSums::sum(const SharedRows& rows, double* values, int width, int first, int count)
{
  const int fields = rows.second.extent(0) > 0 ? 2 : 1;
  const Columns columns{values, width, first, count, fields};
  const std::size_t most = entry_.extent(0) * fields * count;
  fit(sent_, "rhegma::parallel::sent", most);
  fit(received_, "rhegma::parallel::received", most);
  findPlaces(rows, fields);
  pack(rows, columns);
  exchange(columns);
  add(rows, columns);
}

void NeighbourSums::findPlaces(const SharedRows& rows, int fields)
{
  const View<int*> nodes = nodes_, entry = entry_, place = place_;
  const SharedRows at = rows;
  const int entries = static_cast<int>(entry.extent(0));
  // Rows of the nodes' own numbers are all sent: only of others do ranks know that all have the same.
  if (rows.rowOf.extent(0) == 0)
  {
    Kokkos::parallel_for(
        "rhegma::parallel::places", Range(0, entries + 1),
        KOKKOS_LAMBDA(const int e) { place(e) = e * fields; });
    for (Neighbour& neighbour : neighbours_)
      neighbour.filled = (neighbour.end - neighbour.begin) * fields;
    return;
  }
  Kokkos::parallel_scan(
      "rhegma::parallel::findPlaces", Range(0, entries + 1),
      KOKKOS_LAMBDA(const int e, int& before, const bool final) {
        if (final)
          place(e) = before;
        for (int f = 0; e < entries && f < fields; ++f)
          before += at(nodes(entry(e)), f) >= 0 ? 1 : 0;
      });
  const auto host = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace{}, place_);
  for (Neighbour& neighbour : neighbours_)
    neighbour.filled = host(neighbour.end) - host(neighbour.begin);
}

void NeighbourSums::pack(const SharedRows& rows, const Columns& columns)
{
  const View<int*> nodes = nodes_, entry = entry_, part = part_, place = place_;
  const View<double*> sent = sent_;
  const SharedRows at = rows;
  const Columns of = columns;
  const bool all = rows.rowOf.extent(0) == 0;
  Kokkos::parallel_for(
      "rhegma::parallel::pack", Range(0, entry.extent(0)), KOKKOS_LAMBDA(const int e) {
        int i = startOf(part(e), place(e) - place(part(e)), of);
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

void NeighbourSums::add(const SharedRows& rows, const Columns& columns)
{
  const View<int*> nodes = nodes_, part = part_, place = place_, begin = begin_, share = share_;
  const View<double*> received = received_;
  const SharedRows at = rows;
  const Columns of = columns;
  const bool all = rows.rowOf.extent(0) == 0;
  Kokkos::parallel_for(
      "rhegma::parallel::add", Range(0, nodes.extent(0)), KOKKOS_LAMBDA(const int i) {
        int before = 0; // rows of this node in a message
        for (int f = 0; f < of.fields; ++f)
        {
          const int row = at(nodes(i), f);
          for (int c = 0; row >= 0 && c < of.count; ++c)
          {
            double& value = of.values[static_cast<std::size_t>(row) * of.width + of.first + c];
            double total = 0.0;
            for (int k = begin(i); k < begin(i + 1); ++k)
            {
              const int e = share(k);
              total += e < 0 ? value : received(startOf(part(e), place(e) - place(part(e)) + before, of) + c);
            }
            value = total;
          }
          before += row >= 0 || all ? 1 : 0;
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
