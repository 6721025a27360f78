#include "geometry/Picture.hpp"

#include <stdexcept>

#ifdef RHEGMA_HAVE_PNG
#include <csetjmp>
#include <cstdio>
#include <png.h>
#endif

namespace Rhegma::Geometry
{

#ifdef RHEGMA_HAVE_PNG

namespace
{

/// What libpng is reading. Its errors jump back to where `setjmp` was called, past destructors: so no object
/// that has one is made there.
struct Reader
{
  std::FILE* file = nullptr;
  png_structp png = nullptr;
  png_infop info = nullptr;
  std::string error;
  bool packed = false; ///< one bit for each pixel

  explicit Reader(const std::string& path) : file(std::fopen(path.c_str(), "rb"))
  {
    png = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, fail, [](png_structp, png_const_charp) {});
    info = png == nullptr ? nullptr : png_create_info_struct(png);
  }
  ~Reader()
  {
    png_destroy_read_struct(&png, &info, nullptr);
    if (file != nullptr)
      std::fclose(file);
  }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  static void fail(png_structp png, png_const_charp message)
  {
    static_cast<Reader*>(png_get_error_ptr(png))->error = message;
    png_longjmp(png, 1);
  }

  /// \return whether it went well
  bool begin()
  {
    if (setjmp(png_jmpbuf(png)) != 0)
      return false;
    png_init_io(png, file);
    png_read_info(png, info);
    const int bits = png_get_bit_depth(png, info);
    packed = bits == 1 && png_get_color_type(png, info) == PNG_COLOR_TYPE_GRAY;
    if (packed)
      png_set_packing(png);
    else if (bits < 8 && png_get_color_type(png, info) == PNG_COLOR_TYPE_GRAY)
      png_set_expand_gray_1_2_4_to_8(png);
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
    return true;
  }

  bool finish(png_bytepp rows)
  {
    if (setjmp(png_jmpbuf(png)) != 0)
      return false;
    png_read_image(png, rows);
    return true;
  }
};

} // namespace

Picture readPng(const std::string& path, double available)
{
  Reader reader(path);
  if (reader.file == nullptr)
    throw std::invalid_argument("it can't be opened");
  if (reader.info == nullptr || !reader.begin())
    throw std::invalid_argument("it can't be read as a PNG picture (" + reader.error + ")");
  Picture picture;
  picture.columns = png_get_image_width(reader.png, reader.info);
  picture.rows = png_get_image_height(reader.png, reader.info);
  picture.channels = png_get_channels(reader.png, reader.info);
  if (png_get_color_type(reader.png, reader.info) == PNG_COLOR_TYPE_PALETTE)
    throw std::invalid_argument("it has a palette of colours; save it in shades of grey");
  checkMemory(static_cast<double>(picture.columns) * static_cast<double>(picture.rows) * picture.channels,
              available);
  const std::size_t stride = png_get_rowbytes(reader.png, reader.info);
  std::vector<unsigned char> bytes(stride * static_cast<std::size_t>(picture.rows));
  std::vector<png_bytep> rows(static_cast<std::size_t>(picture.rows));
  for (std::size_t k = 0; k < rows.size(); ++k)
    rows[k] = bytes.data() + k * stride;
  if (!reader.finish(rows.data()))
    throw std::invalid_argument("it can't be read as a PNG picture (" + reader.error + ")");
  const std::size_t each = png_get_bit_depth(reader.png, reader.info) == 16 ? 2 : 1;
  picture.bits = reader.packed ? 1 : static_cast<int>(8 * each);
  const std::size_t inRow = static_cast<std::size_t>(picture.columns * picture.channels);
  picture.samples.reserve(inRow * rows.size());
  for (const png_bytep row : rows)
    for (std::size_t k = 0; k < inRow; ++k) // the most significant byte is the first one
      picture.samples.push_back(each == 2 ? static_cast<std::uint16_t>(256 * row[2 * k] + row[2 * k + 1])
                                          : row[k]);
  return picture;
}

#else

Picture readPng(const std::string&, double)
{
  throw std::invalid_argument(
      "this program was built without libpng; make a .npy file of the picture with tools/rhegma-mesh");
}

#endif

} // namespace Rhegma::Geometry
