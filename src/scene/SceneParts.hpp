#pragma once
/// What effects see of a scene.

#include "scene/Schema.hpp"

#include <Teuchos_ParameterList.hpp>

#include <string>
#include <vector>

namespace Rhegma
{

/// The core's sections of a scene, and next to them the section of one effect at a time. No section is
/// copied, however large it is: as long as this exists, those that `of` shows are empty in the scene itself.
class SceneParts
{
public:
  /// \param scene must outlive this, and is as it was afterwards
  SceneParts(const SceneSchema& schema, Teuchos::ParameterList& scene) : schema_(schema), scene_(scene) {}
  ~SceneParts()
  {
    for (const std::string& section : shown_)
      exchange(section);
  }
  SceneParts(const SceneParts&) = delete;
  SceneParts& operator=(const SceneParts&) = delete;

  /// The scene as an effect may see it, until the next call. \param effect name of a section of the scene
  const Teuchos::ParameterList& of(const std::string& effect)
  {
    if (!effect_.empty())
    {
      exchange(effect_);
      shown_.pop_back();
      part_.remove(effect_);
    }
    else
      showCore();
    effect_ = effect;
    show(effect);
    return part_;
  }

private:
  void showCore()
  {
    for (auto entry = scene_.begin(); entry != scene_.end(); ++entry)
    {
      const std::string& name = scene_.name(entry);
      if (schema_.effects().count(name) > 0)
        continue;
      if (scene_.isSublist(name))
        show(name);
      else
        part_.setEntry(name, scene_.entry(entry));
    }
  }

  void show(const std::string& section)
  {
    part_.sublist(section);
    shown_.push_back(section);
    exchange(section);
  }

  void exchange(const std::string& section)
  {
    part_.getEntry(section).getAny(false).swap(scene_.getEntry(section).getAny(false));
  }

  const SceneSchema& schema_;
  Teuchos::ParameterList& scene_;
  Teuchos::ParameterList part_;
  std::vector<std::string> shown_; ///< the effect's last
  std::string effect_;
};

} // namespace Rhegma
