// The engine's pipelines: kept while frames ask for them, let go where there are many.
#include "pipeline_library.hpp"
#include "recipes.hpp"
#include "stage.hpp"

namespace tyndall::render::test {
namespace {

TEST(PipelineLibrary, ManyThatNoFrameAsksForGo) {
  auto device = gpu::Device::create({});
  ASSERT_TRUE(device) << device.error().message;
  PipelineLibrary library(**device, std::filesystem::path(TYNDALL_BIN_DIR) / "shaders");
  constexpr std::size_t kMany = 70, kOften = 3;
  const auto ask = [&](std::size_t i) {
    Recipe recipe = compositeRecipe(false, false);
    recipe.desc.name += " " + std::to_string(i);
    const auto made = library.get(recipe);
    ASSERT_TRUE(made) << made.error().message;
    EXPECT_TRUE((*made)->handle());
  };
  library.beginFrame();
  for (std::size_t i = 0; i < kMany; ++i) ask(i);
  EXPECT_EQ(library.size(), kMany);
  for (int frame = 0; frame < 1000; ++frame) {
    library.beginFrame();
    for (std::size_t i = 0; i < kOften; ++i) ask(i);
    if (frame == 500) {
      EXPECT_EQ(library.size(), kMany);
    }
  }
  EXPECT_EQ(library.size(), kOften);
  ask(kMany - 1);  // and comes back
  EXPECT_EQ(library.size(), kOften + 1);
  // Those of another scene go sooner, those that both ask for stay.
  for (std::size_t i = 0; i < kMany; ++i) ask(i);
  library.sceneChanged();
  for (int frame = 0; frame < 30; ++frame) {
    library.beginFrame();
    for (std::size_t i = 0; i < kOften; ++i) ask(i);
  }
  EXPECT_EQ(library.size(), kOften);
  ask(kMany - 1);
  // A few are kept however long nobody asks.
  for (int frame = 0; frame < 1000; ++frame) library.beginFrame();
  EXPECT_EQ(library.size(), kOften + 1);
}

}  // namespace
}  // namespace tyndall::render::test
