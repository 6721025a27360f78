#pragma once
/// Shapes as a scene gives them.

#include <Teuchos_Array.hpp>
#include <Teuchos_ParameterList.hpp>

#include <initializer_list>
#include <string>

namespace ShapeLists
{

inline Teuchos::Array<double> numbers(std::initializer_list<double> values)
{
  return Teuchos::Array<double>(values);
}

/// A body's list with its shape only.
inline Teuchos::ParameterList body(const std::string& shape)
{
  Teuchos::ParameterList list("Rhegma->Bodies->Beam");
  list.set("Shape", shape);
  return list;
}

inline Teuchos::ParameterList box(std::initializer_list<double> lower, std::initializer_list<double> upper)
{
  Teuchos::ParameterList list = body("Box");
  list.set("Lower Corner", numbers(lower));
  list.set("Upper Corner", numbers(upper));
  return list;
}

inline Teuchos::ParameterList ball(std::initializer_list<double> centre, double radius)
{
  Teuchos::ParameterList list = body("Ball");
  list.set("Centre", numbers(centre));
  list.set("Radius", radius);
  return list;
}

inline Teuchos::ParameterList polygon(std::initializer_list<double> points)
{
  Teuchos::ParameterList list = body("Polygon");
  list.set("Points", numbers(points));
  return list;
}

} // namespace ShapeLists
