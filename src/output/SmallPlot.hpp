#pragma once
/// A small plot of curves over time as SVG.

#include <string>
#include <utility>
#include <vector>

namespace Rhegma
{

/// Text with the characters that HTML reserves replaced.
std::string escapedForHtml(const std::string& text);

/// Collects curves over time and draws them. Of many points every second one is dropped, again and again, so
/// that memory and drawing stay small.
class SmallPlot
{
public:
  /// \param title, unit of the values, as plain text
  SmallPlot(std::string title, std::string unit) : title_(std::move(title)), unit_(std::move(unit)) {}

  /// Names of the curves; those after the first few are left out. Call once, before the first point.
  void setCurves(const std::vector<std::string>& names);
  bool hasCurves() const { return !names_.empty(); }
  const std::vector<std::string>& names() const { return names_; }

  /// Adds a point to each curve. \param time [s] \param values one a curve; gaps where they are not finite
  void add(double time, const std::vector<double>& values);

  /// The plot; empty while there are less than two points. \param end of the axis of time [s]
  std::string svg(double end) const;

  static constexpr std::size_t mostCurves = 8, mostPoints = 400;

private:
  std::string curve(std::size_t c, double low, double high, double end) const;

  std::string title_, unit_;
  std::vector<std::string> names_;
  std::vector<double> times_;
  std::vector<std::vector<double>> values_; ///< of each time
  std::size_t stride_ = 1, skipped_ = 0;
  bool lastIsExtra_ = false; ///< the last point is kept only until the next one comes
};

} // namespace Rhegma
