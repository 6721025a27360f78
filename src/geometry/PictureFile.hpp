#pragma once
/// Pictures in shades of grey, and stacks of them.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace Rhegma::Geometry
{

/// Grey values of voxels: of one picture, or of pictures one above the other.
struct Pictures
{
  std::array<std::int64_t, 3> count{}; ///< columns (x), rows (y, upwards), pictures (z)
  std::vector<std::uint16_t> grey;     ///< the last axis runs fastest
};

/// Whether a path is that of a PNG or TIFF file, by its ending, or of a folder.
bool isOfPictures(const std::string& path);

/// The files of isOfPictures: one, or those of a folder in the order of their names, in which numbers count
/// as numbers.
std::vector<std::string> filesOfPictures(const std::string& path);

/// Reads a PNG file, a TIFF file of one or more pages, or all such files of a folder. The first picture is
/// the lowest one; the upper row of a picture has the largest y. Values have 8 or 16 bits; pictures of one
/// bit have 0 and 1. \param available memory [bytes] \throws std::invalid_argument, where a file is none of
/// these, is in colour or compressed by JPEG, or has another size or other bits than the first one, or if
/// there is too little memory
Pictures readPictures(const std::string& path, double available);

} // namespace Rhegma::Geometry
