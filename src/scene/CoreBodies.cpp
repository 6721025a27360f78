#include "scene/CoreBodies.hpp"

namespace Rhegma
{

namespace
{

void rotation(Section& s)
{
  s.real("Rotation").unit("degrees").byDefault(0.0).meaning("Turns the shape, against the clock in 2D.");
  s.realArray("Rotation Centre")
      .unit("m")
      .perAxis()
      .optional("the middle of the shape's bounding box")
      .meaning("The point that stays where it is.");
  s.realArray("Rotation Axis")
      .onlyIn(3)
      .length(3)
      .byDefault({0.0, 0.0, 1.0})
      .meaning("Direction of the axis, right-handed; of any length but zero.");
}

Section box()
{
  Section s("Box", "A rectangle or a cuboid along the axes.");
  s.realArray("Lower Corner").unit("m").perAxis().meaning("The corner with the smallest coordinates.");
  s.realArray("Upper Corner").unit("m").perAxis().meaning("The corner with the largest coordinates.");
  return s;
}

Section ball()
{
  Section s("Ball", "A disk or a ball.");
  s.realArray("Centre").unit("m").perAxis().meaning("Its middle.");
  s.real("Radius").unit("m").positive().meaning("Its radius.");
  return s;
}

Section cylinder()
{
  Section s("Cylinder", "A circular cylinder; in 2D use Ball.");
  s.onlyIn(3);
  s.realArray("From").unit("m").length(3).meaning("Middle of one end.");
  s.realArray("To").unit("m").length(3).meaning("Middle of the other end.");
  s.real("Radius").unit("m").positive().meaning("Its radius.");
  return s;
}

Section polygon()
{
  Section s("Polygon", "A simple polygon; in 3D a prism along z over it.");
  s.realArray("Points").unit("m").multipleOf(2, 6).meaning(
      "Its corners x0, y0, x1, y1, ... in turn, the first not repeated.");
  s.real("Bottom").unit("m").onlyIn(3).meaning("z of the prism's lower end.");
  s.real("Top").unit("m").onlyIn(3).meaning("z of the prism's upper end.");
  return s;
}

void shapes(Section& s)
{
  s.chosenBy("Shape").meaning("What it looks like before it is turned.");
  s.variant(box());
  s.variant(ball());
  s.variant(cylinder());
  s.variant(polygon());
}

Section operations()
{
  Section operation("operation", "One shape that is added to the body or cut from it.");
  operation.choice("Operation", {"Add", "Cut"}).meaning("Whether the shape is added or cut away.");
  shapes(operation);
  rotation(operation);

  Section s("Operations",
            "Changes of the body's shape, in the order of the file; the body's own rotation turns the "
            "first shape alone.");
  s.namedByUser(operation);
  return s;
}

} // namespace

Section bodies()
{
  Section body("body", "One body: its shape, its material and how it starts.");
  body.text("Material").notEmpty().meaning("The name of one of the Materials.");
  shapes(body);
  rotation(body);
  body.integer("Particles Per Cell").range(1, 8).byDefault(2).meaning("Particles along each axis of a cell.");
  body.real("Temperature")
      .unit("K")
      .positive()
      .optional("Thermal > Initial Temperature")
      .meaning("With Thermal: at the start.");
  body.text("Temperature Field")
      .unit("K")
      .notEmpty()
      .optional()
      .meaning(
          "With Thermal: at the start, as an expression of the place x, y, z, such as \"300 + 1e4 * x\".");
  body.realArray("Velocity")
      .unit("m/s")
      .perAxis()
      .byDefaultZeros()
      .meaning("Of the centre of mass at the start.");
  body.realArray("Angular Velocity")
      .unit("rad/s")
      .perRotationAxis()
      .byDefaultZeros()
      .meaning("About the centre of mass at the start.");
  body.atMostOneOf({"Temperature", "Temperature Field"});
  body.subsection(operations());

  Section s("Bodies", "The solids.");
  s.require();
  s.namedByUser(body);
  return s;
}

} // namespace Rhegma
