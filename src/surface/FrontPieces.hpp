#pragma once
/// Which facets of a crack are its fronts.

#include "surface/CrackMesh.hpp"

namespace Rhegma::surface
{

/// A piece of front: a facet of a simplex.
struct Piece
{
  int simplex, facet;
};

/// The fronts of one crack, each a run of pieces in order along it: in 2D the first end, then the last; in 3D
/// chains of edges.
std::vector<std::vector<Piece>> frontsOf(const CrackMesh<2>& mesh);
std::vector<std::vector<Piece>> frontsOf(const CrackMesh<3>& mesh);

/// The vertex that represents a front.
int middleVertex(const CrackMesh<2>& mesh, const std::vector<Piece>& pieces);
int middleVertex(const CrackMesh<3>& mesh, const std::vector<Piece>& pieces);

} // namespace Rhegma::surface
