// What the gpu tests share: a device, shaders written in the test, bytes of plain values.
#pragma once

#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <unistd.h>

#include <gtest/gtest.h>

#include "gpu/device.hpp"
#include "gpu/pipeline.hpp"
#include "gpu/shader.hpp"

namespace tyndall::gpu::test {

/// A folder of this test's own that goes with it.
class TempFolder {
 public:
  TempFolder() {
    static int count = 0;
    path_ = std::filesystem::temp_directory_path() /
            ("tyndall-gpu-" + std::to_string(::getpid()) + "-" + std::to_string(count++));
    std::filesystem::create_directories(path_);
  }
  ~TempFolder() {
    std::error_code none;
    std::filesystem::remove_all(path_, none);
  }
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name) << text;
    return path_ / name;
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline std::shared_ptr<const Shader> compile(const std::string& stage, const std::string& text) {
  TempFolder folder;
  auto code = compileGlsl(
      folder.write("test." + stage + ".glsl", "#version 460\n#extension GL_EXT_scalar_block_layout : require\n" + text),
      stage, {});
  EXPECT_TRUE(code.ok()) << (code.ok() ? "" : code.error().message);
  if (!code) return nullptr;
  return std::make_shared<Shader>(Shader{"test." + stage, code.take(), 1});
}

template <class T>
std::span<const std::byte> bytesOf(const std::vector<T>& values) {
  return std::as_bytes(std::span(values));
}

template <class T>
std::vector<T> valuesOf(const std::vector<std::byte>& bytes) {
  std::vector<T> values(bytes.size() / sizeof(T));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(T));
  return values;
}

/// A device with validation on; the test's end finds it silent.
class GpuTest : public testing::Test {
 protected:
  void SetUp() override {
    DeviceOptions options;
    options.validation = true;
    auto made = Device::create(options);
    ASSERT_TRUE(made.ok()) << made.error().message;
    device = made.take();
  }
  void TearDown() override {
    if (!device) return;
    EXPECT_TRUE(device->waitIdle().ok());
    EXPECT_EQ(device->validationMessages(), expectedMessages);
    device.reset();
  }
  std::unique_ptr<Device> device;
  std::uint32_t expectedMessages = 0;
};

template <class R>
testing::AssertionResult isOk(const char* expression, const R& result) {
  if (result.ok()) return testing::AssertionSuccess();
  return testing::AssertionFailure() << expression << ": " << result.error().message;
}
#define TY_EXPECT_OK(result) EXPECT_PRED_FORMAT1(isOk, result)

}  // namespace tyndall::gpu::test
