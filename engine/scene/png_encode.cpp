#include <png.h>

#include <csetjmp>
#include <cstring>

#include "png.hpp"

namespace tyndall::scene {
namespace {

struct Sink {
  std::vector<std::byte> bytes;
  char message[160] = {};
};

void append(png_structp png, png_bytep data, png_size_t size) {
  auto* sink = static_cast<Sink*>(png_get_io_ptr(png));
  const auto* begin = reinterpret_cast<const std::byte*>(data);
  sink->bytes.insert(sink->bytes.end(), begin, begin + size);
}
void flush(png_structp) {}
void onError(png_structp png, png_const_charp message) {
  auto* sink = static_cast<Sink*>(png_get_error_ptr(png));
  std::strncpy(sink->message, message, sizeof sink->message - 1);
  png_longjmp(png, 1);
}
void onWarning(png_structp, png_const_charp) {}

/// Only plain pointers live across the setjmp, so that a longjmp skips no destructor.
bool write(Sink* sink, const png_byte* pixels, png_uint_32 width, png_uint_32 height, bool opaque) {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, sink, onError, onWarning);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  if (!info) {
    png_destroy_write_struct(&png, nullptr);
    return false;
  }
  if (setjmp(png_jmpbuf(png))) {
    png_destroy_write_struct(&png, &info);
    return false;
  }
  png_set_write_fn(png, sink, append, flush);
  png_set_IHDR(png, info, width, height, 8, opaque ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGB_ALPHA, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  if (opaque) png_set_filler(png, 0, PNG_FILLER_AFTER);  // the rows hold four bytes a pixel; the fourth is dropped
  for (png_uint_32 y = 0; y < height; ++y) png_write_row(png, pixels + 4ull * width * y);
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return true;
}

}  // namespace

Result<std::vector<std::byte>> encodePng(const Image& image) {
  bool opaque = true;
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) opaque = opaque && image.rgba[i] == 255;
  Sink sink;
  if (!write(&sink, image.rgba.data(), image.width, image.height, opaque))
    return failed("image \"" + image.name + "\": libpng: " + (*sink.message ? sink.message : "out of memory"));
  return std::move(sink.bytes);
}

}  // namespace tyndall::scene
