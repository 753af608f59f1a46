#include <png.h>

#include <csetjmp>
#include <cstring>

#include "image_decode.hpp"
#include "png.hpp"
#include "scene/limits.hpp"

namespace tyndall::scene {
namespace {

struct Source {
  std::span<const std::byte> bytes;
  std::size_t at = 0;
  char message[160] = {};
};

void read(png_structp png, png_bytep out, png_size_t size) {
  auto* source = static_cast<Source*>(png_get_io_ptr(png));
  if (size > source->bytes.size() - source->at) png_error(png, "truncated");
  std::memcpy(out, source->bytes.data() + source->at, size);
  source->at += size;
}
void onError(png_structp png, png_const_charp message) {
  auto* source = static_cast<Source*>(png_get_error_ptr(png));
  std::strncpy(source->message, message, sizeof source->message - 1);
  png_longjmp(png, 1);
}
void onWarning(png_structp, png_const_charp) {}

/// libpng's state. The functions below hold only plain pointers across their setjmp.
struct Decoder {
  png_structp png = nullptr;
  png_infop info = nullptr;
  ~Decoder() { png_destroy_read_struct(&png, &info, nullptr); }
};

/// Up to the first row; afterwards every row is 8-bit RGBA. gAMA, cHRM and iCCP are left unapplied (glTF 2.0, 3.8.2).
bool readHeader(png_structp png, png_infop info) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_set_user_limits(png, kMaxImageSide, kMaxImageSide);
  png_set_chunk_malloc_max(png, 8 << 20);
  png_read_info(png, info);
  png_set_expand(png);
  png_set_scale_16(png);
  png_set_gray_to_rgb(png);
  png_set_add_alpha(png, 0xff, PNG_FILLER_AFTER);
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  return true;
}

bool readRows(png_structp png, png_infop info, png_bytepp rows) {
  if (setjmp(png_jmpbuf(png))) return false;
  png_read_image(png, rows);
  png_read_end(png, info);  // also checks the checksums behind the pixels and that the file is whole
  return true;
}

}  // namespace

Result<Image> decodePng(std::span<const std::byte> bytes, std::uint64_t maxPixels) {
  Source source{bytes};
  const auto damaged = [&] {
    return failed(std::string("is a damaged PNG: libpng: ") + (*source.message ? source.message : "out of memory"));
  };
  Decoder decoder;
  decoder.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &source, onError, onWarning);
  decoder.info = decoder.png ? png_create_info_struct(decoder.png) : nullptr;
  if (!decoder.info) return damaged();
  png_set_read_fn(decoder.png, &source, read);
  if (!readHeader(decoder.png, decoder.info)) return damaged();
  Image image;
  image.width = png_get_image_width(decoder.png, decoder.info);
  image.height = png_get_image_height(decoder.png, decoder.info);
  if (auto size = checkImageSize(image.width, image.height, maxPixels); !size) return size.error();
  if (png_get_rowbytes(decoder.png, decoder.info) != 4ull * image.width) return failed("is a PNG of an unknown kind");
  image.rgba.resize(4ull * image.width * image.height);
  std::vector<png_bytep> rows(image.height);
  for (std::size_t y = 0; y < rows.size(); ++y) rows[y] = image.rgba.data() + 4ull * image.width * y;
  if (!readRows(decoder.png, decoder.info, rows.data())) return damaged();
  return image;
}

}  // namespace tyndall::scene
