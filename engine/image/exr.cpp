// EXR through OpenEXR 3, by streams in memory. OpenEXR reports errors by exceptions: they end here.
#include <cstring>
#include <exception>
#include <limits>
#include <span>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>

#include "base/file.hpp"
#include "checks.hpp"
#include "image/image_io.hpp"

namespace tyndall::image {
namespace {

class MemoryOut final : public Imf::OStream {
 public:
  MemoryOut() : OStream("memory") {}
  void write(const char data[], int count) override {
    const auto size = static_cast<std::size_t>(count);
    if (position_ + size > bytes_.size()) bytes_.resize(position_ + size);
    std::memcpy(bytes_.data() + position_, data, size);
    position_ += size;
  }
  std::uint64_t tellp() override { return position_; }
  void seekp(std::uint64_t position) override { position_ = position; }
  std::span<const std::byte> bytes() const { return bytes_; }

 private:
  std::vector<std::byte> bytes_;
  std::size_t position_ = 0;
};

class MemoryIn final : public Imf::IStream {
 public:
  explicit MemoryIn(std::span<const std::byte> bytes) : IStream("memory"), bytes_(bytes) {}
  bool read(char data[], int count) override {
    const auto size = static_cast<std::size_t>(count);
    if (position_ > bytes_.size() || bytes_.size() - position_ < size) throw Iex::InputExc("unexpected end of file");
    std::memcpy(data, bytes_.data() + position_, size);
    position_ += size;
    return position_ < bytes_.size();
  }
  std::uint64_t tellg() override { return position_; }
  void seekg(std::uint64_t position) override { position_ = position; }

 private:
  std::span<const std::byte> bytes_;
  std::size_t position_ = 0;
};

using Names = std::vector<std::string>;

Names namesFor(std::uint32_t channels) {
  if (channels == 1) return {"Z"};
  if (channels == 3) return {"R", "G", "B"};
  return {"R", "G", "B", "A"};
}

/// The channels to read, empty when the file's set is none that we know.
Names namesIn(const Imf::ChannelList& list, std::string& all) {
  Names found;
  for (auto i = list.begin(); i != list.end(); ++i) {
    found.emplace_back(i.name());
    all += (all.empty() ? "" : ",") + found.back();
  }
  if (found.size() == 1) return found;
  if (!list.findChannel("R") || !list.findChannel("G") || !list.findChannel("B")) return {};
  return namesFor(list.findChannel("A") ? 4 : 3);
}

/// `origin` is the data window's corner; OpenEXR wants the address that pixel (0,0) would have, so addresses are
/// computed as integers.
Imf::FrameBuffer frameBuffer(float* values, std::uint32_t width, const Names& names, Imath::V2i origin) {
  const std::size_t pixelBytes = names.size() * sizeof(float);
  const std::size_t rowBytes = pixelBytes * width;
  Imf::FrameBuffer buffer;
  for (std::size_t c = 0; c < names.size(); ++c) {
    const auto corner = reinterpret_cast<std::intptr_t>(values + c);
    const auto base = corner - std::intptr_t{origin.x} * static_cast<std::intptr_t>(pixelBytes) -
                      std::intptr_t{origin.y} * static_cast<std::intptr_t>(rowBytes);
    buffer.insert(names[c], Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(base), pixelBytes, rowBytes));
  }
  return buffer;
}

Result<FloatImage> decode(const std::string& place, std::span<const std::byte> bytes) {
  MemoryIn stream(bytes);
  Imf::InputFile file(stream, 0);
  const Imath::Box2i window = file.header().dataWindow();
  const auto width = static_cast<std::uint64_t>(std::int64_t{window.max.x} - window.min.x + 1);
  const auto height = static_cast<std::uint64_t>(std::int64_t{window.max.y} - window.min.y + 1);
  if (auto size = checkSize(place, width, height); !size) return size.error();
  std::string all;
  const Names names = namesIn(file.header().channels(), all);
  if (names.empty()) return failed(place + ": its channels are " + all + "; R,G,B, R,G,B,A or a single one are read");
  for (const std::string& name : names) {
    const Imf::Channel& channel = file.header().channels()[name.c_str()];
    if (channel.xSampling != 1 || channel.ySampling != 1)
      return failed(place + ": channel " + name + " is subsampled; every channel must have every pixel");
  }
  FloatImage image{static_cast<std::uint32_t>(width),
                   static_cast<std::uint32_t>(height),
                   static_cast<std::uint32_t>(names.size()),
                   {}};
  image.values.resize(width * height * names.size());
  file.setFrameBuffer(frameBuffer(image.values.data(), image.width, names, window.min));
  file.readPixels(window.min.y, window.max.y);
  return image;
}

}  // namespace

Result<void> writeExr(const std::filesystem::path& path, const FloatImage& image) {
  if (auto size = checkSize(path.string(), image.width, image.height); !size) return size;
  TY_ASSERT(image.channels == 1 || image.channels == 3 || image.channels == 4, std::to_string(image.channels));
  assertComplete(image);
  try {
    const Names names = namesFor(image.channels);
    Imf::Header header(static_cast<int>(image.width), static_cast<int>(image.height));
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const std::string& name : names) header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    MemoryOut stream;
    {
      Imf::OutputFile file(stream, header, 0);  // its destructor writes the line offset table
      // Slices point to mutable memory for reading's sake; writing only reads them.
      file.setFrameBuffer(frameBuffer(const_cast<float*>(image.values.data()), image.width, names, {0, 0}));
      file.writePixels(static_cast<int>(image.height));
    }
    return writeFileAtomically(path, stream.bytes());
  } catch (const std::exception& error) {
    return failed(path.string() + ": cannot be encoded as EXR: " + error.what());
  }
}

Result<FloatImage> readExr(const std::filesystem::path& path) {
  auto bytes = readFile(path);
  if (!bytes) return bytes.error();
  try {
    return decode(path.string(), bytes.value());
  } catch (const std::exception& error) {
    return failed(path.string() + ": not a readable EXR file: " + error.what());
  }
}

}  // namespace tyndall::image
