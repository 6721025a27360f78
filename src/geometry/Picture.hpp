#pragma once
/// One picture, as libraries read it.

#include <cstdint>
#include <string>
#include <vector>

namespace Rhegma::Geometry
{

/// Samples of a picture, row by row from the upper one.
struct Picture
{
  std::int64_t columns = 0, rows = 0;
  int channels = 1;
  int bits = 8; ///< of a sample in the file: 1, 8 (also of 2 and 4, which are read as 8) or 16
  std::vector<std::uint16_t> samples; ///< of each pixel, its channels one after the other
};

/// \throws std::invalid_argument where pictures with so many samples need more memory than there is: six
/// bytes for each while they are read
void checkMemory(double samples, double available);

/// \param available memory [bytes] \throws std::invalid_argument where the file can't be read
Picture readPng(const std::string& path, double available);
/// All pages of a file. \param available memory [bytes] \throws std::invalid_argument where the file can't be
/// read
std::vector<Picture> readTiff(const std::string& path, double available);

} // namespace Rhegma::Geometry
