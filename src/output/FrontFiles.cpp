#include "output/FrontFiles.hpp"

#include "archive/Archive.hpp"
#include "base/OutputError.hpp"
#include "files/Sync.hpp"
#include "output/CsvText.hpp"
#include "output/Hdf5.hpp"
#include "parallel/FirstRank.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <memory>
#include <unistd.h>
#include <utility>
#include <zlib.h>

namespace Rhegma
{

namespace
{

constexpr const char* header = "time,crack,front,node,s,x,y,z,G,K_I,K_II,K_III,speed\n";

DataSet column(const std::string& name, const std::vector<double>& values)
{
  return {name, DataSet::Role::OnPoints, 1, false, values, {}};
}

/// The tables of a front.
OutputMesh tablesOf(const FrontValues& front)
{
  std::string name = front.crack + "." + std::to_string(front.number);
  std::replace(name.begin(), name.end(), '/', '_'); // which would divide the name
  OutputMesh mesh{name, "", {}};
  DataSet position{"position", DataSet::Role::Points, 3, false, {}, {}};
  for (const Vector<3>& x : front.position)
    position.real.insert(position.real.end(), x.c, x.c + 3);
  DataSet line{"line", DataSet::Role::OnPoints, 1, true, {}, front.line};
  mesh.data = {column("s", front.arc),       std::move(position),
               column("G", front.release),   column("K_I", front.modeI),
               column("K_II", front.modeII), column("K_III", front.modeIII),
               column("speed", front.speed), std::move(line)};
  return mesh;
}

std::string rowsOf(double time, const FrontValues& front)
{
  const std::string start =
      digits(time) + "," + quoted(front.crack) + "," + std::to_string(front.number) + ",";
  std::string text;
  for (std::size_t k = 0; k < front.arc.size(); ++k)
  {
    text += start + std::to_string(k);
    const Vector<3>& x = front.position[k];
    for (const double value : {front.arc[k], x[0], x[1], x[2], front.release[k], front.modeI[k],
                               front.modeII[k], front.modeIII[k], front.speed[k]})
      text += "," + digits(value);
    text += "\n";
  }
  return text;
}

[[noreturn]] void failed(const std::string& path)
{
  throw OutputError(path + " can't be written: " + std::strerror(errno));
}

} // namespace

FrontFiles::FrontFiles(std::string folder, const Ranks& ranks)
    : data_(folder + "/fronts.h5"), table_(folder + "/fronts.csv"), ranks_(ranks)
{
}

FrontFiles::FrontFiles(std::string folder, Archive& archive) : FrontFiles(std::move(folder), archive.ranks())
{
  serialize(archive);
  if (written_ > 0)
    onFirstRank<OutputError>(ranks_,
                             [&]
                             {
                               keepSnapshots(data_, written_);
                               if (!beginsWith(table_, rows_))
                                 throw OutputError(table_ + " does not begin with the rows of the run");
                               if (truncate(table_.c_str(), rows_.bytes) != 0)
                                 failed(table_);
                             });
}

void FrontFiles::serialize(Archive& archive)
{
  long bytes = static_cast<long>(rows_.bytes), crc = static_cast<long>(rows_.crc);
  archive("written", written_);
  archive("bytes", bytes);
  archive("crc", crc);
  archive("last_time", rows_.lastTime);
  rows_.bytes = bytes;
  rows_.crc = static_cast<unsigned long>(crc);
}

void FrontFiles::sync() const
{
  if (written_ == 0)
    return;
  syncFile(data_);
  syncFile(table_);
}

void FrontFiles::write(double time, const std::vector<FrontValues>& fronts)
{
  std::vector<FrontValues> there;
  std::copy_if(fronts.begin(), fronts.end(), std::back_inserter(there),
               [](const FrontValues& front) { return !front.arc.empty(); });
  if (there.empty() || (written_ > 0 && time == rows_.lastTime))
    return;
  onFirstRank<OutputError>(ranks_, [&] { append(time, there); });
  ++written_; // on all ranks alike, as checkpoints need it
  rows_.lastTime = time;
}

void FrontFiles::append(double time, const std::vector<FrontValues>& fronts)
{
  Snapshot sample;
  sample.time = time;
  std::string text = written_ == 0 ? header : "";
  for (const FrontValues& front : fronts)
  {
    sample.meshes.push_back(tablesOf(front));
    text += rowsOf(time, front);
  }
  if (written_ == 0)
    createHdf5(data_);
  appendSnapshot(data_, snapshotName(written_), sample);
  appendRows(text);
}

void FrontFiles::appendRows(const std::string& text)
{
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(
      std::fopen(table_.c_str(), written_ == 0 ? "wb" : "ab"), std::fclose);
  if (!file)
    failed(table_);
  std::setvbuf(file.get(), nullptr, _IONBF, 0); // one call writes all rows
  if (std::fwrite(text.data(), 1, text.size(), file.get()) != text.size())
  {
    const int reason = errno;
    // A full disk takes a part of a row.
    if (ftruncate(fileno(file.get()), rows_.bytes) != 0)
      failed(table_);
    errno = reason;
    failed(table_);
  }
  rows_.bytes += static_cast<long long>(text.size());
  rows_.crc = crc32(rows_.crc, reinterpret_cast<const Bytef*>(text.data()), static_cast<uInt>(text.size()));
}

} // namespace Rhegma
