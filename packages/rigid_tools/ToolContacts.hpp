#pragma once
/// Contacts of a tool with fields of nodes.

#include "rigid_tools/CellsNearTool.hpp"

namespace Rhegma::rigid_tools
{

/// How far the domains of the particles next to a tool are from it.
template <int D>
struct ParticleGaps
{
  View<int*> particle;      ///< particles whose gap is less than half a cell
  View<double*> gap;        ///< of each [m]
  View<double* [D]> normal; ///< out of the tool
  View<double* [D]> foot;   ///< the point of the tool that is nearest to the particle [m]
  View<double*> spacing;    ///< edge of the cells at the particle [m]
  int count = 0;            ///< number of these particles
  int touching = 0;         ///< how many of them have a gap of less than a tenth of a cell
};

/// The fields of nodes with which a tool is in contact in this step: rows of nodal values.
template <int D>
struct ToolContacts
{
  View<int*> row;            ///< of the field
  View<int*> node;           ///< node at whose position it is
  View<double* [D]> normal;  ///< unit normal out of the tool, along axes that no support holds
  View<double* [D]> arm;     ///< from the tool's centre of rotation to its point next to the node [m]
  View<double*> gap;         ///< between the tool and the particles at the node [m]
  View<char* [D]> held;      ///< not 0 along axes that a support holds
  View<double* [D]> impulse; ///< on the body in this step [N s]
  View<double* [D]> wanted;  ///< the impulse that is found, before it is applied [N s]
  View<char*> sticks;        ///< not 0 where the two do not move along each other
  View<double* [2]> taken; ///< energy that contact takes in this step, and the part of it along the faces [J]
  View<double*> work;      ///< of the tool on the body in this step [J]
  View<int*> parts;        ///< number of fields among which the impulse is divided; 0: left out
  View<int * [1 << D]> partRow; ///< their rows
  View<double * [1 << D]> part; ///< of each; they add to 1 [-]
  View<double*>
      mass; ///< that takes the impulse: its velocity is that of the body at the contact [kg]; 0: left out
  int count = 0; ///< number of contacts
  int cut = 0;   ///< of a tool with a mass: contacts with less friction than their law has (FreeVelocity)

  // Kept from step to step, to be used again.
  View<char*> several;   ///< of each lattice node: not 0 while those with more than one field are marked
  View<int*> indexOfRow; ///< of each row of nodal values: its contact, or -1
  View<int*> marked;     ///< rows at which particles touch the tool, before they are sorted
  View<int*> first;      ///< particles of contact k: particle(first(k)) .. particle(first(k + 1) - 1)
  View<int*> particle;   ///< numbers in ParticleGaps
  View<double*> weight;  ///< of each of these at the node
};

/// Measures the gaps of the particles near a tool, of the bodies that it touches. \param touches of each
/// body: not 0 where the tool touches it
template <int D>
void measureGaps(const State<D>& state, const Tool<D>& tool, const std::vector<char>& touches,
                 const CellsNearTool<D>& near, ParticleGaps<D>& gaps);

/// Lists the fields of nodes next to the tool that have a particle which touches it.
///
/// A node counts up to half a cell from the tool's surface, and up to a whole cell where particles lie deeper
/// in the tool. Its normal is the mean of those of its particles that touch the tool and are no further than
/// half a cell from the line through the node along their normal, or as far as its nearest particle. At nodes
/// that pressed on the tool in the last step, particles still touch it with a gap of up to a tenth of a cell:
/// where the surface of a body is not on a node, strain moves the domains of its particles relative to the
/// tool. Held axes are still in the normals (holdContacts).
template <int D>
void listContacts(const State<D>& state, const Tool<D>& tool, const ParticleGaps<D>& gaps,
                  ToolContacts<D>& contacts);

} // namespace Rhegma::rigid_tools
