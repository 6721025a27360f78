#include "CubeScene.hpp"

#include "cracks/CrackGrowth.hpp"
#include "cracks/CracksOnPath.hpp"
#include "cracks/EndLigaments.hpp"

#include <initializer_list>

using namespace Rhegma;
using namespace Rhegma::cracks;
using namespace Rhegma::cracks::test;

namespace
{

constexpr double line = 5.2; ///< the height of the crack [cells]

/// A rectangle [cells].
struct Piece
{
  double left, bottom, right, top;
};

/// A strip of 20 x 10 cells of these pieces, and a crack from its left edge on.
std::unique_ptr<Run<2>> strip(std::initializer_list<Piece> pieces, double front)
{
  Teuchos::ParameterList scene = blockScene({20.0 * cell, 10.0 * cell});
  scene.remove("Bodies");
  int number = 0;
  for (const Piece& piece : pieces)
  {
    Teuchos::ParameterList& body = scene.sublist("Bodies").sublist("Piece " + std::to_string(number++));
    body.set("Material", std::string("Solid"));
    body.set("Shape", std::string("Box"));
    body.set("Lower Corner", numbers({piece.left * cell, piece.bottom * cell}));
    body.set("Upper Corner", numbers({piece.right * cell, piece.top * cell}));
  }
  setCrack(scene, {0.0, line * cell, (front - 1.0) * cell, line * cell, front * cell, line * cell});
  return start<2>(scene);
}

void advance(State<2>& state, double length)
{
  FrontAdvance<2> asked;
  asked.nodes = {{state.cracks.fronts[0].direction, length, 100.0}};
  state.cracks.advances.push_back(asked);
  CrackGrowth<2> growth;
  growth.grow(state);
}

/// Lets the front run a cell at a time until it ends.
/// \return where [cells]
double endOf(State<2>& state)
{
  for (int k = 0; k < 30 && !state.cracks.fronts[0].ended; ++k)
    advance(state, cell);
  EXPECT_TRUE(state.cracks.fronts[0].ended);
  return state.cracks.fronts[0].position[0] / cell;
}

// Particles are half a cell wide, so the positions that they fill reach 0.55 x 0.71 cells from their centres,
// which lie a quarter of a cell behind the edge; positions are up to 2 / 48 cells apart.
constexpr double beyond = 0.55 * 0.7072 - 0.25, step = 2.0 / 48;

} // namespace

/// A hole of one cell across the path is a surface, whatever part of an advance it lies in.
TEST(LigamentAhead, EndsAtASmallHole)
{
  for (const double front : {6.0, 6.25, 6.5, 6.75})
  {
    const auto run = strip({{0, 0, 10, 10}, {11, 0, 20, 10}, {10, 0, 11, 5}, {10, 6, 11, 10}}, front);
    const double end = endOf(run->state());
    EXPECT_GE(end, 10.0 - step) << front;
    EXPECT_LE(end, 10.0 + beyond) << front;
  }
}

/// So is the edge of a body with another one half a cell further on.
TEST(LigamentAhead, EndsAtTheGapToAnotherBody)
{
  for (const double front : {6.0, 6.25, 6.5, 6.75})
  {
    const auto run = strip({{0, 0, 10, 10}, {10.5, 0, 20, 10}}, front);
    const double end = endOf(run->state());
    EXPECT_GE(end, 10.0 - step) << front;
    EXPECT_LE(end, 10.0 + beyond) << front;
  }
}

/// Particles of one body that have been drawn apart by less than half a cell leave no surface.
TEST(LigamentAhead, PassesBetweenStretchedParticles)
{
  const auto run = strip({{0, 0, 20, 10}}, 6.1);
  State<2>& state = run->state();
  // Positions are filled up to 0.139 cells beyond the edges of particles.
  const auto x = state.particles.real<2>(fields::position);
  const auto host = onHost(x);
  for (int p = 0; p < state.particles.size(); ++p)
    if (host(p, 0) > 6.5 * cell)
      host(p, 0) += (2.0 * beyond + 0.25) * cell;
  Kokkos::deep_copy(x, host);
  advance(state, cell);
  EXPECT_FALSE(state.cracks.fronts[0].ended);
  EXPECT_NEAR(state.cracks.fronts[0].position[0], 7.1 * cell, 1e-12);
}

/// A gap right at a front that is as wide as the opening belongs to the crack: here 0.9 cells less what the
/// particle beyond fills. A crack that is closed has no such opening and ends.
TEST(LigamentAhead, PassesOverTheOpeningOfItsCrack)
{
  for (const bool open : {false, true})
  {
    const auto run = strip({{0, 0, 20, 10}}, 6.6);
    State<2>& state = run->state();
    ASSERT_EQ(state.cracks.fronts.size(), 1u);
    // Particles near the line draw back from it by three quarters of a cell, as far as 0.9 cells beyond the
    // front.
    const auto x = state.particles.real<2>(fields::position);
    const auto host = onHost(x);
    for (int p = 0; p < state.particles.size(); ++p)
      if (host(p, 0) < 7.5 * cell && std::fabs(host(p, 1) - line * cell) < cell)
        host(p, 1) += (host(p, 1) > line * cell ? 0.75 : -0.75) * cell;
    Kokkos::deep_copy(x, host);
    const auto face = onHost(state.cracks.face);
    for (std::size_t v = 0; open && v < face.extent(0); ++v)
      if (static_cast<int>(v) != state.cracks.fronts[0].vertex)
      {
        face(v, 0, 1) -= 0.5 * cell;
        face(v, 1, 1) += 0.5 * cell;
      }
    Kokkos::deep_copy(state.cracks.face, face);
    advance(state, cell);
    EXPECT_EQ(state.cracks.fronts[0].ended, !open);
    EXPECT_NEAR(state.cracks.fronts[0].position[0], (open ? 7.6 : 6.6) * cell, 1e-12);
  }
}

/// What is left ahead of a front that has grown is said, also of an open crack, and twice as much where a
/// plane of symmetry ends it; and warned of below ten cells, in other words below three.
TEST(LigamentAhead, IsSaidAtTheEnd)
{
  for (const double front : {6.2, 10.7, 13.3, 15.4, 15.8, 16.3, 17.2})
    for (const bool open : {false, true})
      for (const bool mirrored : {false, true})
      {
        const auto run = strip({{0, 0, 20, 10}}, front);
        State<2>& state = run->state();
        advance(state, cell);
        state.clock.step = 1;
        if (open)
        {
          // The crack is open by a cell, as far as half a cell ahead of its front.
          const auto x = state.particles.real<2>(fields::position);
          const auto host = onHost(x);
          for (int p = 0; p < state.particles.size(); ++p)
            if (host(p, 0) < (front + 1.5) * cell)
              host(p, 1) += (host(p, 1) > line * cell ? 0.5 : -0.5) * cell;
          Kokkos::deep_copy(x, host);
          const auto face = onHost(state.cracks.face);
          for (std::size_t v = 0; v < face.extent(0); ++v)
            if (static_cast<int>(v) != state.cracks.fronts[0].vertex)
            {
              face(v, 0, 1) -= 0.5 * cell;
              face(v, 1, 1) += 0.5 * cell;
            }
          Kokkos::deep_copy(state.cracks.face, face);
        }
        std::vector<MirrorPlane> mirrors;
        if (mirrored)
          mirrors.push_back({0, 20.0 * cell});
        const double left = (mirrored ? 2.0 : 1.0) * (19.0 - front);
        nlohmann::json summary = {{"warnings", nlohmann::json::array()}};
        reportLigaments(state, mirrors, summary);
        const nlohmann::json& ligament = summary["cracks"][0]["fronts"][0]["ligament"];
        ASSERT_TRUE(ligament.is_number()) << front << " " << open << " " << mirrored;
        EXPECT_NEAR(ligament.get<double>(), left * cell, 0.4 * cell) << front;
        ASSERT_EQ(summary["warnings"].size(), left < 10.0 ? 1u : 0u) << front;
        if (left >= 10.0)
          continue;
        const auto text = summary["warnings"][0].get<std::string>();
        EXPECT_NE(text.find("of material are left ahead of it"), std::string::npos) << text;
        EXPECT_EQ(text.find("fewer than three cells") != std::string::npos, left < 3.0) << text;
      }
}

/// A crack across the path, at any angle, or straight ahead ends the ligament before the surface does; one
/// next to it does not.
TEST(LigamentAhead, EndsAtAnotherCrack)
{
  Draws draw;
  for (const char* kind : {"across", "ahead", "aside"})
  {
    const double front = draw(3.0, 5.0), at = draw(10.0, 14.0), angle = draw(0.7, 2.4);
    const Vector<2> along{std::cos(angle), std::sin(angle)};
    Teuchos::ParameterList scene = blockScene({20.0 * cell, 10.0 * cell});
    setCrack(scene, {0.0, line * cell, (front - 1.0) * cell, line * cell, front * cell, line * cell});
    const bool across = kind == std::string("across");
    const double height = kind == std::string("aside") ? line + 2.0 : line;
    scene.sublist("Cracks").sublist("Other").set(
        "Points", across ? numbers({(at - 3.0 * along[0]) * cell, (line - 3.0 * along[1]) * cell,
                                    (at + 3.0 * along[0]) * cell, (line + 3.0 * along[1]) * cell})
                         : numbers({at * cell, height * cell, (at + 4.0) * cell, height * cell}));
    const auto run = start<2>(scene);
    State<2>& state = run->state();
    advance(state, cell);
    state.clock.step = 1;
    nlohmann::json summary = {{"warnings", nlohmann::json::array()}};
    reportLigaments(state, {}, summary);
    const nlohmann::json& entry = summary["cracks"][0]["fronts"][0];
    const bool aside = kind == std::string("aside");
    // Up to a crack exact to the tenth of a cell within which it is met, less far where the path is oblique
    // to it; up to a surface to 0.4 cells, as above.
    EXPECT_NEAR(entry.at("ligament").get<double>() / cell, (aside ? 20.0 : at) - front - 1.0,
                aside ? 0.4 : 0.1)
        << kind << " " << angle;
    EXPECT_EQ(entry.at("ligament_ends_at").get<std::string>(), aside ? "surface" : "crack Other") << kind;
  }
}

/// In 3D, from any point in any direction to a square across it: the length up to its plane, or none.
TEST(LigamentAhead, FindsTheFirstCrackIn3D)
{
  Draws draw;
  Teuchos::ParameterList scene = blockScene({8.0 * cell, 8.0 * cell, 8.0 * cell});
  setCrack(scene, {0.0, 0.0, 2.0 * cell, 3.0 * cell, 0.0, 2.0 * cell, 3.0 * cell, 8.0 * cell, 2.0 * cell, 0.0,
                   8.0 * cell, 2.0 * cell});
  scene.sublist("Cracks").sublist("Other").set(
      "Points", numbers({6.0 * cell, 0.0, 4.5 * cell, 6.0 * cell, 8.0 * cell, 4.5 * cell, 6.0 * cell,
                         8.0 * cell, 7.0 * cell, 6.0 * cell, 0.0, 7.0 * cell}));
  const auto run = start<3>(scene);
  const CracksOnPath<3> others(run->state().cracks, 0);
  constexpr double near = 1e-3 * cell;
  for (int k = 0; k < 20; ++k)
  {
    const Vector<3> from{draw(0.0, 5.0) * cell, draw(1.0, 7.0) * cell, draw(1.0, 7.0) * cell};
    const Vector<3> to{6.0 * cell, draw(1.0, 7.0) * cell, draw(2.0, 7.0) * cell};
    const double length = norm(to - from);
    const CrackOnPath found = others.first(from, (1.0 / length) * (to - from), 1.5 * length, near);
    if (to[2] > 4.5 * cell)
    {
      EXPECT_EQ(found.crack, 1);
      // Met at the distance `near` from its plane, which is longer along an oblique path.
      const double cosine = (to[0] - from[0]) / length;
      EXPECT_NEAR(found.length, length, near * (1.0 / cosine - 1.0) + 1e-9 * cell);
    }
    else if (to[2] < 4.4 * cell)
    {
      EXPECT_EQ(found.crack, -1);
      EXPECT_EQ(found.length, 1.5 * length);
    }
  }
}
