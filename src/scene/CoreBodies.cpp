#include "scene/CoreBodies.hpp"

namespace Rhegma
{

namespace
{

void rotation(Section& s)
{
  s.real("Rotation")
      .unit("degrees")
      .byDefault(0.0)
      .meaning("Angle by which the shape is rotated; counter-clockwise in 2D.");
  s.realArray("Rotation Centre")
      .unit("m")
      .perAxis()
      .optional("the middle of the shape's bounding box")
      .meaning("Fixed point of the rotation.");
  s.realArray("Rotation Axis")
      .onlyIn(3)
      .length(3)
      .byDefault({0.0, 0.0, 1.0})
      .meaning("Direction of the rotation axis (right-hand rule). Any non-zero length.");
}

Section box()
{
  Section s("Box", "A rectangle (2D) or cuboid (3D) aligned with the axes.");
  s.realArray("Lower Corner").unit("m").perAxis().meaning("Corner of the box with the smallest coordinates.");
  s.realArray("Upper Corner").unit("m").perAxis().meaning("Corner of the box with the largest coordinates.");
  return s;
}

Section ball()
{
  Section s("Ball", "A disk (2D) or a ball (3D).");
  s.realArray("Centre").unit("m").perAxis().meaning("Its centre.");
  s.real("Radius").unit("m").positive().meaning("Its radius.");
  return s;
}

Section cylinder()
{
  Section s("Cylinder", "A circular cylinder; in 2D use Ball.");
  s.onlyIn(3);
  s.realArray("From").unit("m").length(3).meaning("Centre of one end face.");
  s.realArray("To").unit("m").length(3).meaning("Centre of the other end face.");
  s.real("Radius").unit("m").positive().meaning("Its radius.");
  return s;
}

Section polygon()
{
  Section s("Polygon", "A simple polygon; in 3D a prism along z with this cross section.");
  s.realArray("Points").unit("m").multipleOf(2, 6).meaning(
      "Corners x0, y0, x1, y1, ... in order around the outline. Do not repeat the first.");
  s.real("Bottom").unit("m").onlyIn(3).meaning("z of the lower end of the prism.");
  s.real("Top").unit("m").onlyIn(3).meaning("z of the upper end of the prism.");
  return s;
}

Section file()
{
  Section s("File", "A solid from a file: in 3D a closed surface of triangles (STL or OBJ), in 2D polygons.");
  s.text("File").notEmpty().meaning(
      "Path, relative to the scene. 3D: an STL file (ASCII or binary) or an OBJ file, by its extension. 2D: "
      "a text with two numbers x, y per line and an empty line between polygons; polygons inside others are "
      "holes.");
  s.real("Scale").unit("m").positive().optional("1").meaning(
      "Length of one unit of the file; 0.001 if the file is in millimetres.");
  s.realArray("Origin").unit("m").perAxis().byDefaultZeros().meaning(
      "Where the origin of the file's coordinates is, before the rotation.");
  return s;
}

Section voxels()
{
  Section s(
      "Voxels",
      "The voxels (pixels in 2D) of an image that have one value, such as a phase of a microstructure.");
  s.text("File").notEmpty().meaning("Path, relative to the scene, of a NumPy file (.npy), an array of "
                                    "integers in C order with the axes x and y, in 3D x, y and z; of a "
                                    "picture in shades of grey (.png, .tif), in 3D with several pages; or of "
                                    "a folder of such pictures, one above the other in the order of their "
                                    "names. Several bodies may use one file.");
  s.integer("Value").meaning("Value of the voxels of this body.");
  s.real("Voxel Size").unit("m").positive().meaning("Edge of a voxel.");
  s.realArray("Corner").unit("m").perAxis().byDefaultZeros().meaning(
      "Corner of the image with the smallest coordinates, before the rotation, which is about the middle of "
      "the image "
      "unless Rotation Centre is given.");
  return s;
}

void shapes(Section& s)
{
  s.chosenBy("Shape").meaning("Shape before rotation.");
  s.variant(box());
  s.variant(ball());
  s.variant(cylinder());
  s.variant(polygon());
  s.variant(file());
  s.variant(voxels());
}

Section operations()
{
  Section operation("operation", "A shape that is added to the body or cut from it.");
  operation.choice("Operation", {"Add", "Cut"}).meaning("Whether the shape is added or cut away.");
  shapes(operation);
  rotation(operation);

  Section s("Operations", "Shapes that are added to or cut from the body, applied in the order of the file. "
                          "The Rotation of the body applies to its first shape only.");
  s.namedByUser(operation);
  return s;
}

} // namespace

void describeShape(Section& s)
{
  shapes(s);
  rotation(s);
  s.subsection(operations());
}

Section bodies()
{
  Section body("body", "A body: its shape, its material and its initial state.");
  body.text("Material").notEmpty().meaning("Name of a sublist of Materials.");
  shapes(body);
  rotation(body);
  body.integer("Particles Per Cell")
      .range(1, 8)
      .byDefault(2)
      .meaning("Number of particles along each axis of a cell. At the surface of the body, a particle "
               "represents the part of its box that is inside.");
  body.real("Temperature")
      .unit("K")
      .positive()
      .optional("Thermal > Initial Temperature")
      .meaning("Initial temperature. Needs the section Thermal.");
  body.text("Temperature Field")
      .unit("K")
      .notEmpty()
      .optional()
      .meaning("Initial temperature as an expression of the position x, y, z, such as \"300 + 1e4 * x\". "
               "Needs the section Thermal.");
  body.realArray("Velocity")
      .unit("m/s")
      .perAxis()
      .byDefaultZeros()
      .meaning("Initial velocity of the centre of mass.");
  body.realArray("Angular Velocity")
      .unit("rad/s")
      .perRotationAxis()
      .byDefaultZeros()
      .meaning("Initial angular velocity about the centre of mass.");
  body.text("Bonded To")
      .notEmpty()
      .optional()
      .meaning("Names, separated by commas, of bodies that touch this one and are meant to be bonded to it. "
               "Bodies that touch have one motion at their common nodes in any case; the program warns of "
               "those not listed here.");
  body.atMostOneOf({"Temperature", "Temperature Field"});
  body.subsection(operations());

  Section s("Bodies", "The solid bodies.");
  s.require();
  s.namedByUser(body);
  return s;
}

} // namespace Rhegma
