#include "geometry/PictureFile.hpp"

#include "base/Counted.hpp"
#include "base/ShortNumber.hpp"
#include "geometry/Picture.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <stdexcept>

namespace Rhegma::Geometry
{

namespace
{

std::string endingOf(const std::filesystem::path& path)
{
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return ending;
}

bool isPng(const std::string& ending) { return ending == ".png"; }
bool isTiff(const std::string& ending) { return ending == ".tif" || ending == ".tiff"; }

/// Whether one name comes before another: slice9 before slice10.
bool isBefore(const std::string& one, const std::string& other)
{
  const auto isDigit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  std::size_t i = 0, j = 0;
  while (i < one.size() && j < other.size())
  {
    if (isDigit(one[i]) && isDigit(other[j]))
    {
      const auto numberAt = [&](const std::string& text, std::size_t& at)
      {
        while (at + 1 < text.size() && text[at] == '0' && isDigit(text[at + 1]))
          ++at;
        const std::size_t begin = at;
        while (at < text.size() && isDigit(text[at]))
          ++at;
        return text.substr(begin, at - begin);
      };
      const std::string a = numberAt(one, i), b = numberAt(other, j);
      if (a != b)
        return a.size() != b.size() ? a.size() < b.size() : a < b;
    }
    else if (one[i] != other[j])
      return one[i] < other[j];
    else
    {
      ++i;
      ++j;
    }
  }
  return one.size() - i < other.size() - j || (one.size() - i == other.size() - j && one < other);
}

/// The grey value of each pixel.
std::vector<std::uint16_t> greyOf(const Picture& picture)
{
  const int channels = picture.channels, colours = channels >= 3 ? 3 : 1;
  if (channels == 1)
    return picture.samples;
  std::vector<std::uint16_t> grey;
  grey.reserve(picture.samples.size() / channels);
  for (std::size_t k = 0; k < picture.samples.size(); k += channels)
  {
    const std::uint16_t* const pixel = &picture.samples[k];
    const bool isGrey = colours == 1 || (pixel[0] == pixel[1] && pixel[1] == pixel[2]);
    if (!isGrey || (channels > colours && pixel[channels - 1] != picture.samples[channels - 1]))
      throw std::invalid_argument("it is in colour or partly transparent; each material needs a grey value: "
                                  "save it in shades of grey");
    grey.push_back(pixel[0]);
  }
  return grey;
}

/// The pictures of a stack as they are read.
struct Layers
{
  std::vector<std::vector<std::uint16_t>> grey;
  Picture first; ///< the first one, without its samples
};

/// Refuses a picture that is no layer of a stack. \param which "it", or "page 2"
void refuseOther(const Picture& picture, const Picture& first, const std::string& which)
{
  if (picture.columns != first.columns || picture.rows != first.rows)
    throw std::invalid_argument(which + " has " + std::to_string(picture.columns) + " x " +
                                std::to_string(picture.rows) + " pixels and the first picture " +
                                std::to_string(first.columns) + " x " + std::to_string(first.rows) +
                                "; all pictures of a stack must have one size");
  if (picture.bits != first.bits)
    throw std::invalid_argument(which + " has " + counted(picture.bits, "bit") +
                                " per pixel and the first picture " + std::to_string(first.bits) +
                                ", so that one grey value means two things; save all pictures of a stack "
                                "with as many bits");
}

} // namespace

void checkMemory(double samples, double available)
{
  constexpr double each = 6.0; // bytes: as read, as layers, and as a whole or as marks of where a value is
  if (each * samples > available)
    throw std::invalid_argument("the pictures need " + formatShort(each * samples * 1e-9) +
                                " GB of memory, but only " + formatShort(available * 1e-9) + " GB are free");
}

bool isOfPictures(const std::string& path)
{
  std::error_code error;
  const std::string ending = endingOf(path);
  return isPng(ending) || isTiff(ending) || std::filesystem::is_directory(path, error);
}

std::vector<std::string> filesOfPictures(const std::string& path)
{
  std::error_code error;
  if (!std::filesystem::is_directory(path, error))
    return {path};
  std::vector<std::string> files;
  std::filesystem::directory_iterator entries(path, error);
  if (error)
    throw std::invalid_argument("the folder can't be read");
  for (const auto& entry : entries)
  {
    const std::string ending = endingOf(entry.path());
    const bool hidden = entry.path().filename().string().front() == '.';
    if ((isPng(ending) || isTiff(ending)) && !hidden && entry.is_regular_file(error))
      files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end(), isBefore);
  return files;
}

Pictures readPictures(const std::string& path, double available)
{
  const std::vector<std::string> files = filesOfPictures(path);
  if (files.empty())
    throw std::invalid_argument("the folder has no PNG or TIFF files");
  Pictures all;
  Layers layers;
  double samples = 0.0;
  for (const std::string& file : files)
    try
    {
      const std::vector<Picture> pages =
          isPng(endingOf(file)) ? std::vector<Picture>{readPng(file, available)} : readTiff(file, available);
      for (std::size_t k = 0; k < pages.size(); ++k)
      {
        if (layers.grey.empty())
          layers.first = {pages[k].columns, pages[k].rows, pages[k].channels, pages[k].bits, {}};
        refuseOther(pages[k], layers.first, pages.size() > 1 ? "page " + std::to_string(k + 1) : "it");
        samples += static_cast<double>(pages[k].samples.size());
        checkMemory(samples, available);
        layers.grey.push_back(greyOf(pages[k]));
      }
    }
    catch (const std::invalid_argument& wrong)
    {
      if (files.size() == 1)
        throw;
      throw std::invalid_argument(std::filesystem::path(file).filename().string() + ": " + wrong.what());
    }
  all.count = {layers.first.columns, layers.first.rows, static_cast<std::int64_t>(layers.grey.size())};
  const std::size_t columns = all.count[0], rows = all.count[1], number = layers.grey.size();
  all.grey.resize(columns * rows * number);
  for (std::size_t z = 0; z < number; ++z)
    for (std::size_t row = 0; row < rows; ++row)
      for (std::size_t x = 0; x < columns; ++x)
        all.grey[(x * rows + (rows - 1 - row)) * number + z] = layers.grey[z][row * columns + x];
  return all;
}

} // namespace Rhegma::Geometry
