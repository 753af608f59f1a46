#include <cstddef>
#include <cstdio>

#include <jpeglib.h>
// jpeglib.h first.
#include <jerror.h>

#include <csetjmp>
#include <cstring>

#include "image_decode.hpp"

namespace tyndall::scene {
namespace {

/// A progressive file may repeat tiny scans of a large picture for ever; encoders write about ten.
constexpr int kMaxScans = 200;

/// The library's structs first, so that its pointers convert to ours.
struct Errors {
  jpeg_error_mgr base;
  std::jmp_buf jump;
  char message[JMSG_LENGTH_MAX] = {};
};
struct Progress {
  jpeg_progress_mgr base;
};

[[noreturn]] void stop(j_common_ptr decoder) {
  auto* errors = reinterpret_cast<Errors*>(decoder->err);
  (*decoder->err->format_message)(decoder, errors->message);
  std::longjmp(errors->jump, 1);
}
/// Warnings (level -1) mean damaged data, except for the harmless ones.
void onMessage(j_common_ptr decoder, int level) {
  const int code = decoder->err->msg_code;
  if (level == -1 && code != JWRN_EXTRANEOUS_DATA && code != JWRN_ADOBE_XFORM && code != JWRN_TOO_MUCH_DATA)
    stop(decoder);
}
void onProgress(j_common_ptr decoder) {
  if (!decoder->is_decompressor) return;
  if (reinterpret_cast<j_decompress_ptr>(decoder)->input_scan_number > kMaxScans)
    ERREXIT(decoder, JERR_BAD_PROGRESSION);
}

struct Decoder {
  jpeg_decompress_struct state = {};
  Errors errors = {};
  Progress progress = {};
  ~Decoder() { jpeg_destroy_decompress(&state); }
};

// The functions that call setjmp hold nothing with a destructor, so that a longjmp skips none.

bool readHeader(Decoder* d, const unsigned char* data, unsigned long size) {
  d->state.err = jpeg_std_error(&d->errors.base);
  d->errors.base.error_exit = stop;
  d->errors.base.emit_message = onMessage;
  if (setjmp(d->errors.jump)) return false;
  jpeg_create_decompress(&d->state);
  d->progress.base.progress_monitor = onProgress;
  d->state.progress = &d->progress.base;
  d->state.mem->max_memory_to_use = 512l << 20;
  jpeg_mem_src(&d->state, data, size);
  jpeg_read_header(&d->state, TRUE);
  return true;
}

bool hasInks(const Decoder& d) { return d.state.jpeg_color_space == JCS_CMYK || d.state.jpeg_color_space == JCS_YCCK; }

/// Cyan, magenta, yellow and black to red, green, blue and opaque, in place: each ink takes its share of what black has
/// left. Adobe's files, which say so by a marker, store how much of each ink is missing.
void colorsOfInks(std::vector<std::uint8_t>& texels, bool inverted) {
  for (std::size_t i = 0; i < texels.size(); i += 4) {
    for (std::size_t c = i; !inverted && c < i + 4; ++c) texels[c] = static_cast<std::uint8_t>(255 - texels[c]);
    for (std::size_t c = i; c < i + 3; ++c)
      texels[c] = static_cast<std::uint8_t>((texels[c] * texels[i + 3] + 127) / 255);
    texels[i + 3] = 255;
  }
}

bool readRows(Decoder* d, unsigned char* rgba) {
  if (setjmp(d->errors.jump)) return false;
  d->state.out_color_space = hasInks(*d) ? JCS_CMYK : JCS_EXT_RGBA;  // libjpeg-turbo; alpha 255
  jpeg_start_decompress(&d->state);
  while (d->state.output_scanline < d->state.output_height) {
    JSAMPROW row = rgba + 4ull * d->state.output_width * d->state.output_scanline;
    jpeg_read_scanlines(&d->state, &row, 1);
  }
  jpeg_finish_decompress(&d->state);
  return true;
}

}  // namespace

Result<Image> decodeJpeg(std::span<const std::byte> bytes, std::uint64_t maxPixels) {
  Decoder decoder;
  const auto damaged = [&] { return failed(std::string("is an unusable JPEG: libjpeg: ") + decoder.errors.message); };
  if (!readHeader(&decoder, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size())) return damaged();
  Image image;
  image.width = decoder.state.image_width;
  image.height = decoder.state.image_height;
  if (auto size = checkImageSize(image.width, image.height, maxPixels); !size) return size.error();
  image.rgba.resize(4ull * image.width * image.height);
  if (!readRows(&decoder, image.rgba.data())) return damaged();
  if (hasInks(decoder)) colorsOfInks(image.rgba, decoder.state.saw_Adobe_marker);
  return image;
}

}  // namespace tyndall::scene
