#include "geometry/Picture.hpp"

#include <stdexcept>

#ifdef RHEGMA_HAVE_TIFF
#include <algorithm>
#include <iterator>
#include <memory>
#include <tiffio.h>
#endif

namespace Rhegma::Geometry
{

#ifdef RHEGMA_HAVE_TIFF

namespace
{

/// Whether a compression changes samples, or may do so.
bool isLossy(std::uint16_t compression)
{
  // All that are JPEG: of TIFF 6 and of the revised tag, JPEG 2000 (two numbers), JPEG-LS and JPEG XR.
  constexpr std::uint16_t jpegs[] = {6, 7, 33003, 33005, 34712, 34715, 34933};
  return std::find(std::begin(jpegs), std::end(jpegs), compression) != std::end(jpegs);
}

/// The page that a file is at.
/// \param before samples of the pages before it
Picture readPage(TIFF* file, double before, double available)
{
  std::uint32_t columns = 0, rows = 0;
  std::uint16_t channels = 1, bits = 1, format = SAMPLEFORMAT_UINT, planar = PLANARCONFIG_CONTIG,
                orientation = ORIENTATION_TOPLEFT, colours = PHOTOMETRIC_MINISBLACK,
                compression = COMPRESSION_NONE;
  TIFFGetField(file, TIFFTAG_IMAGEWIDTH, &columns);
  TIFFGetField(file, TIFFTAG_IMAGELENGTH, &rows);
  TIFFGetFieldDefaulted(file, TIFFTAG_SAMPLESPERPIXEL, &channels);
  TIFFGetFieldDefaulted(file, TIFFTAG_BITSPERSAMPLE, &bits);
  TIFFGetFieldDefaulted(file, TIFFTAG_SAMPLEFORMAT, &format);
  TIFFGetFieldDefaulted(file, TIFFTAG_PLANARCONFIG, &planar);
  TIFFGetField(file, TIFFTAG_PHOTOMETRIC, &colours);
  TIFFGetFieldDefaulted(file, TIFFTAG_ORIENTATION, &orientation);
  TIFFGetFieldDefaulted(file, TIFFTAG_COMPRESSION, &compression);
  if (isLossy(compression))
    throw std::invalid_argument("it is compressed by JPEG, which changes grey values at the edges of "
                                "materials; save it without loss, as PNG or as TIFF with LZW");
  if (orientation != ORIENTATION_TOPLEFT)
    throw std::invalid_argument("its tag Orientation turns or mirrors it; save it upright");
  if (colours == PHOTOMETRIC_PALETTE)
    throw std::invalid_argument("it has a palette of colours; save it in shades of grey");
  if ((format != SAMPLEFORMAT_UINT && format != SAMPLEFORMAT_VOID) || (bits != 1 && bits != 8 && bits != 16))
    throw std::invalid_argument(
        "its grey values are no whole numbers of 1, 8 or 16 bits; save it with 8 or 16 bits per pixel");
  if (TIFFIsTiled(file) != 0 || (planar != PLANARCONFIG_CONTIG && channels > 1))
    throw std::invalid_argument("it is stored in tiles or planes; save it in strips, or make a .npy file of "
                                "it with tools/rhegma-mesh");
  Picture picture;
  picture.columns = columns;
  picture.rows = rows;
  picture.channels = channels;
  picture.bits = bits;
  checkMemory(before + static_cast<double>(columns) * static_cast<double>(rows) * channels, available);
  const std::size_t inRow = std::size_t{columns} * channels;
  std::vector<unsigned char> row(static_cast<std::size_t>(TIFFScanlineSize(file)));
  if (row.size() < (inRow * bits + 7) / 8)
    throw std::invalid_argument("its rows are shorter than it says");
  picture.samples.reserve(inRow * rows);
  const unsigned largest = (1u << bits) - 1u;
  for (std::uint32_t k = 0; k < rows; ++k)
  {
    if (TIFFReadScanline(file, row.data(), k, 0) < 0)
      throw std::invalid_argument("row " + std::to_string(k + 1) + " of " + std::to_string(rows) +
                                  " can't be read; the file may be cut off");
    for (std::size_t i = 0; i < inRow; ++i)
    {
      // Of 16 bits, libtiff gives the machine's order of bytes.
      const unsigned value = bits == 1   ? row[i / 8] >> (7 - i % 8) & 1u
                             : bits == 8 ? row[i]
                                         : reinterpret_cast<const std::uint16_t*>(row.data())[i];
      picture.samples.push_back(
          static_cast<std::uint16_t>(colours == PHOTOMETRIC_MINISWHITE ? largest - value : value));
    }
  }
  return picture;
}

} // namespace

std::vector<Picture> readTiff(const std::string& path, double available)
{
  TIFFSetErrorHandler(nullptr); // the messages are those of this program
  TIFFSetWarningHandler(nullptr);
  const std::unique_ptr<TIFF, void (*)(TIFF*)> file(TIFFOpen(path.c_str(), "r"), TIFFClose);
  if (file == nullptr)
    throw std::invalid_argument("it can't be read as a TIFF picture");
  std::vector<Picture> pages;
  double samples = 0.0;
  while (true)
  {
    pages.push_back(readPage(file.get(), samples, available));
    samples += static_cast<double>(pages.back().samples.size());
    if (TIFFLastDirectory(file.get()) != 0)
      return pages;
    if (TIFFReadDirectory(file.get()) == 0)
      throw std::invalid_argument("page " + std::to_string(pages.size() + 1) +
                                  " can't be read; the file may be cut off");
  }
}

#else

std::vector<Picture> readTiff(const std::string&, double)
{
  throw std::invalid_argument(
      "this program was built without libtiff; make a .npy file of the picture with tools/rhegma-mesh");
}

#endif

} // namespace Rhegma::Geometry
