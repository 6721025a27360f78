#include "output/History.hpp"

#include "base/OutputError.hpp"
#include "files/Sync.hpp"
#include "output/CsvText.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <set>
#include <stdexcept>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>
#include <zlib.h>

namespace Rhegma
{

namespace
{

constexpr int mostHeldRows = 16;
constexpr std::chrono::seconds longestHeld{1};

unsigned long checksum(unsigned long before, const char* text, std::size_t length)
{
  return crc32(before, reinterpret_cast<const Bytef*>(text), static_cast<uInt>(length));
}

} // namespace

bool beginsWith(const std::string& path, const HistorySoFar& soFar)
{
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  unsigned long crc = 0;
  long long left = soFar.bytes;
  std::vector<char> piece(1 << 16);
  while (file && left > 0)
  {
    const std::size_t most = static_cast<std::size_t>(std::min<long long>(left, piece.size()));
    const std::size_t got = std::fread(piece.data(), 1, most, file.get());
    crc = checksum(crc, piece.data(), got);
    left -= static_cast<long long>(got);
    if (got < most)
      break;
  }
  return file && left == 0 && crc == soFar.crc;
}

History::History(const std::string& path, const HistorySoFar& soFar)
    : path_(path),
      file_(std::fopen(path.c_str(), "r+b")),
      crc_(soFar.crc),
      written_(soFar),
      begun_(soFar.bytes > 0),
      lastTime_(soFar.lastTime),
      lastFlush_(std::chrono::steady_clock::now())
{
  if (!file_ || ftruncate(fileno(file_.get()), soFar.bytes) != 0)
    throw OutputError(path + " can't be written: " + std::strerror(errno));
  for (int c = std::fgetc(file_.get()); c != EOF; c = std::fgetc(file_.get()))
  {
    header_ += static_cast<char>(c);
    if (c == '\n')
      break;
  }
  std::fseek(file_.get(), 0, SEEK_END);
  std::setvbuf(file_.get(), nullptr, _IONBF, 0);
}

History::History(const std::string& path)
    : path_(path), file_(std::fopen(path.c_str(), "wb")), lastFlush_(std::chrono::steady_clock::now())
{
  if (!file_)
    throw OutputError(path + " can't be written: " + std::strerror(errno));
  // Rows are buffered here and written at once.
  std::setvbuf(file_.get(), nullptr, _IONBF, 0);
}

History::~History()
{
  try
  {
    close();
  }
  catch (const std::exception&)
  {
    // Errors of a full disk are reported by close().
  }
}

History::History(History&&) noexcept = default;
History& History::operator=(History&&) noexcept = default;

void History::setColumns(const Row& row)
{
  std::set<std::string> seen{"time"};
  std::string header = "time";
  for (const auto& column : row)
  {
    if (!seen.insert(column.first).second)
      throw std::invalid_argument("the history would have two columns \"" + column.first +
                                  "\": names of the scene give the same one; rename one of the boundaries, "
                                  "tools, probes, cracks or bodies "
                                  "with that name");
    columns_.push_back(column.first);
    header += "," + quoted(column.first);
  }
  header += "\n";
  if (header_.empty())
    hold(header);
  else if (header != header_)
    throw std::logic_error("the history can't be continued with other columns: " + header_ + header);
}

void History::hold(const std::string& text)
{
  crc_ = checksum(crc_, text.data(), text.size());
  held_ += text;
}

void History::checkColumns(const Row& row) const
{
  if (row.size() != columns_.size())
    throw std::logic_error("a row of the history has " + std::to_string(row.size()) +
                           " columns, its first row " + std::to_string(columns_.size()));
  for (std::size_t c = 0; c < row.size(); ++c)
    if (row[c].first != columns_[c])
      throw std::logic_error("a row of the history has \"" + row[c].first + "\" where its first row has \"" +
                             columns_[c] + "\"");
}

void History::write(double time, const Row& row)
{
  if (!file_)
    throw std::logic_error("a row was written to a closed history");
  if (!lost_.empty())
    throw OutputError(lost_);
  if (begun_ && time == lastTime_)
    return;
  if (columns_.empty())
    setColumns(row);
  checkColumns(row);
  begun_ = true;
  lastTime_ = time;
  std::string text = digits(time);
  for (const auto& column : row)
    text += "," + digits(column.second);
  hold(text + "\n");
  ++heldRows_;
  if (heldRows_ >= mostHeldRows || std::chrono::steady_clock::now() - lastFlush_ >= longestHeld)
    flush();
}

void History::flush()
{
  const bool good = lost_.empty() && std::fwrite(held_.data(), 1, held_.size(), file_.get()) == held_.size();
  const int reason = errno;
  if (good)
    written_ = soFar();
  held_.clear();
  heldRows_ = 0;
  lastFlush_ = std::chrono::steady_clock::now();
  if (good)
    return;
  crc_ = written_.crc;
  lastTime_ = written_.lastTime;
  if (lost_.empty())
  {
    // A full disk takes a part of a row; the partial row is removed.
    const bool whole = ftruncate(fileno(file_.get()), written_.bytes) == 0;
    lost_ = path_ + " can't be written" + (whole ? ": " : "; its last row is incomplete: ") +
            std::strerror(reason);
  }
  throw OutputError(lost_);
}

HistorySoFar History::soFar() const
{
  return {written_.bytes + static_cast<long long>(held_.size()), crc_, lastTime_};
}

void History::sync()
{
  if (!file_)
    return;
  if (!held_.empty() || !lost_.empty())
    flush();
  syncBeginning(written_.bytes);
}

void History::syncBeginning(long long bytes)
{
  if (!file_)
    return;
  if (bytes > written_.bytes)
    throw OutputError(lost_.empty() ? path_ + " can't be written: rows are missing" : lost_);
  if (const int reason = syncOpenFile(fileno(file_.get())); reason != 0)
    throw OutputError(path_ + " can't be written: " + std::strerror(reason));
}

void History::close()
{
  if (!file_)
    return;
  if (!held_.empty() && lost_.empty())
    flush();
  struct stat now = {};
  const bool known = fstat(fileno(file_.get()), &now) == 0 && S_ISREG(now.st_mode);
  if (std::fclose(file_.release()) != 0)
    throw OutputError(path_ + " can't be written: " + std::strerror(errno));
  if (!lost_.empty())
    throw OutputError(lost_);
  if (known && (now.st_nlink == 0 || now.st_size != written_.bytes))
    throw OutputError(path_ + " was " + (now.st_nlink == 0 ? "removed" : "changed") +
                      " by another program during the run, so rows are missing");
}

} // namespace Rhegma
