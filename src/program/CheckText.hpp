#pragma once
/// What --check says of a scene.

#include "Simulation.hpp"
#include "parallel/Ranks.hpp"
#include "program/Forecast.hpp"

#include <Teuchos_ParameterList.hpp>

#include <nlohmann/json.hpp>
#include <string>

namespace Rhegma::program
{

/// Bodies of which bodiesAsText has a line.
constexpr std::size_t bodiesInText = 10;

/// Masses and weights, by which a wrong unit shows: a line for each of the first bodies.
/// \param summary report of a simulation, with those bodies \param scene validated
std::string bodiesAsText(const nlohmann::json& summary, const Teuchos::ParameterList& scene);

/// Resultants of tractions and forces, each at the largest value of its history, in a Static analysis at the
/// last: a line for each of the first of them. \param scene validated
std::string loadsAsText(const Teuchos::ParameterList& scene);

/// Size of cells and number of particles, which Domain > Accuracy may have chosen.
std::string cellsAsText(const nlohmann::json& summary, long particles);

/// Size of the linear systems of an equilibrium; empty for other scenes.
std::string unknownsAsText(const nlohmann::json& summary);

/// Estimated number of steps, by the stable step of the initial state; of an equilibrium that of load steps.
/// \param scene validated
std::string stepsAsText(const Simulation& simulation, const Teuchos::ParameterList& scene);

/// A hint where a run would wait for a rest that Time > Analysis = Static solves for: the rules then refuse
/// nothing but the section that makes it rest. \param scene validated
std::string equilibriumAsText(const Teuchos::ParameterList& scene, const Ranks& ranks);

/// Of a scene that takes long to set up, a line with its end that says so: its estimated number of particles
/// and their memory. Empty for others. \param scene validated
std::string sizeAsText(const Teuchos::ParameterList& scene);

/// Particles beyond which a scene is large: setting them up takes a minute and more.
constexpr double manyParticles = 4e6;

} // namespace Rhegma::program
