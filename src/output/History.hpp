#pragma once
/// history.csv: a row per sample.

#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace Rhegma
{

/// How far a history has come: what a run that goes on must find in its file.
struct HistorySoFar
{
  long long bytes = 0; ///< of whole rows, the first with the names of the columns
  unsigned long crc = 0;
  double lastTime = 0.0; ///< of the last row [s]
};

/// Whether a file begins with what a history was.
bool beginsWith(const std::string& path, const HistorySoFar& soFar);

/// Writes samples as comma-separated values, one row each, with as many digits as a double has.
///
/// The first row fixes the columns. Rows reach the file whole: every second of wall time, every few rows and
/// at the end, so that a run that stops leaves no half row. Throws OutputError when the file can't be made
/// or written; the rows before stay whole.
class History
{
public:
  using Row = std::vector<std::pair<std::string, double>>;

  explicit History(const std::string& path);
  /// Goes on with a file that begins with what `soFar` says; the rest of it is removed.
  History(const std::string& path, const HistorySoFar& soFar);
  ~History();
  History(History&&) noexcept;
  History& operator=(History&&) noexcept;

  /// Adds a row. A row of the same time as the one before is the same sample and is left out.
  /// \param time [s]
  /// Throws std::logic_error when the names are not those of the first row, or one comes twice.
  void write(double time, const Row& row);

  /// With the rows that are still held back.
  HistorySoFar soFar() const;

  /// Brings all rows to the disk.
  void sync();

  /// Writes what is still held back and closes the file; later rows are an error.
  void close();

private:
  struct Closer
  {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  void setColumns(const Row& row);
  void hold(const std::string& text);
  void checkColumns(const Row& row) const;
  void flush();

  std::string path_;
  std::unique_ptr<std::FILE, Closer> file_;
  std::vector<std::string> columns_;
  std::string header_;    ///< of a file that is gone on with
  unsigned long crc_ = 0; ///< of all rows
  std::string held_;      ///< whole rows on their way to the file
  int heldRows_ = 0;
  long long written_ = 0; ///< bytes of whole rows in the file
  bool begun_ = false;
  bool lost_ = false; ///< rows could not be written
  double lastTime_ = 0.0;
  std::chrono::steady_clock::time_point lastFlush_;
};

} // namespace Rhegma
