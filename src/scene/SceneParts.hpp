#pragma once
/// What effects see of a scene.

#include "scene/Schema.hpp"

#include <Teuchos_ParameterList.hpp>

#include <string>

namespace Rhegma
{

/// The core's sections of a scene, copied once, and next to them the section of one effect at a time.
class SceneParts
{
public:
  /// \param scene must outlive this
  SceneParts(const SceneSchema& schema, const Teuchos::ParameterList& scene) : schema_(schema), scene_(scene)
  {
  }

  /// The scene as an effect may see it, until the next call. \param effect name of a section of the scene
  const Teuchos::ParameterList& of(const std::string& effect)
  {
    if (!effect_.empty())
      part_.remove(effect_);
    else
      for (auto entry = scene_.begin(); entry != scene_.end(); ++entry)
        if (schema_.effects().count(scene_.name(entry)) == 0)
          part_.setEntry(scene_.name(entry), scene_.entry(entry));
    effect_ = effect;
    part_.setEntry(effect, scene_.getEntry(effect));
    return part_;
  }

private:
  const SceneSchema& schema_;
  const Teuchos::ParameterList& scene_;
  Teuchos::ParameterList part_;
  std::string effect_;
};

} // namespace Rhegma
