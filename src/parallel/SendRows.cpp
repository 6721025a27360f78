#include "parallel/SendRows.hpp"

#include "base/Types.hpp"

#include <Tpetra_Distributor.hpp>

#include <algorithm>
#include <numeric>

namespace Rhegma
{

std::vector<double> sendRows(const Ranks& ranks, const std::vector<int>& to, const std::vector<double>& rows,
                             int width)
{
  if (!ranks.many())
    return rows;
  // One message per rank: its rows must be contiguous.
  std::vector<int> order(to.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return to[a] < to[b]; });
  std::vector<int> receiver;
  receiver.reserve(to.size());
  const View<double*> leaving("rhegma::parallel::rowsSent", rows.size());
  const auto host = Kokkos::create_mirror_view(leaving);
  std::size_t at = 0;
  for (const int i : order)
  {
    receiver.push_back(to[i]);
    for (int c = 0; c < width; ++c)
      host(at++) = rows[static_cast<std::size_t>(i) * width + c];
  }
  Kokkos::deep_copy(leaving, host);
  Tpetra::Distributor distributor(ranks.comm());
  const std::size_t arrivals = distributor.createFromSends(Teuchos::arrayViewFromVector(receiver));
  const View<double*> arriving("rhegma::parallel::rowsReceived", arrivals * width);
  const View<const double*> sent = leaving;
  distributor.doPostsAndWaits(sent, width, arriving);
  const auto received = onHost(arriving);
  return {received.data(), received.data() + received.extent(0)};
}

} // namespace Rhegma
