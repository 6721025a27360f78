#pragma once
/// A valid scene and functions to make it invalid.

#include "plan/EffectSchema.hpp"
#include "scene/Scene.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace Rhegma
{
namespace SceneTests
{

/// A square of steel that is pulled at its right edge.
inline std::string goodScene()
{
  return R"xml(<ParameterList name="Rhegma">
  <ParameterList name="Domain">
    <Parameter name="Dimension" type="int" value="2"/>
    <Parameter name="Lower Corner" type="Array(double)" value="{0.0, 0.0}"/>
    <Parameter name="Upper Corner" type="Array(double)" value="{4.0, 4.0}"/>
    <Parameter name="Cell Size" type="double" value="0.5"/>
  </ParameterList>
  <ParameterList name="Time">
    <Parameter name="Final Time" type="double" value="1e-3"/>
  </ParameterList>
  <ParameterList name="Materials">
    <ParameterList name="Steel">
      <Parameter name="Model" type="string" value="Linear Elastic"/>
      <Parameter name="Density" type="double" value="7800"/>
      <Parameter name="Young Modulus" type="double" value="2.1e11"/>
      <Parameter name="Poisson Ratio" type="double" value="0.3"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Bodies">
    <ParameterList name="Plate">
      <Parameter name="Material" type="string" value="Steel"/>
      <Parameter name="Shape" type="string" value="Box"/>
      <Parameter name="Lower Corner" type="Array(double)" value="{1.0, 1.0}"/>
      <Parameter name="Upper Corner" type="Array(double)" value="{3.0, 3.0}"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Boundaries">
    <ParameterList name="Pull">
      <Parameter name="Type" type="string" value="Traction"/>
      <Parameter name="Body" type="string" value="Plate"/>
      <Parameter name="From" type="Array(double)" value="{3.0, 1.0}"/>
      <Parameter name="To" type="Array(double)" value="{3.0, 3.0}"/>
      <Parameter name="Stress" type="Array(double)" value="{1e6, 0.0}"/>
    </ParameterList>
  </ParameterList>
</ParameterList>
)xml";
}

/// The right scene with one piece of its text replaced; the piece must be there.
inline std::string changed(const std::string& piece, const std::string& by)
{
  std::string scene = goodScene();
  const auto at = scene.find(piece);
  EXPECT_NE(at, std::string::npos) << "not in the scene: " << piece;
  return at == std::string::npos ? scene : scene.replace(at, piece.size(), by);
}

inline std::string parameter(const std::string& name, const std::string& type, const std::string& value)
{
  return "<Parameter name=\"" + name + "\" type=\"" + type + "\" value=\"" + value + "\"/>";
}

/// The right scene with one parameter or section more at the end of a section; `opening` is the section's
/// first tag.
inline std::string with(const std::string& section, const std::string& more)
{
  const std::string opening = "<ParameterList name=\"" + section + "\">";
  return changed(opening, opening + more);
}

inline SceneSchema coreSchema() { return schemaOf({}); }

inline SceneResult read(const std::string& xml, const std::vector<std::string>& overrides = {})
{
  return readSceneText(xml, overrides, coreSchema());
}

inline std::string all(const std::vector<SceneError>& errors)
{
  std::string text;
  for (const auto& error : errors)
    text += toString(error) + "\n";
  return text;
}

/// Checks that the scene has exactly this error, whose message contains all of the pieces.
inline void expectOnly(const std::vector<SceneError>& errors, const std::string& where,
                       const std::vector<std::string>& pieces)
{
  ASSERT_EQ(errors.size(), 1u) << all(errors);
  EXPECT_EQ(errors[0].where, where) << all(errors);
  for (const auto& piece : pieces)
    EXPECT_NE(errors[0].message.find(piece), std::string::npos) << all(errors) << "lacks: " << piece;
}

} // namespace SceneTests
} // namespace Rhegma
