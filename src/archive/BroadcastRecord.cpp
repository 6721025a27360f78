#include "archive/BroadcastRecord.hpp"

#include <sstream>

namespace Rhegma
{

namespace
{

std::string shapeOf(const RecordTable& table)
{
  std::ostringstream text;
  text << static_cast<int>(table.type);
  for (const std::size_t n : table.extent)
    text << ' ' << n;
  return text.str();
}

RecordTable tableOf(const std::string& shape, const std::string& bytes)
{
  std::istringstream text(shape);
  int type = 0;
  text >> type;
  RecordTable table;
  table.type = static_cast<RecordTable::Type>(type);
  for (std::size_t n = 0; text >> n;)
    table.extent.push_back(n);
  table.bytes.assign(bytes.begin(), bytes.end());
  return table;
}

} // namespace

void broadcastRecord(const Ranks& ranks, Record& record)
{
  if (!ranks.many())
    return;
  const bool first = ranks.rank() == 0;
  Record received;
  auto next = record.begin();
  const int count = static_cast<int>(ranks.max(first ? static_cast<double>(record.size()) : 0.0));
  for (int k = 0; k < count; ++k)
  {
    // The other ranks have no text: all get that of the first.
    const std::string path = ranks.firstText(first ? next->first : std::string());
    const std::string shape = ranks.firstText(first ? shapeOf(next->second) : std::string());
    const std::string bytes = ranks.firstText(
        first ? std::string(next->second.bytes.begin(), next->second.bytes.end()) : std::string());
    if (first)
      ++next;
    else
      received[path] = tableOf(shape, bytes);
  }
  if (!first)
    record = std::move(received);
}

} // namespace Rhegma
