#pragma once
/// What a checkpoint holds in addition to the run: its samples, and the notes of the application.

#include "Simulation.hpp"
#include "archive/Archive.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace Rhegma
{

/// Saves or loads when the next sample is due, and the last one. \param next time of it [s]
inline void archiveSampling(double& next, Simulation::Row& last, Archive& archive)
{
  const Archive::Group group(archive, "sampling");
  archive("next", next);
  std::vector<std::string> names;
  std::vector<double> values;
  for (const auto& [name, value] : last)
  {
    names.push_back(name);
    values.push_back(value);
  }
  archive("names", names);
  archive("values", values);
  last.clear();
  for (std::size_t k = 0; k < std::min(names.size(), values.size()); ++k)
    last.emplace_back(names[k], values[k]);
}

/// Saves or loads the notes of an application.
inline void archiveNotes(Simulation::Notes& notes, Archive& archive)
{
  const Archive::Group group(archive, "notes");
  std::vector<std::string> names, texts;
  for (const auto& [name, text] : notes)
  {
    names.push_back(name);
    texts.push_back(text);
  }
  archive("names", names);
  archive("texts", texts);
  for (std::size_t k = 0; k < std::min(names.size(), texts.size()); ++k)
    notes[names[k]] = texts[k];
}

} // namespace Rhegma
