// tyndall-make-levels OUTPUT_DIR: writes every sample level there, as NAME.glb.
#include <filesystem>
#include <iostream>

#include "levels/levels.hpp"
#include "scene/write_glb.hpp"

int main(int argc, char** argv) {
  using namespace tyndall;
  if (argc != 2) {
    std::cerr << "tyndall-make-levels: one argument is needed, the folder to write to\n";
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    std::cerr << folder.string() << ": cannot be created: " << error.message() << '\n';
    return 1;
  }
  for (const levels::Sample& sample : levels::kSamples) {
    const auto written = scene::writeGlb(sample.make(), folder / (std::string(sample.name) + ".glb"));
    if (!written) {
      std::cerr << written.error().message << '\n';
      return 1;
    }
  }
  return 0;
}
