#pragma once
/// The cracks: data that their effects exchange.

#include "base/FacetEnds.hpp"
#include "base/Types.hpp"
#include "state/EquilibriumGrowth.hpp"
#include "state/FrontEvent.hpp"
#include "state/ReleaseBudget.hpp"

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

namespace Rhegma
{

template <int D>
struct State;

/// Driving force of a front node, as last computed.
struct DrivingForce
{
  double release = 0.0;             ///< energy release rate [J/m2]
  double modeI = 0.0, modeII = 0.0; ///< stress intensities [Pa m^0.5]
  double modeIII = 0.0;             ///< the same, 3D only
  double hoopAngle = 0.0; ///< from its direction towards its normal, where the hoop stress is largest [rad]
  bool lost = false; ///< no material is left in the contour of its J integral; `release` is the last known
};

/// Weights of the domain integrals that measure driving forces, in cells at the front.
struct DrivingContours
{
  double releaseInner = 5.0, releaseOuter = 10.0;
  double intensityInner = 3.0, intensityOuter = 6.0;
};

/// A vertex of a front. In 3D direction x normal runs along the front, against the order of its nodes.
template <int D>
struct FrontNode
{
  int vertex = 0; ///< in CrackSet's numbering
  int name = 0;   ///< number that stays the same while the front grows, counted from 0 in its front
  int from = -1;  ///< the front node, by name, that it came from when the front grew; -1: it was there
  int facet = -1; ///< the piece of front from it to the next front node, an index in
                  ///< CrackSet::frontFacet; -1: none, its line ends here; the last of a closed line runs
                  ///< to the line's first; in 2D the front's only facet
  double tributaryLength = 1.0; ///< half the length of the pieces at it [m]; 1 in 2D
  Vector<D> position{};         ///< [m]
  Vector<D> direction{}; ///< unit vector in which the crack would run straight on: across the front; at a
                         ///< surface-breaking edge along it
  Vector<D> normal{};    ///< unit normal of the crack, from side -1 to side +1, normal to direction

  DrivingForce driving;     ///< computed where CrackSet::driven is set
  bool advances = false;    ///< it is about to advance and needs its stress intensities
  bool landed = false;      ///< it has reached a surface or another crack
  bool stopped = false;     ///< it never advances again: it has landed, or stopped for a numerical reason
  double speed = 0.0;       ///< [m/s]
  double temperature = 0.0; ///< where an effect computes it [K]
  double advance = 0.0;     ///< by which it has advanced since the start [m]
};

/// How far a front has advanced since the start.
struct FrontExtension
{
  double largest = 0.0; ///< of the node that advanced most [m]
  double mean = 0.0; ///< along the front, the most that it was: parts of a front that land are left out [m]
  double area = 0.0; ///< of its new faces [m2]; in 2D their length [m]
};

/// An end of a crack inside the body: a vertex of a polyline (2D), a line of edges along the border of a
/// surface (3D).
template <int D>
struct CrackFront
{
  int crack = 0;         ///< index of its crack
  int number = 0;        ///< counts the fronts of its crack from 0
  int vertex = 0;        ///< in CrackSet's numbering: that of its node (2D), the one midway along it (3D)
  int firstFacet = 0;    ///< its facets, in order along it, are firstFacet .. firstFacet + numFacets - 1
  int numFacets = 1;     ///< in CrackSet::frontFacet
  Vector<D> position{};  ///< of the vertex [m]
  Vector<D> direction{}; ///< unit vector in which the crack would run straight on from there
  Vector<D> normal{};    ///< unit normal of the crack there, from side -1 to side +1
  double length = 0.0;   ///< length of the crack that ends here (2D) or of the front itself (3D) [m]

  /// In order along it. In 2D there is exactly one. In 3D they are one line, closed or not, until the surface
  /// of the body divides it into several; none is left of a front that has ended.
  std::vector<FrontNode<D>> nodes = std::vector<FrontNode<D>>(D == 2 ? 1 : 0);

  bool grown = false;           ///< it has advanced since the start
  bool ended = false;           ///< it has met the surface of its body or another crack and has no facet
  bool due = true;              ///< its driving forces are computed in this step
  bool measured = false;        ///< and its stress intensities as well, though it does not advance
  ReleaseBudget budget{D == 3}; ///< energy of its new faces
  FrontExtension extension;     ///< how far it has advanced since the start
  FrontEvent<D> stop;           ///< the first stop of a node for a numerical reason
  FrontEvent<D> arrival;        ///< the last arrival of a node at a surface or another crack

  /// Whether any of its nodes is about to advance.
  bool advances() const
  {
    return std::any_of(nodes.begin(), nodes.end(), [](const FrontNode<D>& n) { return n.advances; });
  }

  /// Whether none of its nodes can advance again.
  bool stopped() const
  {
    return std::all_of(nodes.begin(), nodes.end(), [](const FrontNode<D>& n) { return n.stopped; });
  }

  /// Number of its nodes that are stopped for a numerical reason: their G has reached their toughness, or is
  /// not known. Of a front that has ended none.
  int numStopped() const
  {
    const auto count = std::count_if(nodes.begin(), nodes.end(),
                                     [](const FrontNode<D>& n) { return n.stopped && !n.landed; });
    return ended ? 0 : static_cast<int>(count);
  }

  /// Positions of its nodes, in 2D of its end [m]; none of a front that has no nodes left.
  std::vector<Vector<D>> points() const
  {
    std::vector<Vector<D>> all;
    if constexpr (D == 2)
      all.push_back(position);
    else
      for (const FrontNode<D>& node : nodes)
        all.push_back(node.position);
    return all;
  }

  /// Speed of its fastest node [m/s].
  double speed() const
  {
    double fastest = 0.0;
    for (const FrontNode<D>& node : nodes)
      fastest = node.stopped ? fastest : std::max(fastest, node.speed);
    return fastest;
  }
};

/// One crack: a polyline (2D) or a triangulated surface (3D), a run of vertices and simplices in the set's
/// views.
template <int D>
struct Crack
{
  std::string name; ///< as in the scene
  int firstVertex = 0, numVertices = 0;
  int firstSimplex = 0, numSimplices = 0;
  /// Group of bodies that it cuts (fields::bodyGroup), where groups are kept apart; 0: whatever is there.
  int bodyGroup = 0;
};

/// The advance of a front node between two steps.
template <int D>
struct FrontNodeAdvance
{
  Vector<D> direction{};  ///< unit vector
  double length = 0.0;    ///< [m]; 0: it stays
  double toughness = 0.0; ///< fracture energy of the new faces [J/m2]; of a node that stays, its toughness
};

/// The advances of a front's nodes between two steps.
template <int D>
struct FrontAdvance
{
  int front = 0;                            ///< index in CrackSet::fronts
  std::vector<FrontNodeAdvance<D>> nodes{}; ///< in the order of CrackFront::nodes
};

/// Energy of the contact of the faces of a crack.
struct ContactEnergy
{
  double stored = 0.0;     ///< in the layer between the faces now [J]
  double dissipated = 0.0; ///< by friction so far [J]
};

/// Traction of closed faces on each other at a point.
template <int D>
struct FaceTraction
{
  Vector<D> position{}; ///< [m]
  Vector<D> traction{}; ///< on side +1, opposite on side -1 [Pa]
  Vector<D> edge{};     ///< unit vector along the first edge of its simplex
  double size = 0.0;    ///< length or area of crack that it acts on now [m, m2]
};

/// What a vertex of a crack lies on, as bits: a front's end at the surface of a body has both.
namespace vertexKind
{
constexpr int inner = 0;           ///< uncracked material all around
constexpr int surfaceBreaking = 1; ///< the surface of the body, or another crack that it has met
constexpr int front = 2;           ///< a front
} // namespace vertexKind

/// All cracks. A side is named +(c + 1) or -(c + 1), c the index of the crack; 0 is away from cracks. Each
/// vertex moves with both faces; the crack itself lies midway. Where the cells lie in the undeformed body,
/// vertices stay there and only the opening of the faces changes. Facet i of a simplex is the one opposite to
/// its i-th vertex: the other end of a segment, an edge of a triangle. Simplices of a crack have one
/// orientation: side +1 lies to the left of a segment, and where the vertices of a triangle are seen
/// anticlockwise.
template <int D>
struct CrackSet
{
  std::vector<Crack<D>> cracks;      ///< one for each of the scene
  std::vector<CrackFront<D>> fronts; ///< current; renewed after every step

  View<double* [D]> vertex;  ///< midway between the faces [m]
  View<double* [2][D]> face; ///< positions on the faces of side -1 (0) and +1 (1) [m]
  /// Displacement of each vertex since the start, where the cells lie in the undeformed body: `vertex` and
  /// `face` do not contain it [m]. Else empty.
  View<double* [D]> carried;
  View<int* [D]> simplex;   ///< vertices of each segment or triangle
  View<int*> crackOf;       ///< crack of each simplex
  View<int* [D]> neighbour; ///< simplex beyond each facet, or a constant of FacetEnds.hpp
  View<int*> starBegin; ///< the simplices at vertex v are star(starBegin(v)) .. star(starBegin(v + 1) - 1)
  View<int*> star;      ///< see starBegin
  View<int*> kind;      ///< of each vertex: what it lies on (vertexKind, added)
  View<int* [2]> frontFacet; ///< simplex and facet of each piece of front
  /// The first piece of the fronts of each crack and the one after its last; in between there may be others.
  View<int* [2]> facetsOfCrack;
  View<int*> nearFront; ///< whether each simplex lies within a stencil or two of a front

  View<double* [D]> normal;       ///< unit normal of each simplex, from side -1 to side +1
  View<double* [D]> vertexNormal; ///< unit normal of each vertex, mean of its simplices' by their angles

  View<int*> bodyGroupOf; ///< Crack::bodyGroup of each crack; empty where groups are not kept apart

  View<int*> nodeSide;      ///< of each node: its side where the node lies behind a front, else 0
  View<int*> enrichedField; ///< row of the enriched field of each node, or -1 (dual field only)
  /// Conductance between the two fields of a node near a front that its cell joins, over conductivity and
  /// width [-], of nodes with a side. Zero away from fronts; empty where all nodes with a side are cut.
  View<double*> frontConductance;
  View<double*> pressure; ///< on the faces of each segment or triangle [Pa]; empty without pressure
  /// Springs and cohesive tractions behind fronts, of each lattice node: force on its primary field, opposite
  /// on its enriched field [N], and stiffness [N/m]. Holds for nodes with both; empty without springs.
  View<double * [D + 1]> spring;
  /// Elastic energy of the spring of each lattice node with two fields, zero under a cohesive traction [J].
  View<double*> springEnergy;
  std::vector<FrontAdvance<D>> advances; ///< that fronts are to make before the next step
  bool driven = false;             ///< whether driving forces of fronts are computed in the steps of a run
  DrivingContours drivingContours; ///< of the integrals that measure driving forces
  bool dualField = true;           ///< whether nodes behind fronts have an enriched field
  bool frontSprings = false;       ///< springs between the two fields of nodes just behind fronts

  long changes = 0; ///< number of times that vertices or simplices were laid out anew

  EquilibriumGrowth growth; ///< in steps of equilibrium

  /// Contact energy of the part of a crack within a distance of a middle [m], both along the undeformed
  /// crack; in 3D of the whole crack. Empty without contact.
  std::function<ContactEnergy(int crack, double middle, double reach)> contactEnergy;

  /// Tractions of closed faces on each other, in the order of the simplices and along each; on all ranks the
  /// same. Empty without contact.
  std::function<std::vector<FaceTraction<D>>(int crack)> tractions;
  /// Adds them as forces [N] to the internal forces in the first D columns of a row a node, on each rank its
  /// own; springs are left out of these.
  std::function<void(const State<D>&, const View<double * [D + 1]>& force)> addTractions;

  bool empty() const { return cracks.empty(); } ///< whether there are no cracks
};

/// Whether a front has met the surface of its body or another crack.
template <int D>
bool anyEnded(const CrackSet<D>& set)
{
  return std::any_of(set.fronts.begin(), set.fronts.end(),
                     [](const CrackFront<D>& front) { return front.ended; });
}

/// The name of a front in messages, such as "crack Notch, front 0".
template <int D>
std::string frontName(const CrackSet<D>& set, const CrackFront<D>& front)
{
  return "crack " + set.cracks[front.crack].name + ", front " + std::to_string(front.number);
}

} // namespace Rhegma
