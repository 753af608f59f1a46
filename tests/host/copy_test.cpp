// Where the copies of plugins are loaded from: memory, folders that may be full or noexec, the file itself.
#include <csignal>
#include <deque>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <unistd.h>

#include "base/file.hpp"
#include "host/host.hpp"
#include "library.hpp"
#include "temporary_folder.hpp"

namespace tyndall::host {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

fs::path good() { return fs::path(TYNDALL_TEST_PLUGINS) / "good.so"; }

/// A file system of its own on a folder; `there()` is false where this process may not mount one.
class Mount {
 public:
  Mount(const fs::path& folder, unsigned long flags, const char* options) : folder_(folder) {
    fs::create_directory(folder_);
    mounted_ = ::mount("none", folder_.c_str(), "tmpfs", flags, options) == 0;
  }
  ~Mount() {
    if (mounted_) ::umount2(folder_.c_str(), MNT_DETACH);
  }
  bool there() const { return mounted_; }

 private:
  fs::path folder_;
  bool mounted_ = false;
};

const LoadedCopy* loaded(const std::variant<LoadedCopy, NoCopy>& tried) { return std::get_if<LoadedCopy>(&tried); }

struct Copy : testing::Test {
  test::TemporaryFolder folder_;
  std::vector<std::byte> bytes_ = *readFile(good());
  std::size_t entries(const fs::path& folder) const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
  }
};

TEST_F(Copy, leavesNothingOnDiskWhileItIsLoaded) {
  const auto inMemory = loadFromMemory(good(), bytes_), inFolder = loadFromFolder(folder_.path(), good(), bytes_);
  ASSERT_TRUE(loaded(inMemory)) << std::get<NoCopy>(inMemory).reason;
  ASSERT_TRUE(loaded(inFolder)) << std::get<NoCopy>(inFolder).reason;
  EXPECT_NE(loaded(inMemory)->handle, loaded(inFolder)->handle) << "two copies, two libraries";
  EXPECT_EQ(entries(folder_.path()), 0u);
}

TEST_F(Copy, hundredTogetherAreHundredLibraries) {
  std::set<void*> handles;
  std::deque<std::variant<LoadedCopy, NoCopy>> all;
  for (int i = 0; i < 100; ++i) {
    all.push_back(i % 2 ? loadFromMemory(good(), bytes_) : loadFromFolder(folder_.path(), good(), bytes_));
    ASSERT_TRUE(loaded(all.back())) << i;
    handles.insert(loaded(all.back())->handle);
    if (i % 3 == 0) all.pop_front();  // numbers of files are used again meanwhile
  }
  std::set<void*> alive;
  for (const auto& one : all) alive.insert(loaded(one)->handle);
  EXPECT_EQ(alive.size(), all.size());
}

TEST_F(Copy, aPlaceThatGivesNoneIsNotTheLibrarysFault) {
  const auto none = loadFromFolder(folder_.path() / "missing", good(), bytes_);
  ASSERT_FALSE(loaded(none));
  EXPECT_TRUE(std::get<NoCopy>(none).place);
  const fs::path unresolved = good().parent_path() / "unresolved.so";
  const auto broken = loadFromMemory(unresolved, *readFile(unresolved));
  ASSERT_FALSE(loaded(broken));
  EXPECT_FALSE(std::get<NoCopy>(broken).place);
  EXPECT_THAT(std::get<NoCopy>(broken).reason, HasSubstr("unresolved.so: undefined symbol"));
}

TEST_F(Copy, noexecAndFullFoldersAreSeenAndLeftEmpty) {
  const Mount noexec(folder_.path() / "noexec", MS_NOEXEC, "size=8m");
  const Mount full(folder_.path() / "full", 0, "size=4k");
  if (!noexec.there() || !full.there()) GTEST_SKIP() << "no file system can be mounted here";
  for (const char* name : {"noexec", "full"}) {
    const auto tried = loadFromFolder(folder_.path() / name, good(), bytes_);
    ASSERT_FALSE(loaded(tried)) << name;
    EXPECT_TRUE(std::get<NoCopy>(tried).place) << name;
    EXPECT_THAT(std::get<NoCopy>(tried).reason, HasSubstr(name));
    EXPECT_EQ(entries(folder_.path() / name), 0u) << name;
    // Where the folder for temporary files is like that, a plugin is loaded all the same.
    ::setenv("TMPDIR", (folder_.path() / name).c_str(), 1);
    EXPECT_TRUE(Plugin::load(good())) << name;
    ::unsetenv("TMPDIR");
  }
}

/// No file at all may be written: memory, TMPDIR and cache are one by one in vain.
TEST_F(Copy, whereNoneCanBeMadeTheFileItselfIsLoadedAndSaidToBe) {
  const fs::path file = folder_.path() / "variant.so";
  fs::copy_file(good(), file);
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit nothing{0, before.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &nothing);
  {
    testing::internal::CaptureStderr();  // into a file: reads what comes before the limit only
    auto plugin = Plugin::load(file);
    auto again = Plugin::load(file);
    ::setrlimit(RLIMIT_FSIZE, &before);
    (void)testing::internal::GetCapturedStderr();
    ASSERT_TRUE(plugin) << plugin.error().message;
    ASSERT_FALSE(again) << "two plugins in one mapping";
    EXPECT_THAT(again.error().message, HasSubstr("loaded already"));
    fs::last_write_time(file, fs::file_time_type::clock::now() + std::chrono::hours(1));
    EXPECT_FALSE((*plugin)->fileChanged()) << "it could not be reloaded";
  }
  std::signal(SIGXFSZ, handler);
}

}  // namespace
}  // namespace tyndall::host
