#include "step/TransferRun.hpp"

#include "archive/Archive.hpp"
#include "archive/BroadcastRecord.hpp"

namespace Rhegma
{

template <int D>
Record recordOf(Run<D>& run)
{
  const Ranks& ranks = run.state().ranks;
  Record record;
  Archive archive = Archive::saving(record, ranks);
  run.serialize(archive);
  broadcastRecord(ranks, record);
  return record;
}

template <int D>
void loadRecord(const Record& record, Run<D>& run)
{
  Archive archive = Archive::loading(record, run.state().ranks);
  run.serialize(archive);
}

template Record recordOf(Run<2>&);
template Record recordOf(Run<3>&);
template void loadRecord(const Record&, Run<2>&);
template void loadRecord(const Record&, Run<3>&);

} // namespace Rhegma
