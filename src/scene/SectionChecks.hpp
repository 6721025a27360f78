#pragma once
/// Common parts of checks of sections: values of a list that may be incomplete, and checks that several
/// sections need.

#include "base/EntryValue.hpp"
#include "scene/ErrorIndex.hpp"

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterList.hpp>

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace Rhegma
{

/// Values of parameters that may be absent or of another type.
namespace SceneValues
{

using Reals = Teuchos::Array<double>;

std::optional<double> real(const Teuchos::ParameterList& list, const std::string& name);
std::optional<Reals> reals(const Teuchos::ParameterList& list, const std::string& name);
std::string text(const Teuchos::ParameterList& list, const std::string& name); ///< empty: absent
std::vector<std::string> sublists(const Teuchos::ParameterList& list);

} // namespace SceneValues

/// Checks one scene. Absent or invalid parameters are not checked.
class SectionChecks
{
public:
  SectionChecks(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors);

  const Teuchos::ParameterList& scene() const { return scene_; }
  std::vector<SceneError>& errors() const { return errors_; }
  int dimension() const { return dimension_; } ///< 0: unknown

  /// Calls check(list, path) for each sublist of a section.
  template <class Check>
  void forEach(const std::string& section, const Check& check)
  {
    if (!scene_.isSublist(section))
      return;
    for (const auto& entry : scene_.sublist(section))
      if (const auto* list = valueIf<Teuchos::ParameterList>(entry.second))
        check(*list, scenePath(section, entry.first));
  }

  void report(const std::string& where, const std::string& message);
  /// Reports a message that may start with a path.
  void report(const std::string& where, const std::invalid_argument& error);
  /// Whether no entry of the section has an error, except one parameter, so that the object can be made.
  bool isWhole(const std::string& where, const std::string& aside) const;
  /// Whether Lower Corner and Upper Corner are in order along every axis; reports an axis where they are not.
  bool corners(const Teuchos::ParameterList& list, const std::string& where, bool mayTouch);
  /// The parameter must be the name of a sublist of another section.
  void named(const Teuchos::ParameterList& list, const std::string& parameter, const std::string& section,
             const std::string& where);
  /// Two points must differ.
  void different(const Teuchos::ParameterList& list, const std::string& one, const std::string& other,
                 const std::string& where);
  /// History must be finite at any time of the run; evaluated only where the parser is cheap.
  void history(const Teuchos::ParameterList& list, const std::string& where);
  /// From and To, or Edge 1 and Edge 2, must span a part of the surface of Body.
  void surface(const Teuchos::ParameterList& list, const std::string& where);

private:
  void parallelogram(const Teuchos::ParameterList& list, const std::string& where);
  void alongSurface(const Teuchos::ParameterList& list, const std::string& where);

  const Teuchos::ParameterList& scene_;
  std::vector<SceneError>& errors_;
  ErrorIndex found_;
  int dimension_;
};

} // namespace Rhegma
