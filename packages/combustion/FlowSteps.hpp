#pragma once
/// A step of gas that flows along its crack.

#include "combustion/Burning.hpp"
#include "combustion/FaceHeat.hpp"

namespace Rhegma::combustion
{

/// Finds the pressures along the crack and pushes the faces with them. \param pressure less that outside, of
/// each face point [Pa]
template <int D>
void pushByFlow(State<D>& state, const FacePoints<D>& points, Burning<D>& b, const View<double*>& pressure);

/// Records the work of these pressures on the faces, and the volumes that open. \param swept of each face
/// point [m3]
template <int D>
void recordFlow(State<D>& state, const FacePoints<D>& points, Burning<D>& b, const View<double*>& pressure,
                const View<double*>& swept);

/// The mass that burns at each burning face point in this step, and how the gas there heats it. \param most
/// that may burn anywhere [kg/m2]
template <int D>
void prepareFlow(const State<D>& state, const FacePoints<D>& points, const Burning<D>& b,
                 const View<int*>& lit, double most, const View<double*>& depth, const FaceHeating& heating);

/// Moves the gas through the step, after solid has burnt. \param mass that burnt in all [kg] \param heat that
/// it had as a solid [J] \param heatToFaces heat that the faces take at each face point [J]
template <int D>
void moveFlow(State<D>& state, const FacePoints<D>& points, Burning<D>& b, const View<double*>& depth,
              double mass, double heat, const View<double*>& heatToFaces);

} // namespace Rhegma::combustion
