#include "scene/CoreBoundaries.hpp"

namespace Rhegma
{

namespace
{

void history(Section& s)
{
  s.timeFunction("History").byDefault("1").meaning(
      "Factor over time: an expression of t or a table \"0:0, 1e-3:5\".");
}

void loadedBody(Section& s) { s.text("Body").notEmpty().meaning("The name of the body that is loaded."); }

Section velocity()
{
  Section s("Velocity", "Prescribes the velocity of all nodes in a box.");
  s.realArray("Lower Corner")
      .unit("m")
      .perAxis()
      .meaning("The corner of the box with the smallest coordinates.");
  s.realArray("Upper Corner")
      .unit("m")
      .perAxis()
      .meaning("The corner of the box with the largest coordinates.");
  s.text("Components")
      .byDefault("xy", "xyz")
      .meaning("The axes along which it is prescribed, such as \"y\" or \"xy\".");
  s.choice("Nodes", {"Inside", "Outside"})
      .byDefault("Inside")
      .meaning(
          "Whether the nodes in the box are held, its rim included, or those beyond it, its rim included.");
  s.realArray("Value").unit("m/s").perAxis().optional().meaning(
      "The velocity, the same at all nodes; axes that are not in Components are left free.");
  s.text("Field").unit("m/s").notEmpty().optional().meaning(
      "The velocity as one expression of the node's place x, y, z for each axis, such as \"2*x, -y\"; names "
      "that "
      "they share are defined before, as in \"r = sqrt(x*x + y*y); x / r, y / r\".");
  s.exactlyOneOf({"Value", "Field"});
  history(s);
  return s;
}

Section symmetry()
{
  Section s("Symmetry",
            "A plane that material neither crosses nor leaves, and along which it slides freely.");
  s.choice("Axis", {"x", "y", "z"}).meaning("The axis at right angles to the plane.");
  s.real("Position").unit("m").meaning("Where the plane cuts the axis.");
  s.choice("Side", {"Lower", "Upper"})
      .optional("the side on which the nearer end of the domain lies")
      .meaning("The side of the plane that is the mirror image.");
  return s;
}

Section pointLoad()
{
  Section s("Point Load", "A force on the point of a body that is at Point at the start.");
  loadedBody(s);
  s.realArray("Point").unit("m").perAxis().meaning("Where it acts.");
  s.realArray("Force").unit("N").perAxis().meaning("The force.");
  history(s);
  return s;
}

Section lineLoad()
{
  Section s("Line Load", "A force spread over a straight line in a body.");
  loadedBody(s);
  s.realArray("From").unit("m").perAxis().meaning("One end of the line at the start.");
  s.realArray("To").unit("m").perAxis().meaning("Its other end.");
  s.realArray("Force").unit("N").perAxis().meaning("The whole force.");
  s.choice("Profile", {"Uniform", "Parabolic"})
      .byDefault("Uniform")
      .meaning("How it is spread: evenly, or as a parabola that is zero at both ends.");
  history(s);
  return s;
}

Section traction()
{
  Section s("Traction",
            "A force per area on the part of a body's surface that lies on a line (2D) or a parallelogram "
            "(3D) at the start.");
  loadedBody(s);
  s.realArray("From").unit("m").onlyIn(2).length(2).meaning("One end of the line.");
  s.realArray("To").unit("m").onlyIn(2).length(2).meaning(
      "Its other end; seen from From, the body is on the left.");
  s.realArray("Corner").unit("m").onlyIn(3).length(3).meaning("One corner of the parallelogram.");
  s.realArray("Edge 1").unit("m").onlyIn(3).length(3).meaning("Its first edge from there.");
  s.realArray("Edge 2").unit("m").onlyIn(3).length(3).meaning(
      "Its second edge from there; Edge 1 x Edge 2 points out of the body.");
  s.realArray("Stress").unit("Pa").perAxis().optional().meaning(
      "Force per undeformed area, in a fixed direction.");
  s.real("Pressure")
      .unit("Pa")
      .optional()
      .meaning("Pushes into the body, at right angles to the undeformed surface.");
  s.exactlyOneOf({"Stress", "Pressure"});
  history(s);
  return s;
}

/// A line (2D) or a parallelogram (3D) on a body.
void surface(Section& s)
{
  s.text("Body").notEmpty().meaning("The name of the body.");
  s.realArray("From").unit("m").onlyIn(2).length(2).meaning("One end of a line on its surface at the start.");
  s.realArray("To").unit("m").onlyIn(2).length(2).meaning("The line's other end.");
  s.realArray("Corner").unit("m").onlyIn(3).length(3).meaning(
      "One corner of a parallelogram on its surface at the start.");
  s.realArray("Edge 1").unit("m").onlyIn(3).length(3).meaning("Its first edge from there.");
  s.realArray("Edge 2").unit("m").onlyIn(3).length(3).meaning("Its second edge from there.");
}

Section temperature()
{
  Section s("Temperature", "Prescribes the temperature of all nodes in a box; needs Thermal.");
  s.realArray("Lower Corner")
      .unit("m")
      .perAxis()
      .meaning("The corner of the box with the smallest coordinates.");
  s.realArray("Upper Corner")
      .unit("m")
      .perAxis()
      .meaning("The corner of the box with the largest coordinates.");
  s.real("Temperature").unit("K").positive().meaning("The temperature.");
  history(s);
  return s;
}

Section heatFlux()
{
  Section s("Heat Flux", "Heat that flows into a part of a body's surface; needs Thermal.");
  surface(s);
  s.real("Flux").unit("W/m2").meaning("Into the body, per undeformed area.");
  history(s);
  return s;
}

Section convection()
{
  Section s("Convection",
            "Heat exchange of a part of a body's surface with its surroundings; needs Thermal.");
  surface(s);
  s.real("Coefficient").unit("W/(m2 K)").positive().meaning("Flux per difference of temperatures.");
  s.real("Ambient Temperature").unit("K").positive().meaning("Temperature of the surroundings.");
  history(s);
  return s;
}

Section gravity()
{
  Section s("Gravity", "A force on all mass.");
  s.realArray("Acceleration").unit("m/s2").perAxis().meaning("The force per mass.");
  history(s);
  return s;
}

} // namespace

Section boundaries()
{
  Section boundary("boundary", "One load or support.");
  boundary.chosenBy("Type").meaning("What kind of load or support it is.");
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
