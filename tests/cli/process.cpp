#include "process.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

namespace tyndall::cli {
namespace fs = std::filesystem;

std::string readText(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void writeText(const fs::path& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
}

std::vector<std::string> Outcome::errorLines() const {
  std::vector<std::string> lines;
  std::istringstream stream(err);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

Outcome run(const fs::path& folder, const std::vector<std::string>& arguments, const Environment& environment) {
  char outName[] = "/tmp/tyndall-cli-out-XXXXXX", errName[] = "/tmp/tyndall-cli-err-XXXXXX";
  const int out = mkstemp(outName), err = mkstemp(errName);
  std::string program = std::string(TYNDALL_BIN_DIR) + "/tyndall";
  std::vector<std::string> words = arguments;
  std::vector<char*> pointers{program.data()};
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    for (const auto& [name, value] : environment) setenv(name.c_str(), value.c_str(), 1);
    const int none = open("/dev/null", O_RDONLY);
    if (chdir(folder.c_str()) != 0 || dup2(none, 0) < 0 || dup2(out, 1) < 0 || dup2(err, 2) < 0) _exit(126);
    execv(program.c_str(), pointers.data());
    _exit(127);
  }
  int state = 0;
  waitpid(child, &state, 0);
  close(out);
  close(err);
  Outcome outcome;
  outcome.status = WIFEXITED(state) ? WEXITSTATUS(state) : 1000 + WTERMSIG(state);
  outcome.out = readText(outName);
  outcome.err = readText(errName);
  unlink(outName);
  unlink(errName);
  return outcome;
}

void CliTest::SetUp() {
  std::string name = (fs::temp_directory_path() / "tyndall-cli-XXXXXX").string();
  ASSERT_NE(mkdtemp(name.data()), nullptr);
  folder_ = name;
}

void CliTest::TearDown() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

std::vector<std::string> CliTest::techniques() const {
  const Outcome described = tyndall({"describe", "--json"});
  EXPECT_EQ(described.status, 0) << described.err;
  std::vector<std::string> ids;
  const auto parsed = nlohmann::json::parse(described.out);
  for (const auto& plugin : parsed.at("plugins"))
    for (const auto& technique : plugin.at("techniques")) ids.push_back(technique.at("id"));
  EXPECT_FALSE(ids.empty());
  return ids;
}

std::vector<std::string> CliTest::files() const {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder_))
    names.push_back(entry.path().lexically_relative(folder_).string());
  std::sort(names.begin(), names.end());
  return names;
}

void CliTest::expectRefused(const std::vector<std::string>& arguments, int status,
                            const std::vector<std::string>& words, const Environment& environment) const {
  std::string call = "tyndall";
  for (const std::string& argument : arguments) call += " '" + argument + "'";
  SCOPED_TRACE(call);
  const std::vector<std::string> before = files();
  const Outcome outcome = tyndall(arguments, environment);
  EXPECT_EQ(outcome.status, status) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.errorLines().size(), 1u) << outcome.err;
  EXPECT_EQ(outcome.err.rfind("tyndall: ", 0), 0u) << outcome.err;
  for (const std::string& word : words)
    EXPECT_NE(outcome.err.find(word), std::string::npos) << "'" << word << "' is not in: " << outcome.err;
  EXPECT_EQ(files(), before);
}

}  // namespace tyndall::cli
