// Shaders on the CPU side: compilation, includes, messages, reload.
#include <chrono>

#include "gpu_test.hpp"

namespace tyndall::gpu::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kHead = "#version 460\n#extension GL_GOOGLE_include_directive : require\n";

/// Gives the file a time later than any before, whatever the file system's clock resolves.
void touch(const fs::path& file) {
  static auto next = fs::file_time_type::clock::now() + std::chrono::seconds(5);
  fs::last_write_time(file, next += std::chrono::seconds(5));
}

/// A folder as the build leaves it: <name>.spv and <name>.spv.json beside sources that lie elsewhere.
struct BuiltShader {
  TempFolder sources, includes, built;
  fs::path source;
  explicit BuiltShader(const std::string& text) {
    source = sources.write("a.comp.glsl", kHead + text);
    std::ofstream(built.path() / "a.comp.spv.json")
        << "{ \"source\": \"" << source.string() << "\", \"stage\": \"comp\", \"includes\": [\""
        << includes.path().string() << "\"] }\n";
  }
  void build() {
    auto code = compileGlsl(source, "comp", {includes.path()});
    ASSERT_TRUE(code.ok()) << code.error().message;
    std::ofstream(built.path() / "a.comp.spv", std::ios::binary)
        .write(reinterpret_cast<const char*>(code->data()), static_cast<std::streamsize>(code->size() * 4));
  }
};

const std::string kBody = "layout(local_size_x = 1) in; layout(binding = 0) buffer B { float v; };\n";

TEST(Shader, TheBuildAndTheProgramCompileAlike) {
  ShaderFolder folder(fs::path(TYNDALL_TEST_SHADERS));
  auto built = folder.get("built.comp");
  ASSERT_TRUE(built.ok()) << built.error().message;
  EXPECT_EQ((*built)->name, "built.comp");
  const fs::path sources = fs::path(TYNDALL_TEST_SOURCES) / "shaders";
  auto compiled = compileGlsl(sources / "built.comp.glsl", "comp", {});
  ASSERT_TRUE(compiled.ok()) << compiled.error().message;
  EXPECT_EQ(*compiled, (*built)->code);
  const auto reload = folder.reloadChanged();
  EXPECT_TRUE(reload.changed.empty());
  EXPECT_TRUE(reload.errors.empty());
  EXPECT_EQ(folder.get("built.comp")->get(), built->get()) << "loaded twice";
}

TEST(Shader, IncludesComeFromBesideTheIncluderThenFromTheFolders) {
  TempFolder sources, other;
  fs::create_directories(sources.path() / "deep");
  std::ofstream(sources.path() / "deep/one.glsl") << "#include \"two.glsl\"\n";
  std::ofstream(sources.path() / "deep/two.glsl") << "float two() { return 2.0; }\n#include \"three.glsl\"\n";
  other.write("two.glsl", "#error the wrong two\n");
  other.write("three.glsl", "float three() { return 3.0; }\n");
  const auto source = sources.write(
      "main.comp.glsl", kHead + ("#include \"deep/one.glsl\"\n" + kBody) + "void main() { v = two() + three(); }\n");
  auto code = compileGlsl(source, "comp", {other.path()});
  EXPECT_TRUE(code.ok()) << code.error().message;
}

TEST(Shader, ErrorsNameTheFileTheLineAndTheReasonInOneLine) {
  TempFolder sources;
  const auto wrong = sources.write("wrong.comp.glsl", kHead + kBody + "void main() { v = nothing; }\n");
  auto code = compileGlsl(wrong, "comp", {});
  ASSERT_FALSE(code.ok());
  EXPECT_NE(code.error().message.find("wrong.comp.glsl:4"), std::string::npos) << code.error().message;
  EXPECT_NE(code.error().message.find("'nothing' : undeclared identifier"), std::string::npos) << code.error().message;
  EXPECT_EQ(code.error().message.find('\n'), std::string::npos) << code.error().message;
  const auto lost = sources.write(
      "lost.comp.glsl", kHead + std::string("#include \"not_there.glsl\"\n") + kBody + "void main() { v = 1; }\n");
  auto include = compileGlsl(lost, "comp", {});
  ASSERT_FALSE(include.ok());
  EXPECT_NE(include.error().message.find("not_there.glsl"), std::string::npos) << include.error().message;
  EXPECT_FALSE(compileGlsl(sources.path() / "missing.comp.glsl", "comp", {}).ok());
  EXPECT_FALSE(compileGlsl(wrong, "tessellation", {}).ok());
}

TEST(Shader, AMissingOrDamagedFileIsNamed) {
  TempFolder folder;
  folder.write("short.comp.spv", "abc");
  folder.write("text.comp.spv", "this is no SPIR-V, but long enough......");
  ShaderFolder shaders(folder.path());
  for (const std::string name : {"none.comp", "short.comp", "text.comp"}) {
    auto shader = shaders.get(name);
    ASSERT_FALSE(shader.ok());
    EXPECT_NE(shader.error().message.find(name + ".spv"), std::string::npos) << shader.error().message;
  }
}

TEST(ShaderReload, AChangedSourceGivesNewCodeAndABrokenOneKeepsTheOld) {
  BuiltShader built(kBody + "void main() { v = 1; }\n");
  built.build();
  ShaderFolder folder(built.built.path());
  const auto first = *folder.get("a.comp");
  EXPECT_TRUE(folder.reloadChanged().changed.empty());

  built.sources.write("a.comp.glsl", kHead + kBody + "void main() { v = 2; }\n");
  touch(built.source);
  auto reload = folder.reloadChanged();
  ASSERT_EQ(reload.changed, std::vector<std::string>{"a.comp"});
  const auto second = *folder.get("a.comp");
  EXPECT_NE(second->code, first->code);
  EXPECT_GT(second->version, first->version);

  built.sources.write("a.comp.glsl", kHead + kBody + "void main() { v = oops; }\n");
  touch(built.source);
  reload = folder.reloadChanged();
  EXPECT_TRUE(reload.changed.empty());
  ASSERT_EQ(reload.errors.size(), 1u);
  EXPECT_NE(reload.errors[0].message.find("oops"), std::string::npos);
  EXPECT_EQ(folder.get("a.comp")->get(), second.get());
  EXPECT_TRUE(folder.reloadChanged().errors.empty()) << "said twice about one change";

  built.sources.write("a.comp.glsl", kHead + kBody + "void main() { v = 3; }\n");
  touch(built.source);
  EXPECT_EQ(folder.reloadChanged().changed.size(), 1u);

  built.sources.write("a.comp.glsl", kHead + kBody + "// a comment\nvoid main() { v = 3; }\n");
  touch(built.source);
  EXPECT_TRUE(folder.reloadChanged().changed.empty()) << "the code is the same";
}

TEST(ShaderReload, AChangedIncludeOfAnIncludeIsSeen) {
  BuiltShader built("#include \"outer.glsl\"\n" + kBody + "void main() { v = f(); }\n");
  built.sources.write("outer.glsl", "#include <inner.glsl>\n");
  built.includes.write("inner.glsl", "float f() { return 1.0; }\n");
  built.build();
  ShaderFolder folder(built.built.path());
  ASSERT_TRUE(folder.get("a.comp").ok());
  EXPECT_TRUE(folder.reloadChanged().changed.empty());
  touch(built.includes.write("inner.glsl", "float f() { return 2.0; }\n"));
  EXPECT_EQ(folder.reloadChanged().changed.size(), 1u);
}

TEST(ShaderReload, SourcesNewerThanTheBuildAreSeenAtOnce) {
  BuiltShader built(kBody + "void main() { v = 1; }\n");
  built.build();
  built.sources.write("a.comp.glsl", kHead + kBody + "void main() { v = 2; }\n");
  touch(built.source);
  ShaderFolder folder(built.built.path());
  ASSERT_TRUE(folder.get("a.comp").ok());
  EXPECT_EQ(folder.reloadChanged().changed.size(), 1u);
}

TEST(ShaderReload, WithoutSourcesNothingChanges) {
  BuiltShader built(kBody + "void main() { v = 1; }\n");
  built.build();
  fs::remove(built.source);
  ShaderFolder folder(built.built.path());
  ASSERT_TRUE(folder.get("a.comp").ok());
  const auto reload = folder.reloadChanged();
  EXPECT_TRUE(reload.changed.empty());
  EXPECT_TRUE(reload.errors.empty());
}

}  // namespace
}  // namespace tyndall::gpu::test
