#include "output/SmallPlot.hpp"

#include "base/Numbers.hpp"
#include "base/ShortNumber.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace Rhegma
{

namespace
{

constexpr double width = 640.0, height = 220.0, left = 80.0, right = 10.0, top = 28.0, bottom = 26.0;

/// The palette of Okabe and Ito (2008), as in pictures of the tools.
constexpr const char* colours[] = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                   "#56B4E9", "#E69F00", "#000000", "#117733"};

std::string pixels(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", value);
  return text;
}

std::string label(double x, double y, const std::string& text, const char* more)
{
  return "<text x=\"" + pixels(x) + "\" y=\"" + pixels(y) + "\" " + more + ">" + escapedForHtml(text) +
         "</text>";
}

std::string line(double x1, double y1, double x2, double y2)
{
  return "<path d=\"M" + pixels(x1) + "," + pixels(y1) + "L" + pixels(x2) + "," + pixels(y2) +
         "\" stroke=\"#bbb\" fill=\"none\"/>";
}

double across(double time, double end)
{
  return left + (width - left - right) * (end > 0.0 ? std::min(time / end, 1.0) : 0.0);
}

double up(double value, double low, double high)
{
  return height - bottom - (height - top - bottom) * (value - low) / (high - low);
}

} // namespace

std::string escapedForHtml(const std::string& text)
{
  std::string safe;
  for (const char c : text)
    if (c == '&')
      safe += "&amp;";
    else if (c == '<')
      safe += "&lt;";
    else if (c == '>')
      safe += "&gt;";
    else if (c == '"')
      safe += "&quot;";
    else
      safe += c;
  return safe;
}

void SmallPlot::setCurves(const std::vector<std::string>& names)
{
  names_.assign(names.begin(),
                names.begin() + static_cast<std::ptrdiff_t>(std::min(names.size(), mostCurves)));
}

void SmallPlot::add(double time, const std::vector<double>& values)
{
  if (lastIsExtra_)
  {
    times_.pop_back();
    values_.pop_back();
  }
  while (!times_.empty() && times_.back() >= time) // a run that has gone back to an earlier state
  {
    times_.pop_back();
    values_.pop_back();
  }
  // The last point is always there, so that the plot ends where the run is.
  lastIsExtra_ = skipped_ + 1 < stride_;
  skipped_ = lastIsExtra_ ? skipped_ + 1 : 0;
  times_.push_back(time);
  values_.push_back(values);
  if (times_.size() < mostPoints)
    return;
  std::size_t kept = 0;
  for (std::size_t k = 0; k < times_.size(); k += 2, ++kept)
  {
    times_[kept] = times_[k];
    values_[kept] = values_[k];
  }
  times_.resize(kept);
  values_.resize(kept);
  stride_ *= 2;
  skipped_ = 0;
  lastIsExtra_ = false;
}

std::string SmallPlot::curve(std::size_t c, double low, double high, double end) const
{
  std::string path;
  bool drawn = false;
  for (std::size_t k = 0; k < times_.size(); ++k)
  {
    const double value = c < values_[k].size() ? values_[k][c] : NAN;
    if (std::isfinite(value))
      path += (drawn ? "L" : "M") + pixels(across(times_[k], end)) + "," + pixels(up(value, low, high));
    drawn = std::isfinite(value);
  }
  return "<path d=\"" + path + "\" stroke=\"" + colours[c] + "\" stroke-width=\"1.6\" fill=\"none\"/>";
}

std::string SmallPlot::svg(double end) const
{
  double low = 0.0, high = 0.0;
  for (const std::vector<double>& point : values_)
    for (std::size_t c = 0; c < std::min(point.size(), names_.size()); ++c)
      if (std::isfinite(point[c]))
      {
        low = std::min(low, point[c]);
        high = std::max(high, point[c]);
      }
  if (times_.size() < 2 || !(high > low))
    return {};
  std::string text = "<svg viewBox=\"0 0 " + pixels(width) + " " + pixels(height) +
                     "\" role=\"img\" aria-label=\"" + escapedForHtml(title_) + " over time\">" +
                     label(left, 14.0, title_ + " [" + unit_ + "]", "font-weight=\"bold\"");
  for (const double value : {low, high})
    text += line(left, up(value, low, high), width - right, up(value, low, high)) +
            label(left - 6.0, up(value, low, high) + 4.0, formatShort(value), "text-anchor=\"end\"");
  if (low < 0.0)
    text += line(left, up(0.0, low, high), width - right, up(0.0, low, high));
  text += label(left, height - 8.0, "0", "text-anchor=\"middle\"") +
          label(width - right, height - 8.0, "t = " + readableTime(end), "text-anchor=\"end\"");
  for (std::size_t c = 0; c < names_.size(); ++c)
    text += curve(c, low, high, end);
  text += "</svg><p class=\"key\">";
  for (std::size_t c = 0; c < names_.size(); ++c)
    text += std::string("<span style=\"color:") + colours[c] + "\">&#9644; " + escapedForHtml(names_[c]) +
            "</span> ";
  return text + "</p>";
}

} // namespace Rhegma
