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
  View<int*> view(label, list.size());
  const auto host = Kokkos::create_mirror_view(view);
  std::copy(list.begin(), list.end(), host.data());
  Kokkos::deep_copy(view, host);
  return view;
}

/// One number counts rows (multiples of this) and those of them that are sent.
constexpr long long there = 1LL << 32;

KOKKOS_INLINE_FUNCTION int sentOf(long long count) { return static_cast<int>(count % there); }
KOKKOS_INLINE_FUNCTION int thereOf(long long count) { return static_cast<int>(count / there); }

/// Offset of a row of a message in the buffers: each neighbour's part has capacity for all its rows.
KOKKOS_INLINE_FUNCTION int startOf(int firstEntry, int number, const NeighbourSums::Columns& of)
{
  return (firstEntry * of.fields + number) * of.perRow();
}

KOKKOS_INLINE_FUNCTION bool isZero(const double* values, int count)
{
  for (int c = 0; c < count; ++c)
    if (values[c] != 0.0)
      return false;
  return true;
}

} // namespace

NeighbourSums::NeighbourSums(const Ranks& ranks, const View<int*>& nodes,
                             const std::vector<std::vector<int>>& of)
    : ranks_(ranks), nodes_(nodes)
{
  std::vector<int> entries, parts;
  std::vector<std::vector<int>> fractions(nodes.extent(0));
  for (int r = 0; r < ranks.size(); ++r)
  {
    if (r == ranks.rank())
      for (std::vector<int>& list : fractions)
        list.push_back(-1);
    if (of[r].empty())
      continue;
    const int begin = static_cast<int>(entries.size());
    for (const int node : of[r])
    {
      fractions[node].push_back(static_cast<int>(entries.size()));
      entries.push_back(node);
      parts.push_back(begin);
    }
    neighbours_.push_back({r, begin, static_cast<int>(entries.size()), 0, 0, true});
  }
  std::vector<int> begins = {0}, all;
  for (const std::vector<int>& list : fractions)
  {
    all.insert(all.end(), list.begin(), list.end());
    begins.push_back(static_cast<int>(all.size()));
  }
  entry_ = onDevice("rhegma::parallel::entries", entries);
  part_ = onDevice("rhegma::parallel::parts", parts);
  begin_ = onDevice("rhegma::parallel::begins", begins);
  fraction_ = onDevice("rhegma::parallel::fractions", all);
  before_ = View<long long*>("rhegma::parallel::rowsBefore", entries.size() + 1);
  receivedRow_ = View<int*>("rhegma::parallel::received", 2 * entries.size());
  Kokkos::deep_copy(receivedRow_, -1);
}

void NeighbourSums::sum(const SharedRows& rows, double* values, int width, int first, int count)
{
  const int fields = rows.enrichedField.extent(0) > 0 ? 2 : 1;
  const Columns columns{values, width, first, count, fields};
  const std::size_t most = entry_.extent(0) * fields * columns.perRow();
  fit(sent_, "rhegma::parallel::sent", most);
  fit(received_, "rhegma::parallel::received", most);
  pack(rows, columns);
  exchange(columns);
  findFractions(columns, false);
  int strange = 0;
  for (const Neighbour& neighbour : neighbours_)
    strange += add(rows, columns, neighbour);
  findFractions(columns, true);
  if (strange > 0 && rows.rowOf.extent(0) > 0)
    throw std::logic_error("two ranks disagree about the rows of their common nodes");
}

void NeighbourSums::pack(const SharedRows& rows, const Columns& columns)
{
  const View<int*> nodes = nodes_, entry = entry_, part = part_;
  const View<long long*> before = before_;
  const View<double*> sent = sent_;
  const SharedRows at = rows;
  const Columns of = columns;
  const int entries = static_cast<int>(entry.extent(0));
  // Two passes, because the offset of a row depends on the number of rows before it.
  const auto valuesOf = KOKKOS_LAMBDA(int row)
  {
    return of.values + static_cast<std::size_t>(row) * of.width + of.first;
  };
  Kokkos::parallel_scan(
      "rhegma::parallel::countRows", Range(0, entries + 1),
      KOKKOS_LAMBDA(const int e, long long& rowsBefore, const bool final) {
        if (final)
          before(e) = rowsBefore;
        for (int f = 0; e < entries && f < of.fields; ++f)
        {
          const int row = at(nodes(entry(e)), f);
          if (row >= 0)
            rowsBefore += there + (isZero(valuesOf(row), of.count) ? 0 : 1);
        }
      });
  Kokkos::parallel_for(
      "rhegma::parallel::pack", Range(0, entries), KOKKOS_LAMBDA(const int e) {
        int number = sentOf(before(e)) - sentOf(before(part(e)));
        for (int f = 0; sentOf(before(e + 1)) > sentOf(before(e)) && f < of.fields; ++f)
        {
          const int row = at(nodes(entry(e)), f);
          if (row < 0 || isZero(valuesOf(row), of.count))
            continue;
          double* const out = &sent(startOf(part(e), number++, of));
          out[0] = (e - part(e)) * of.fields + f;
          for (int c = 0; c < of.count; ++c)
            out[1 + c] = valuesOf(row)[c];
        }
      });
  const auto host = onHost(before_);
  for (Neighbour& neighbour : neighbours_)
  {
    neighbour.sent = sentOf(host(neighbour.end)) - sentOf(host(neighbour.begin));
    // Rows of the nodes' own numbers may be there: only of others do ranks know that all have the same.
    neighbour.meets =
        rows.rowOf.extent(0) == 0 || thereOf(host(neighbour.end)) > thereOf(host(neighbour.begin));
  }
}

void NeighbourSums::findFractions(const Columns& columns, bool forget)
{
  const View<double*> received = received_;
  const View<int*> receivedRow = receivedRow_;
  const Columns of = columns;
  for (const Neighbour& neighbour : neighbours_)
  {
    const int begin = neighbour.begin;
    Kokkos::parallel_for(
        "rhegma::parallel::findFractions", Range(0, neighbour.received), KOKKOS_LAMBDA(const int k) {
          const int start = startOf(begin, k, of);
          receivedRow(begin * of.fields + static_cast<int>(received(start))) = forget ? -1 : start + 1;
        });
  }
}

int NeighbourSums::add(const SharedRows& rows, const Columns& columns, const Neighbour& from)
{
  const View<int*> nodes = nodes_, entry = entry_, begin = begin_, fraction = fraction_,
                   receivedRow = receivedRow_;
  const View<double*> received = received_;
  const Columns of = columns;
  const int firstEntry = from.begin;
  int strange = 0;
  Kokkos::parallel_reduce(
      "rhegma::parallel::add", Range(0, from.received),
      KOKKOS_LAMBDA(const int n, int& unknown) {
        const int position = static_cast<int>(received(startOf(firstEntry, n, of)));
        const int e = firstEntry + position / of.fields, f = position % of.fields, i = entry(e);
        const auto startOfFraction = [&](int k)
        { return fraction(k) < 0 ? -1 : receivedRow(fraction(k) * of.fields + f); };
        // The first received fraction of a node adds all of them.
        for (int k = begin(i); fraction(k) != e; ++k)
          if (startOfFraction(k) >= 0)
            return;
        const int row = rows(nodes(i), f);
        if (row < 0)
        {
          ++unknown;
          return;
        }
        double* const values = of.values + static_cast<std::size_t>(row) * of.width + of.first;
        for (int c = 0; c < of.count; ++c)
        {
          double total = 0.0;
          for (int k = begin(i); k < begin(i + 1); ++k)
          {
            const int start = startOfFraction(k);
            if (fraction(k) < 0)
              total += values[c];
            else if (start >= 0)
              total += received(start + c);
          }
          values[c] = total;
        }
      },
      strange);
  return strange;
}

void NeighbourSums::exchange(const Columns& columns)
{
  const MPI_Comm all = *dynamic_cast<const Teuchos::MpiComm<int>&>(*ranks_.comm()).getRawMpiComm();
  const auto out = onHost(sent_);
  const auto in = Kokkos::create_mirror_view(received_);
  const int row = columns.perRow(), capacity = columns.fields * row;
  std::vector<MPI_Request> requests;
  requests.reserve(2 * neighbours_.size());
  const auto waiting = [&](auto start, double* buffer, const Neighbour& neighbour, int numbers)
  {
    MPI_Request request;
    start(buffer + static_cast<std::size_t>(neighbour.begin) * capacity, numbers, MPI_DOUBLE, neighbour.rank,
          tag, all, &request);
    requests.push_back(request);
  };
  for (const Neighbour& neighbour : neighbours_)
    if (neighbour.meets)
      waiting(MPI_Irecv, in.data(), neighbour, (neighbour.end - neighbour.begin) * capacity);
  for (const Neighbour& neighbour : neighbours_)
    if (neighbour.meets)
      waiting(MPI_Isend, out.data(), neighbour, neighbour.sent * row);
  std::vector<MPI_Status> states(requests.size());
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), states.data());
  int k = 0;
  for (Neighbour& neighbour : neighbours_)
  {
    neighbour.received = 0;
    if (neighbour.meets)
      MPI_Get_count(&states[k++], MPI_DOUBLE, &neighbour.received);
    neighbour.received /= row;
  }
  Kokkos::deep_copy(received_, in);
}

} // namespace Rhegma
