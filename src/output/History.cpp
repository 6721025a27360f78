#include "output/History.hpp"

#include "output/OutputError.hpp"

#include <cerrno>
#include <cstring>
#include <set>
#include <stdexcept>
#include <unistd.h>

namespace Rhegma
{

namespace
{

constexpr int mostHeldRows = 16;
constexpr std::chrono::seconds longestHeld{1};

/// 17 digits bring a double back as it was.
std::string digits(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

/// A name as a field of a row: in quotes where it holds what separates fields (RFC 4180).
std::string quoted(const std::string& name)
{
  if (name.find_first_of(",\"\r\n") == std::string::npos)
    return name;
  std::string text = "\"";
  for (const char c : name)
    text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + "\"";
}

} // namespace

History::History(const std::string& path)
    : path_(path), file_(std::fopen(path.c_str(), "wb")), lastFlush_(std::chrono::steady_clock::now())
{
  if (!file_)
    throw OutputError(path + " can't be written: " + std::strerror(errno));
  // Rows are held here and go out in one piece each time.
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
    // Who wants to know of a full disk closes the history.
  }
}

History::History(History&&) noexcept = default;
History& History::operator=(History&&) noexcept = default;

void History::setColumns(const Row& row)
{
  std::set<std::string> seen{"time"};
  held_ += "time";
  for (const auto& column : row)
  {
    if (!seen.insert(column.first).second)
      throw std::logic_error("the history has two columns \"" + column.first + "\"");
    columns_.push_back(column.first);
    held_ += "," + quoted(column.first);
  }
  held_ += "\n";
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
    throw std::logic_error("a row for a history that is closed");
  if (begun_ && time == lastTime_)
    return;
  if (!begun_)
    setColumns(row);
  checkColumns(row);
  begun_ = true;
  lastTime_ = time;
  held_ += digits(time);
  for (const auto& column : row)
    held_ += "," + digits(column.second);
  held_ += "\n";
  ++heldRows_;
  if (heldRows_ >= mostHeldRows || std::chrono::steady_clock::now() - lastFlush_ >= longestHeld)
    flush();
}

void History::flush()
{
  const bool good = std::fwrite(held_.data(), 1, held_.size(), file_.get()) == held_.size();
  const int reason = errno;
  if (good)
    written_ += static_cast<long long>(held_.size());
  held_.clear();
  heldRows_ = 0;
  lastFlush_ = std::chrono::steady_clock::now();
  if (good)
    return;
  // A full disk takes what still fits; the half row goes again.
  if (ftruncate(fileno(file_.get()), written_) != 0)
    throw OutputError(path_ + " can't be written and ends in half a row: " + std::strerror(reason));
  throw OutputError(path_ + " can't be written: " + std::strerror(reason));
}

void History::close()
{
  if (!file_)
    return;
  if (!held_.empty())
    flush();
  if (std::fclose(file_.release()) != 0)
    throw OutputError(path_ + " can't be written: " + std::strerror(errno));
}

} // namespace Rhegma
