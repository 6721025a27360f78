#pragma once
/// A plate in which a crack runs into another, whose front the test drives.

#include "packages/propagation/DrivenFronts.hpp"
#include "src/step/ElasticBox.hpp"
#include "state/EnergySums.hpp"

#include <string>
#include <vector>

namespace Rhegma::Test
{

using Reals = Teuchos::Array<double>;
inline Reals reals(const std::vector<double>& values) { return Reals(values.begin(), values.end()); }

constexpr double cell = 1e-3, size = 40e-3, pull = 2e6, speed = 400.0;
constexpr double roof = 20.3e-3, wall = 15.3e-3; ///< heights and positions of the two cracks, off the nodes

inline void addLoad(Teuchos::ParameterList& scene, const std::string& name, const std::vector<double>& from,
                    const std::vector<double>& to, const std::vector<double>& stress)
{
  Teuchos::ParameterList& load = scene.sublist("Boundaries").sublist(name);
  load.set("Type", std::string("Traction"));
  load.set("Body", std::string("Plate"));
  load.set("From", reals(from));
  load.set("To", reals(to));
  load.set("Stress", reals(stress));
}

/// A free plate with cracks that run by a toughness of 1 + v / 100 J/m2.
template <class Cut>
Teuchos::ParameterList plate(const Cut& cut, double increment = 1.0)
{
  Teuchos::ParameterList scene = elasticBox<2>(all<2>(0.0), all<2>(size), cell, 4.0, {}, "Plate", "Stress");
  cut(scene);
  scene = validated(scene);
  // Nothing measures what drives the front: the test says it.
  Teuchos::ParameterList& propagation = scene.sublist("Propagation");
  propagation.set("Toughness", std::string("1 + v/100"));
  propagation.set("Direction", std::string("Straight"));
  propagation.set("Increment", increment);
  propagation.set("Start Time", 0.0);
  propagation.set("Release Contour", reals({5.0, 10.0}));
  propagation.set("Direction Contour", reals({3.0, 6.0}));
  return scene;
}

/// Roof goes from the left edge to beyond the middle; Wall begins below and runs up to Roof, under which the
/// plate is pulled apart sideways.
inline void cutACorner(Teuchos::ParameterList& scene)
{
  addLoad(scene, "Left", {0.0, 20.0 * cell}, {0.0, 0.0}, {-pull, 0.0});
  addLoad(scene, "Right", {size, 0.0}, {size, 20.0 * cell}, {pull, 0.0});
  Teuchos::ParameterList& cracks = scene.sublist("Cracks");
  cracks.sublist("Roof").set("Points", reals({0.0, roof, 30e-3, roof}));
  cracks.sublist("Wall").set("Points", reals({wall, 0.0, wall, 10e-3}));
}

/// Two cracks in one line, from the left and the right edge, across which the plate is pulled.
inline void cutInTwo(Teuchos::ParameterList& scene)
{
  addLoad(scene, "Top", {size, size}, {0.0, size}, {0.0, pull});
  addLoad(scene, "Bottom", {0.0, 0.0}, {size, 0.0}, {0.0, -pull});
  Teuchos::ParameterList& cracks = scene.sublist("Cracks");
  cracks.sublist("Roof").set("Points", reals({0.0, roof, 15e-3, roof}));
  cracks.sublist("Wall").set("Points", reals({size, roof, 26.4e-3, roof}));
}

/// A run whose front of Wall has ended or stopped.
struct Piece
{
  Rhegma::Run<2> run;
  int front; ///< that of Wall
  double joined;
};

/// Runs until the front of Wall has ended or stopped.
template <class Cut>
Piece runWall(const Cut& cut, double increment = 1.0)
{
  Piece piece{Rhegma::Run<2>(plate(cut, increment), drivenByTest<2>()), -1, -1.0};
  piece.run.initialize();
  State<2>& state = piece.run.state();
  for (std::size_t f = 0; f < state.cracks.fronts.size(); ++f)
    if (state.cracks.cracks[state.cracks.fronts[f].crack].name == "Wall")
      piece.front = static_cast<int>(f);
  measureEnergy(state);
  while (state.clock.time < 1e-4 && piece.joined < 0.0 && !state.cracks.fronts[piece.front].stopped())
  {
    state.cracks.fronts[piece.front].nodes[0].driving.release = 1.0 + speed / 100.0;
    piece.run.step(1.0, false);
    if (state.cracks.fronts[piece.front].ended)
      piece.joined = state.clock.time;
  }
  return piece;
}

} // namespace Rhegma::Test
