#include "CubeScene.hpp"

#include "cracks/OverlapRecord.hpp"

using namespace Rhegma;
using namespace Rhegma::cracks;
using namespace Rhegma::cracks::test;

namespace
{

/// A block that a crack cuts halfway, whose faces are moved by hand.
class Faces
{
public:
  Faces()
  {
    Teuchos::ParameterList scene = blockScene({16.0 * cell, 6.0 * cell});
    setCrack(scene, {0.0, height * cell, 8.0 * cell, height * cell});
    run_ = start<2>(scene);
    run_->step(1e-15, false);
  }

  Draws draw;

  State<2>& state() { return run_->state(); }

  /// Opens the crack by a distance, negative to let its faces overlap, and samples that.
  void sample(double opening)
  {
    const auto face = onHost(state().cracks.face);
    for (std::size_t v = 0; v + 1 < face.extent(0); ++v)
    {
      face(v, 0, 1) = height * cell - 0.5 * opening;
      face(v, 1, 1) = height * cell + 0.5 * opening;
    }
    Kokkos::deep_copy(state().cracks.face, face);
    state().clock.time += 1e-6;
    recordOverlaps(state(), openingsOf(state().cracks), false, records_);
  }

  const LargestOverlap& record() const { return records_.at(0).ever; }
  std::string warning() { return warningOfRecord(state(), 0, records_.at(0), "add a section Contact"); }

private:
  static constexpr double height = 2.5;
  std::unique_ptr<Run<2>> run_;
  std::vector<OverlapRecord> records_;
};

} // namespace

/// An overlap in between is reported once the crack is open again, with the time at which it was largest.
TEST(OverlapRecord, WarnsOfAnOverlapThatIsOver)
{
  Faces faces;
  const double opening = faces.draw(0.2, 0.5) * cell, fraction = faces.draw(0.11, 0.9);
  faces.sample(opening);
  EXPECT_EQ(faces.warning(), "");
  faces.sample(-fraction * opening);
  faces.sample(-0.5 * fraction * opening);
  faces.sample(opening);
  EXPECT_NEAR(faces.record().overlap, fraction * opening, 1e-9 * cell);
  EXPECT_NEAR(faces.record().time, 2e-6, 1e-12);
  const std::string said = faces.warning();
  for (const char* words : {"crack Cut", "% of its largest opening", "at t = 2 us", "add a section Contact"})
    EXPECT_NE(said.find(words), std::string::npos) << said;
}

/// K_I of a tenth of the largest is not worth a word, nor is rounding.
TEST(OverlapRecord, IgnoresSmallOnes)
{
  Faces faces;
  faces.sample(-1e-10 * cell);
  EXPECT_EQ(faces.record().overlap, 0.0);
  EXPECT_EQ(faces.warning(), "");
  const double opening = faces.draw(0.5, 0.9) * cell;
  faces.sample(-faces.draw(0.05, 0.09) * opening);
  EXPECT_NE(faces.warning(), "") << "the crack has not opened yet";
  faces.sample(opening);
  EXPECT_EQ(faces.warning(), "");
}

/// Waves before the load of a crack overlap its faces by less than contact would; with growth that matters.
TEST(OverlapRecord, CountsSmallOnesWhereACrackGrows)
{
  Faces faces;
  faces.sample(-faces.draw(0.001, 0.019) * cell);
  EXPECT_EQ(faces.warning(), "");
  faces.state().cracks.fronts.at(0).grown = true;
  EXPECT_NE(faces.warning(), "");
}

/// A crack that opens wide as it grows has still started wrong: its overlap is compared with the opening
/// until then. One whose faces overlapped by little compared with that has started right.
TEST(OverlapRecord, ComparesWithTheOpeningBeforeGrowth)
{
  for (const bool wrong : {true, false})
  {
    Faces faces;
    const double opening = faces.draw(0.2, 0.5) * cell;
    const double fraction = wrong ? faces.draw(0.2, 0.9) : faces.draw(0.03, 0.09);
    faces.sample(opening);
    faces.sample(-fraction * opening);
    faces.state().cracks.fronts.at(0).grown = true;
    faces.sample(20.0 * opening);
    const std::string said = faces.warning();
    EXPECT_EQ(said.empty(), !wrong) << fraction << said;
    EXPECT_EQ(said.find("% of its largest opening before it grew) at t = 2 us, before it grew") ==
                  std::string::npos,
              !wrong)
        << said;
  }
}

/// What overlaps after growth began is compared with the opening of the whole run.
TEST(OverlapRecord, ComparesLaterOverlapsWithTheWholeOpening)
{
  Faces faces;
  faces.sample(0.01 * cell);
  faces.state().cracks.fronts.at(0).grown = true;
  const double opening = faces.draw(0.5, 0.9) * cell;
  faces.sample(opening);
  faces.sample(-faces.draw(0.03, 0.09) * opening);
  EXPECT_EQ(faces.warning(), "");
  faces.sample(-faces.draw(0.12, 0.5) * opening);
  EXPECT_NE(faces.warning(), "");
}

/// Pieces that fly apart excuse nothing: their opening is no measure of K.
TEST(OverlapRecord, ForgetsPiecesThatFlyApart)
{
  Faces faces;
  faces.sample(0.1 * cell);
  faces.sample(-0.05 * cell);
  faces.state().cracks.fronts.at(0).ended = true;
  faces.sample(20.0 * cell);
  EXPECT_NE(faces.warning().find("50 % of its largest opening"), std::string::npos) << faces.warning();
}

/// Vertices follow single nodes, as far as a cell is strained: three times that is no overlap of faces.
TEST(OverlapRecord, LeavesOutTheStrainOfACell)
{
  Faces faces;
  const double strain = faces.draw(0.007, 0.02);
  const auto F = faces.state().particles.real<gradientSize<2>>(fields::deformation);
  const auto host = onHost(F);
  for (std::size_t p = 0; p < host.extent(0); ++p)
    host(p, 3) = 1.0 + strain;
  Kokkos::deep_copy(F, host);
  faces.sample(-2.8 * strain * cell);
  EXPECT_EQ(faces.warning(), "");
  faces.sample(-3.3 * strain * cell);
  EXPECT_NE(faces.warning(), "");
}
