#include "cohesive_faces/CohesiveSection.hpp"

#include "base/Numbers.hpp"
#include "base/ReadList.hpp"
#include "scene/ErrorIndex.hpp"
#include "scene/RoundBodies.hpp"

namespace Rhegma::cohesive_faces
{

namespace
{

void addLaw(Section& crack)
{
  crack.choice("Law", {"Linear", "Bilinear", "Trapezoidal", "Exponential"})
      .byDefault("Bilinear")
      .meaning(
          "Traction as a function of opening and slip. Bilinear: linear to the strength, then linear to "
          "zero. Linear: the same for an interface without a stiffness of its own, which starts as stiff "
          "as the cells allow. Trapezoidal: the strength is kept over the part Plateau of the rest. "
          "Exponential: smooth, after Xu and Needleman; strength and toughness determine its stiffness.");
  crack.real("Toughness")
      .unit("J/m2")
      .positive()
      .meaning("Energy per area that opening the faces takes (mode I): the area below the traction.");
  crack.real("Toughness II")
      .unit("J/m2")
      .positive()
      .optional("Toughness")
      .meaning("Energy per area that slip of the faces takes (modes II and III).");
  crack.real("Strength").unit("Pa").positive().meaning("Largest normal traction.");
  crack.real("Shear Strength").unit("Pa").positive().optional("Strength").meaning("Largest shear traction.");
  crack.real("Initial Stiffness")
      .unit("Pa/m")
      .positive()
      .optional("2 (equilibrium: 20) times the P-wave modulus of the softest body at the crack over the cell "
                "size; more where the strength is reached with more than a tenth of the toughness")
      .meaning("Normal traction per opening of undamaged faces, such as E/t of a layer of the thickness t. "
               "That in shear is (Shear Strength / Strength)^2 Toughness / Toughness II times as much. "
               "For Bilinear and Trapezoidal.");
  crack.real("Exponent")
      .atLeast(1.0)
      .byDefault(2.0)
      .meaning("Exponent of the toughness in mixed mode (Benzeggagh and Kenane): G_I + (G_II - G_I) "
               "B^Exponent, B the "
               "fraction of mode II in the energy.");
  crack.real("Plateau").atLeast(0.0).below(1.0).optional("0.5").meaning(
      "Of Law = Trapezoidal: part of the jump between the onset of damage and failure over which the "
      "traction "
      "is constant.");
}

void checkBox(const Teuchos::ParameterList& crack, const std::string& where, std::vector<SceneError>& errors)
{
  using Numbers = Teuchos::Array<double>;
  const char* const names[] = {"Free Lower Corner", "Free Upper Corner"};
  if (!crack.isType<Numbers>(names[0]) || !crack.isType<Numbers>(names[1]))
    return;
  const auto &lower = crack.get<Numbers>(names[0]), &upper = crack.get<Numbers>(names[1]);
  for (int d = 0; d < std::min(lower.size(), upper.size()); ++d)
    if (!(lower[d] < upper[d]))
    {
      errors.push_back({where + " > " + names[1],
                        "is not above Free Lower Corner along every axis; exchange the corners, or leave "
                        "both out if all faces hold"});
      return;
    }
}

void checkStiffness(const Teuchos::ParameterList& crack, const std::string& where,
                    std::vector<SceneError>& errors)
{
  const double K = crack.get<double>("Initial Stiffness"), T = crack.get<double>("Strength"),
               G = crack.get<double>("Toughness");
  if (!(T * T / (2.0 * K) < G))
    errors.push_back({where + " > Initial Stiffness",
                      "is too small: faces that reach the strength would have taken " +
                          formatReal(T * T / (2.0 * K)) + " J/m2, more than the toughness of " +
                          formatReal(G) + " J/m2; write more than " + formatReal(T * T / (2.0 * G)) +
                          " Pa/m, or leave it out"});
}

} // namespace

Section cohesiveSection()
{
  Section s("Cohesive Faces", "Faces of cracks that hold together by a traction-separation law: adhesive "
                              "joints, layers that may delaminate, weak planes. Damage does not heal.");
  refuseAxisymmetric(s, "tractions of faces act per thickness, not around a circle");
  Section crack("crack", "Faces of one crack, which goes from surface to surface of the bodies. The sublist "
                         "has the name of the crack.");
  addLaw(crack);
  crack.realArray("Free Lower Corner")
      .unit("m")
      .perAxis()
      .optional()
      .meaning("Lower corner of a box; faces in it are free from the start, as those of a starter crack. In "
               "3D a face "
               "point is free if it is in the box.");
  crack.realArray("Free Upper Corner").unit("m").perAxis().optional().meaning("Upper corner of that box.");
  crack.allOrNoneOf({"Free Lower Corner", "Free Upper Corner"});
  s.namedByUser(crack);
  s.namedAfter("Cracks", "there are no cracks; add the section Cracks or leave Cohesive Faces out");
  const auto self = when::present("Cohesive Faces");
  s.refuse({self, when::is("Cracks", "Formulation", {"Broken Cell", "Corrected Broken Cell"})},
           "faces hold with dual fields only; write Cracks > Formulation = Dual Field");
  s.refuse({self, when::is("Contact", "Law", {"Stick", "Coulomb", "Visibility"})},
           "friction belongs to failed faces only, and would act in addition to the cohesion of the others; "
           "write Contact > Law = Frictionless, or leave Contact out: cohesive faces do not overlap");
  s.refuse(
      {self, when::present("Contact"), when::equilibrium()},
      "in equilibrium both have not been verified together; leave Contact out: cohesive faces that press "
      "on each other resist by their initial stiffness");
  s.refuse({self, when::present("Propagation")},
           "cracks that grow next to cohesive faces have not been verified; let the crack go on along its "
           "path, held by Cohesive Faces, or leave one of both out");
  s.refuse({self, when::present("Sub-Cycling")},
           "cohesive forces do not follow the substeps of nodes; leave Sub-Cycling out");
  s.refuse(
      {when::present("Cohesive Faces > *"), when::present("Combustion > *")},
      "faces that hold would burn, and gas would burst them; remove the crack from one of the two sections");
  s.refuse({self, when::present("Thermal")},
           "no heat passes between the faces of a crack, also where they hold; leave one of both out");
  s.refuse({self, when::isNot("Time", "Initial State", {"Unloaded"})},
           "the equilibrium at the start does not include cohesive faces; write Unloaded");
  return s;
}

void checkCohesion(const Teuchos::ParameterList& scene, std::vector<SceneError>& errors)
{
  const Teuchos::ParameterList& all = scene.sublist("Cohesive Faces");
  if (sublistNames(all).empty())
    errors.push_back({"Cohesive Faces", "names no crack; write a sublist with the name of one, or leave the "
                                        "section out"});
  const ErrorIndex found(errors);
  for (const std::string& name : sublistNames(all))
  {
    const std::string where = "Cohesive Faces > " + name;
    const Teuchos::ParameterList& crack = all.sublist(name);
    if (found.hasBelow(where, "") || !crack.isType<std::string>("Law"))
      continue;
    const std::string law = crack.get<std::string>("Law");
    if (crack.isParameter("Plateau") && law != "Trapezoidal")
      errors.push_back({where + " > Plateau",
                        "the law " + law + " has no plateau; leave it out or write Law = Trapezoidal"});
    const bool given = crack.isParameter("Initial Stiffness");
    if (given && law == "Linear")
      errors.push_back({where + " > Initial Stiffness",
                        "Law = Linear starts as stiff as the cells allow; leave it out or write Law = "
                        "Bilinear"});
    else if (given && law == "Exponential")
      errors.push_back({where + " > Initial Stiffness",
                        "that of an exponential law is (e Strength)^2 / Toughness; leave it out or choose "
                        "another law"});
    else if (given)
      checkStiffness(crack, where, errors);
    checkBox(crack, where, errors);
  }
}

} // namespace Rhegma::cohesive_faces
