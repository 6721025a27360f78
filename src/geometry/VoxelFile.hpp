#pragma once
/// Images of voxels from files of NumPy and from pictures.

#include "geometry/VoxelPhase.hpp"

#include <memory>
#include <string>

namespace Rhegma::Geometry
{

/// The voxels of a file that have a value: a .npy file, an array of integers in C order with D axes, x, y and
/// z, or pictures (PictureFile.hpp). A file that has not changed since the last time is not read again; the
/// last few phases stay in memory. \param available memory [bytes] \throws std::invalid_argument, whose
/// message begins with the path, if the file is missing, is no such image or has no voxel of this value, or
/// if there is too little memory
template <int D>
std::shared_ptr<const VoxelPhase<D>> readVoxels(const std::string& path, int value, double available);

} // namespace Rhegma::Geometry
