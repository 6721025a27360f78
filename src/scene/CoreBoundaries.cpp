#include "scene/CoreBoundaries.hpp"

namespace Rhegma
{

namespace
{

void history(Section& s)
{
  s.timeFunction("History").byDefault("1").meaning(
      "Factor on the value as a function of time: an expression of t or a table \"0:0, 1e-3:5\".");
}

void loadedBody(Section& s) { s.text("Body").notEmpty().meaning("Name of the loaded body."); }

Section velocity()
{
  Section s("Velocity", "Prescribes the velocity of all grid nodes in a box.");
  s.realArray("Lower Corner").unit("m").perAxis().meaning("Corner of the box with the smallest coordinates.");
  s.realArray("Upper Corner").unit("m").perAxis().meaning("Corner of the box with the largest coordinates.");
  s.text("Components")
      .byDefault("xy", "xyz")
      .meaning("Axes along which the velocity is prescribed, such as \"y\" or \"xy\". Other axes are free.");
  s.choice("Nodes", {"Inside", "Outside"})
      .byDefault("Inside")
      .meaning("Which nodes are prescribed: those inside the box or those outside it. Nodes on the edge of "
               "the box belong to both.");
  s.realArray("Value").unit("m/s").perAxis().optional().meaning(
      "The velocity, the same at all nodes. Axes that are not in Components are ignored.");
  s.text("Field").unit("m/s").notEmpty().optional().meaning(
      "The velocity as a function of the nodal position x, y, z: one expression for each axis, such as "
      "\"2*x, -y\". Common terms are defined first, as in \"r = sqrt(x*x + y*y); x / r, y / r\".");
  s.exactlyOneOf({"Value", "Field"});
  history(s);
  return s;
}

Section symmetry()
{
  Section s("Symmetry", "A plane of symmetry: zero normal velocity, free sliding along the plane.");
  s.choice("Axis", {"x", "y", "z"}).meaning("Axis normal to the plane.");
  s.real("Position").unit("m").meaning("Coordinate of the plane on that axis.");
  s.choice("Side", {"Lower", "Upper"})
      .optional("the side of the nearer end of the domain")
      .meaning("Side of the plane that is the mirror image and holds no material.");
  return s;
}

Section pointLoad()
{
  Section s("Point Load", "A force at a material point of a body. The force moves with this point.");
  loadedBody(s);
  s.realArray("Point").unit("m").perAxis().meaning("Position of the loaded point in the undeformed body.");
  s.realArray("Force").unit("N").perAxis().meaning("The force vector.");
  history(s);
  return s;
}

Section lineLoad()
{
  Section s("Line Load", "A force distributed over a straight line in a body. It moves with the body.");
  loadedBody(s);
  s.realArray("From").unit("m").perAxis().meaning("One end of the line, in the undeformed body.");
  s.realArray("To").unit("m").perAxis().meaning("Other end of the line.");
  s.realArray("Force").unit("N").perAxis().meaning("Total force on the line.");
  s.choice("Profile", {"Uniform", "Parabolic"})
      .byDefault("Uniform")
      .meaning("Distribution along the line: uniform, or a parabola that is zero at both ends.");
  history(s);
  return s;
}

Section traction()
{
  Section s("Traction", "A force per undeformed area on a part of a body's surface: a line (2D) or a "
                        "parallelogram (3D) of the undeformed body. It moves with the body.");
  loadedBody(s);
  s.realArray("From").unit("m").onlyIn(2).length(2).meaning("One end of the line, in the undeformed body.");
  s.realArray("To").unit("m").onlyIn(2).length(2).meaning(
      "Other end of the line. The body lies to the left of the direction from From to To.");
  s.realArray("Corner").unit("m").onlyIn(3).length(3).meaning(
      "One corner of the parallelogram, in the undeformed body.");
  s.realArray("Edge 1").unit("m").onlyIn(3).length(3).meaning("Vector of its first edge from Corner.");
  s.realArray("Edge 2").unit("m").onlyIn(3).length(3).meaning(
      "Vector of its second edge from Corner. Edge 1 x Edge 2 must point out of the body.");
  s.realArray("Stress").unit("Pa").perAxis().optional().meaning(
      "Force vector per undeformed area, in a fixed direction.");
  s.real("Pressure")
      .unit("Pa")
      .optional()
      .meaning("Pressure normal to the undeformed surface; positive values push into the body.");
  s.exactlyOneOf({"Stress", "Pressure"});
  history(s);
  return s;
}

/// A line (2D) or a parallelogram (3D) on a body.
void surface(Section& s)
{
  s.text("Body").notEmpty().meaning("Name of the body.");
  s.realArray("From").unit("m").onlyIn(2).length(2).meaning("One end of a line on the undeformed surface.");
  s.realArray("To").unit("m").onlyIn(2).length(2).meaning("Other end of the line.");
  s.realArray("Corner").unit("m").onlyIn(3).length(3).meaning(
      "One corner of a parallelogram on the undeformed surface.");
  s.realArray("Edge 1").unit("m").onlyIn(3).length(3).meaning("Vector of its first edge from Corner.");
  s.realArray("Edge 2").unit("m").onlyIn(3).length(3).meaning("Vector of its second edge from Corner.");
}

Section temperature()
{
  Section s("Temperature",
            "Prescribes the temperature of all grid nodes in a box. Needs the section Thermal.");
  s.realArray("Lower Corner").unit("m").perAxis().meaning("Corner of the box with the smallest coordinates.");
  s.realArray("Upper Corner").unit("m").perAxis().meaning("Corner of the box with the largest coordinates.");
  s.real("Temperature").unit("K").positive().meaning("The prescribed temperature.");
  history(s);
  return s;
}

Section heatFlux()
{
  Section s("Heat Flux", "Heat flux into a part of a body's surface. Needs the section Thermal.");
  surface(s);
  s.real("Flux").unit("W/m2").meaning("Heat flux into the body per undeformed area.");
  history(s);
  return s;
}

Section convection()
{
  Section s("Convection", "Convective heat exchange of a part of a body's surface with its surroundings. "
                          "Needs the section Thermal.");
  surface(s);
  s.real("Coefficient")
      .unit("W/(m2 K)")
      .positive()
      .meaning("Heat transfer coefficient: heat flux per temperature difference.");
  s.real("Ambient Temperature")
      .unit("K")
      .positive()
      .meaning("Temperature of the surroundings; History multiplies it.");
  history(s);
  return s;
}

Section gravity()
{
  Section s("Gravity", "A uniform body force on all mass.");
  s.realArray("Acceleration").unit("m/s2").perAxis().meaning("Acceleration of gravity: the force per mass.");
  history(s);
  return s;
}

} // namespace

Section boundaries()
{
  Section boundary("boundary", "A load or a support.");
  boundary.chosenBy("Type").meaning("Kind of load or support.");
  boundary.variant(velocity());
  boundary.variant(symmetry());
  boundary.variant(pointLoad());
  boundary.variant(lineLoad());
  boundary.variant(traction());
  boundary.variant(gravity());
  boundary.variant(temperature());
  boundary.variant(heatFlux());
  boundary.variant(convection());

  Section s("Boundaries", "Loads and supports.");
  s.namedByUser(boundary);
  return s;
}

} // namespace Rhegma
