// The pipeline cache's file: written when there is something to keep, damage survived.
#include <cstdlib>

#include "gpu_test.hpp"
#include "pipeline_cache.hpp"

namespace tyndall::gpu::test {
namespace {

namespace fs = std::filesystem;

class GpuPipelineCache : public testing::Test {
 protected:
  void SetUp() override {
    if (const char* old = std::getenv("XDG_CACHE_HOME")) old_ = old, had_ = true;
    ::setenv("XDG_CACHE_HOME", cache.path().c_str(), 1);
  }
  void TearDown() override { had_ ? ::setenv("XDG_CACHE_HOME", old_.c_str(), 1) : ::unsetenv("XDG_CACHE_HOME"); }
  /// Makes a pipeline and lets the device go, which writes the cache.
  void run() {
    auto device = Device::create({});
    ASSERT_TRUE(device.ok()) << device.error().message;
    const auto shader = compile(
        "comp", "layout(local_size_x = 1) in; layout(binding = 0) buffer B { uint n; }; void main() { n = 1; }");
    auto pipeline = createPipeline(**device, ComputePipelineDesc{.name = "p", .shader = shader, .bindings = {{0}}});
    EXPECT_TRUE(pipeline.ok());
    EXPECT_NE((*device)->pipelineCache(), VkPipelineCache{});
    *pipeline = Pipeline();
  }
  TempFolder cache;

 private:
  std::string old_;
  bool had_ = false;
};

TEST(PipelineCacheFile, ComesBackAndDamageIsSeen) {
  std::vector<std::byte> data(1000);
  for (std::size_t i = 0; i < data.size(); ++i) data[i] = static_cast<std::byte>(i * 7);
  const auto file = packCache(data);
  ASSERT_EQ(unpackCache(file), data);
  for (std::size_t at = 0; at < file.size(); at += 13) {
    auto damaged = file;
    damaged[at] ^= std::byte{4};
    EXPECT_FALSE(unpackCache(damaged).has_value()) << at;
    EXPECT_FALSE(unpackCache(std::span(file).first(at)).has_value()) << at;
  }
}

TEST_F(GpuPipelineCache, ADamagedFileIsIgnored) {
  fs::path file;
  {
    auto device = Device::create({});
    ASSERT_TRUE(device.ok());
    file = (*device)->state().pipelineCacheFile;
  }
  EXPECT_EQ(file.parent_path().parent_path(), cache.path());
  for (const std::string content : {"", "short", "something that is longer than the header of the file"}) {
    fs::create_directories(file.parent_path());
    std::ofstream(file) << content;
    run();
  }
}

TEST_F(GpuPipelineCache, AFolderThatCannotBeWrittenIsNoError) {
  ::setenv("XDG_CACHE_HOME", "/proc/nowhere", 1);
  run();
}

}  // namespace
}  // namespace tyndall::gpu::test
