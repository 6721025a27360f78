#pragma once
/// The cracks as data: what the effects around cracks share.

#include "state/Types.hpp"

#include <string>
#include <vector>

namespace Rhegma
{

/// An end of a crack inside the body.
template <int D>
struct CrackFront
{
  int crack = 0;       ///< index of its crack
  int number = 0;      ///< counts the fronts of its crack from 0
  int vertex = 0;      ///< the vertex that it is, in CrackSet's numbering
  Vector<D> position;  ///< [m]
  Vector<D> direction; ///< unit vector in which the crack would run straight on
  Vector<D> normal;    ///< unit normal of the crack at the front, from side -1 to side +1
  double length = 0.0; ///< length of the crack that ends here [m]
  double speed = 0.0;  ///< [m/s]
};

/// One crack: a polyline (2D) or a triangulated surface (3D), a run of vertices and simplices in the set's
/// views.
template <int D>
struct Crack
{
  std::string name;
  int firstVertex = 0, numVertices = 0;
  int firstSimplex = 0, numSimplices = 0;
};

/// All cracks. A side is named +(c + 1) or -(c + 1), c the index of the crack; 0 is away from cracks. Each
/// vertex moves with both faces; the crack itself lies midway.
template <int D>
struct CrackSet
{
  std::vector<Crack<D>> cracks;
  std::vector<CrackFront<D>> fronts; ///< current; renewed after every step

  View<double* [D]> vertex;  ///< midway between the faces [m]
  View<double* [2][D]> face; ///< places on the faces of side -1 (0) and +1 (1) [m]
  View<int* [D]> simplex;    ///< vertices of each segment or triangle
  View<int*> crackOf;        ///< crack of each simplex
  View<int*> nodeSide;       ///< of each lattice node: its side where the node lies behind a front, else 0
  View<int*> second;         ///< second field of each lattice node, or -1 (dual field only)
  View<double*> pressure;    ///< that pushes the faces of each segment apart [Pa]; empty where nothing does
  bool dualField = true;

  bool empty() const { return cracks.empty(); }
};

} // namespace Rhegma
