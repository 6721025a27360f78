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

/// Extent of a history, to check the file of a run that continues.
struct HistorySoFar
{
  long long bytes = 0; ///< size of complete rows, the first with the names of the columns
  unsigned long crc = 0;
  double lastTime = 0.0; ///< of the last row [s]
};

/// Whether a file begins with a history.
bool beginsWith(const std::string& path, const HistorySoFar& soFar);

/// Writes samples as comma-separated values, one row each, with as many digits as a double has.
///
/// The first row fixes the columns. Only complete rows are written: every second of wall time, every few rows
/// and at the end, so that a run that stops leaves no partial row. Throws OutputError when the file can't be
/// made or written; earlier rows stay complete. After rows were lost no later ones are written, so that the
/// file has no gap, and every call that should write throws the same error again.
class History
{
public:
  using Row = std::vector<std::pair<std::string, double>>;

  explicit History(const std::string& path);
  /// Continues a file that begins with the history `soFar`; the rest of it is removed.
  History(const std::string& path, const HistorySoFar& soFar);
  ~History();
  History(History&&) noexcept;
  History& operator=(History&&) noexcept;

  /// Adds a row. A row of the same time as the one before is the same sample and is left out.
  /// \param time [s]
  /// Throws std::logic_error when the names are not those of the first row, or one comes twice.
  void write(double time, const Row& row);

  /// Includes rows that are not yet written, but none that were lost.
  HistorySoFar soFar() const;

  /// Why rows could not be written; empty if none were lost.
  const std::string& whyLost() const { return lost_; }

  /// Writes the rows that are held back to the file.
  void flush();

  /// Writes all rows and synchronises the file.
  void sync();

  /// Synchronises the file where its beginning of so many bytes has been written; also after later rows were
  /// lost. Throws OutputError if the beginning is incomplete or can't be synchronised.
  void syncBeginning(long long bytes);

  /// Writes the remaining rows and closes the file; later rows are an error. Throws OutputError also where
  /// rows were lost before.
  void close();

private:
  struct Closer
  {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  void setColumns(const Row& row);
  void hold(const std::string& text);
  void checkColumns(const Row& row) const;

  std::string path_;
  std::unique_ptr<std::FILE, Closer> file_;
  std::vector<std::string> columns_;
  std::string header_;    ///< of a file that is continued
  unsigned long crc_ = 0; ///< of all rows that are not lost
  std::string held_;      ///< complete rows that are not yet written
  int heldRows_ = 0;
  HistorySoFar written_; ///< complete rows in the file
  bool begun_ = false;
  std::string lost_; ///< why rows could not be written; empty: all were
  double lastTime_ = 0.0;
  std::chrono::steady_clock::time_point lastFlush_;
};

} // namespace Rhegma
