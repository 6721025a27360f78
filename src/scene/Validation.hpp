#pragma once
/// Validation of a list against its section.

#include "scene/ErrorIndex.hpp"
#include "scene/Schema.hpp"

#include <Teuchos_ParameterList.hpp>

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace Rhegma
{

/// A section as one list sees it: its own parameters and subsections and those of the variant that the list
/// chose.
struct ActiveSection
{
  std::vector<const Parameter*> parameters;
  std::vector<const Section*> sections;
  std::vector<const Together*> together;
  const Section* entry = nullptr;
  const Section* variant = nullptr; ///< the one that the list chose
  bool variantKnown = true;         ///< false where the section has variants and the list chose none of them

  ActiveSection(const Section& section, const Teuchos::ParameterList& list);
  /// \param chosen variant, or a text that is no name of one
  ActiveSection(const Section& section, const std::string& chosen);

  const Parameter* findParameter(const std::string& name) const;
  const Section* findSection(const std::string& name) const;
  /// The names that can stand in the list.
  std::vector<std::string> parameterNames(int dimension) const;
  std::vector<std::string> sectionNames() const;
};

/// Active sections, made once for all lists of a kind: they see their section in the same way.
class ActiveSections
{
public:
  const ActiveSection& of(const Section& section, const Teuchos::ParameterList& list);

private:
  std::map<std::pair<const Section*, std::string>, ActiveSection> made_; ///< by section and chosen variant
};

/// The scene's dimension, or 0 if it is not given.
int dimensionOf(const Teuchos::ParameterList& scene);

/// Walks through a list and its section together. Invalid entries are reported and removed from the list, so
/// that later checks see valid entries only; defaults are filled in.
class Validation
{
public:
  Validation(int dimension, std::vector<SceneError>& errors)
      : m_dimension(dimension), m_errors(errors), m_found(errors)
  {
  }

  void check(Teuchos::ParameterList& list, const Section& section, const std::string& path);

private:
  void checkEntry(Teuchos::ParameterList& list, const std::string& name, Teuchos::ParameterEntry& entry,
                  const Section& section, const ActiveSection& active, const std::string& path);
  void unknownSection(const std::string& name, const Section& section, const ActiveSection& active,
                      const std::string& path);
  void checkParameter(Teuchos::ParameterList& list, const Parameter& parameter, const std::string& path);
  void unknownParameter(const std::string& name, const Section& section, const ActiveSection& active,
                        const std::string& path);
  void checkDimension(const Section& section, const ActiveSection& active, const std::string& path);
  void fillIn(Teuchos::ParameterList& list, const ActiveSection& active, const std::string& path);
  void missing(const Parameter& parameter, const std::string& path);
  void checkTogether(const Teuchos::ParameterList& list, const Together& rule, const std::string& path);

  void report(const std::string& where, const std::string& message) { m_errors.push_back({where, message}); }
  /// Whether this path has an error already, or an unknown name was interpreted as this one.
  bool mentioned(const std::string& where) const;

  int m_dimension;
  std::vector<SceneError>& m_errors;
  ErrorIndex m_found;
  std::set<std::string> m_meant; ///< positions of which a misspelt name was given
  ActiveSections m_active;
};

} // namespace Rhegma
