/// The page of a run that goes on, and its plots.

#include "SmallState.hpp"
#include "output/History.hpp"
#include "output/SampleFigures.hpp"
#include "output/WatchPage.hpp"

#include <cmath>

using namespace Rhegma;

namespace
{

/// A run of 10 s of which half is done, watched by a clock that the test sets.
struct WatchedRun
{
  double now = 50.0;
  Folder folder;
  Progress progress{nullptr, 10.0, false, [this] { return now; }};

  WatchedRun()
  {
    progress.follow();
    now += 1.0;
    progress.step(5.0, 1);
  }
  Progress::Clock clock()
  {
    return [this] { return now; };
  }
  std::string text() const { return contents(folder.path("watch.html")); }
};

Progress::Row rowOf(double release)
{
  return {{"strain", 2.0},
          {"external_work", 4.0},
          {"residual", -0.001},
          {"A<b.0.G_J", release},
          {"Other.x", 7.0}};
}

std::size_t occurrences(const std::string& text, const std::string& part)
{
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++n;
  return n;
}

} // namespace

TEST(WatchPage, IsThereFromTheStartAndReloadsItself)
{
  WatchedRun run;
  const WatchPage page(run.folder.path(), "scene & co.xml", run.progress, run.clock());
  const std::string text = run.text();
  EXPECT_NE(text.find("http-equiv=\"refresh\""), std::string::npos);
  EXPECT_NE(text.find("<h1>scene &amp; co.xml</h1>"), std::string::npos);
  EXPECT_NE(text.find(" 50 %, 1 s left, step 1"), std::string::npos);
  EXPECT_NE(text.find("width:50%"), std::string::npos);
  EXPECT_NE(text.find("There is no sample yet"), std::string::npos);
}

/// No network: nothing to load, no script, no address.
TEST(WatchPage, NeedsNothingElse)
{
  WatchedRun run;
  WatchPage page(run.folder.path(), "scene.xml", run.progress, run.clock());
  page.sample(1.0, rowOf(1.0));
  page.sample(2.0, rowOf(2.0));
  page.finish("");
  for (const char* part : {"http://", "https://", "<script", "src=", "<link", "url("})
    EXPECT_EQ(run.text().find(part), std::string::npos) << part;
}

TEST(WatchPage, HasLastValuesAndPlots)
{
  WatchedRun run;
  WatchPage page(run.folder.path(), "scene.xml", run.progress, run.clock());
  for (int k = 0; k <= 5; ++k)
    page.sample(k, rowOf(0.5 * k));
  run.now += 2.0;
  page.update();
  const std::string text = run.text();
  EXPECT_NE(text.find("<td>A&lt;b.0.G_J</td><td>2.5 J/m\u00b2</td>"), std::string::npos);
  EXPECT_NE(text.find("<td>external_work</td><td>4 J</td>"), std::string::npos);
  EXPECT_EQ(text.find("Other.x"), std::string::npos);
  EXPECT_EQ(occurrences(text, "<svg"), 2u);
  // G from 0 to 2.5 in half of the width: from the lower left to the middle of the top.
  EXPECT_NE(text.find("M80.0,194.0"), std::string::npos);
  EXPECT_NE(text.find("L355.0,28.0"), std::string::npos);
}

TEST(WatchPage, IsReplacedAtMostEveryTwoSeconds)
{
  WatchedRun run;
  WatchPage page(run.folder.path(), "scene.xml", run.progress, run.clock());
  const std::string first = run.text();
  page.sample(1.0, rowOf(1.0));
  run.now += 1.9;
  page.update();
  EXPECT_EQ(run.text(), first);
  run.now += 0.2;
  page.update();
  const std::string second = run.text();
  EXPECT_NE(second, first);
  page.sample(2.0, rowOf(2.0));
  run.now += 1.9;
  page.update();
  EXPECT_EQ(run.text(), second);
  EXPECT_FALSE(std::filesystem::exists(run.folder.path("watch.html.part")));
}

TEST(WatchPage, EndsWithTheRun)
{
  WatchedRun run;
  WatchPage page(run.folder.path(), "scene.xml", run.progress, run.clock());
  page.finish("");
  EXPECT_EQ(run.text().find("refresh"), std::string::npos);
  EXPECT_NE(run.text().find("The run has ended."), std::string::npos);
  EXPECT_NE(run.text().find("width:100%"), std::string::npos) << "ended at half of Final Time";
  page.finish("an unstable step: v > c");
  EXPECT_NE(run.text().find("class=\"fault\">an unstable step: v &gt; c"), std::string::npos);
  EXPECT_NE(run.text().find("width:50%"), std::string::npos);
}

/// A run that continues has the history up to its checkpoint.
TEST(WatchPage, BeginsWithTheHistoryOfARunThatContinues)
{
  WatchedRun run;
  {
    History history(run.folder.path("history.csv"));
    for (int k = 0; k < 4; ++k)
      history.write(k, rowOf(k));
  }
  const WatchPage page(run.folder.path(), "scene.xml", run.progress, run.clock());
  EXPECT_NE(run.text().find("<td>A&lt;b.0.G_J</td><td>3 J/m\u00b2</td>"), std::string::npos);
  EXPECT_EQ(occurrences(run.text(), "<svg"), 2u);
}

TEST(WatchPage, DoesNotStopARunWhoseFolderIsGone)
{
  WatchedRun run;
  WatchPage page(run.folder.path() + "/gone", "scene.xml", run.progress, run.clock());
  run.now += 5.0;
  EXPECT_NO_THROW(page.update());
  EXPECT_NO_THROW(page.finish(""));
}

/// Of a long run the points are thinned, and the plot still goes from its first to its last one.
TEST(SmallPlot, StaysSmall)
{
  SmallPlot plot("Title", "J");
  plot.setCurves({"one"});
  for (int k = 0; k <= 100000; ++k)
    plot.add(k, {1.0 + k});
  const std::string svg = plot.svg(100000.0);
  const std::size_t points = occurrences(svg.substr(svg.rfind("<path")), "L") + 1;
  EXPECT_LE(points, SmallPlot::mostPoints);
  EXPECT_GE(points, SmallPlot::mostPoints / 3);
  EXPECT_NE(svg.find("M80.0,194.0"), std::string::npos);
  EXPECT_NE(svg.find("L630.0,28.0"), std::string::npos);
}

TEST(SmallPlot, HasGapsWhereThereIsNoValue)
{
  SmallPlot plot("Title", "J");
  plot.setCurves({"one"});
  for (const double value : {0.0, 1.0, std::nan(""), 2.0, 3.0})
    plot.add(value == value ? value : 1.5, {value});
  const std::string svg = plot.svg(3.0);
  EXPECT_EQ(occurrences(svg.substr(svg.rfind("<path")), "M"), 2u);
}

TEST(SmallPlot, ForgetsWhatARunThatWentBackRepeats)
{
  SmallPlot plot("Title", "J");
  plot.setCurves({"one"});
  for (const double time : {0.0, 1.0, 2.0, 3.0, 1.0, 2.0})
    plot.add(time, {time});
  const std::string svg = plot.svg(2.0);
  EXPECT_EQ(occurrences(svg.substr(svg.rfind("<path")), "L"), 2u);
}

TEST(SmallPlot, IsEmptyWithoutACurve)
{
  SmallPlot plot("Title", "J");
  EXPECT_EQ(plot.svg(1.0), "");
  plot.setCurves({"one"});
  plot.add(0.0, {1.0});
  EXPECT_EQ(plot.svg(1.0), "");
}

TEST(SampleFigures, TheLargestReleaseIsThatOfAllFronts)
{
  using Releases = std::vector<double>;
  EXPECT_EQ(releasesOf({{"strain", 3.0}}), Releases());
  EXPECT_EQ(releasesOf({{"A.0.G_J", std::nan("")}}), Releases());
  EXPECT_EQ(releasesOf({{"A.0.G_J", 2.0}, {"B.0.G_J", 5.0}, {"A.1.G_J", std::nan("")}}),
            Releases({2.0, 5.0}));
  EXPECT_EQ(releasesOf({{"A.0.G_J", 2.0}, {"A.0.G_J_min", 1.0}, {"A.0.G_J_max", 3.0}}), Releases({3.0}));
  EXPECT_EQ(releasesOf({{"A.0.G_J", -2.0}}), Releases({-2.0}));
}

TEST(SampleFigures, TheResidualIsAFractionOfTheLargestEnergy)
{
  EXPECT_FALSE(residualFraction({{"strain", 3.0}}));
  EXPECT_FALSE(residualFraction({{"strain", 0.0}, {"residual", 1.0}}));
  EXPECT_DOUBLE_EQ(
      *residualFraction({{"external_work", -4.0}, {"strain", 3.0}, {"residual", 0.1}, {"A.K_I", 9.0}}),
      0.025);
}
