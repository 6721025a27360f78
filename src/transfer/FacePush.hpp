#pragma once
/// A pressure between the faces of a crack, as forces on nodes.

#include "transfer/FacePoints.hpp"

namespace Rhegma
{

/// Adds p A n and its opposite to the nodes of the two faces at every face point of a crack, A the current
/// area and n the current normal: the sum over all nodes is zero to round-off. \param pressure [Pa] \param
/// label of the kernel
template <int D>
void pushFaces(const char* label, const State<D>& state, const FacePoints<D>& points, int crack,
               double pressure);

/// The same with one pressure per face point.
template <int D>
void pushFaces(const char* label, const State<D>& state, const FacePoints<D>& points, int crack,
               const View<double*>& pressure);

/// Volume [m3] that opens between the faces at each point of a crack in this step, by the velocity of the
/// faces (FaceVelocity): this rank's part. Call in or after stageOfFaceVelocity (plan/LastStage.hpp).
template <int D>
void sweptVolumes(const char* label, const State<D>& state, const FacePoints<D>& points, int crack,
                  const View<double*>& swept);

/// Work [J] that the forces above do in this step (WorkVelocity), in or after the same stage: this rank's
/// part.
template <int D>
double workOnFaces(const char* label, const State<D>& state, const FacePoints<D>& points, int crack,
                   double pressure);
template <int D>
double workOnFaces(const char* label, const State<D>& state, const FacePoints<D>& points, int crack,
                   const View<double*>& pressure);

/// Stores the pressure in a crack for other effects (CrackSet::pressure).
template <int D>
void publishPressure(const char* label, CrackSet<D>& cracks, int crack, double pressure);

/// The same with a pressure of each face point: a segment or triangle gets the mean of its points.
template <int D>
void publishPressure(const char* label, CrackSet<D>& cracks, const FacePoints<D>& points, int crack,
                     const View<double*>& pressure);

/// Index of a crack by name, or -1.
template <int D>
int findCrack(const CrackSet<D>& cracks, const std::string& name)
{
  for (std::size_t c = 0; c < cracks.cracks.size(); ++c)
    if (cracks.cracks[c].name == name)
      return static_cast<int>(c);
  return -1;
}

} // namespace Rhegma
