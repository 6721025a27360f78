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
  ~History();
  History(History&&) noexcept;
  History& operator=(History&&) noexcept;

  /// Adds a row. A row of the same time as the one before is the same sample and is left out.
  /// \param time [s]
  /// Throws std::logic_error when the names are not those of the first row, or one comes twice.
  void write(double time, const Row& row);

  /// Writes what is still held back and closes the file; later rows are an error.
  void close();

private:
  struct Closer
  {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  void setColumns(const Row& row);
  void checkColumns(const Row& row) const;
  void flush();

  std::string path_;
  std::unique_ptr<std::FILE, Closer> file_;
  std::vector<std::string> columns_;
  std::string held_; ///< whole rows on their way to the file
  int heldRows_ = 0;
  long long written_ = 0; ///< bytes of whole rows in the file
  bool begun_ = false;
  double lastTime_ = 0.0;
  std::chrono::steady_clock::time_point lastFlush_;
};

} // namespace Rhegma
