#include "report.hpp"

#include <cstdio>
#include <cstdlib>
#include <vector>

#include <gtest/gtest.h>

namespace tyndall::stability {
namespace {

std::vector<Row>& rows() {
  static std::vector<Row> all;
  return all;
}

std::string text(double value) {
  if (std::isnan(value)) return "–";
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.2g", value);
  return buffer;
}

class Table : public testing::Environment {
 public:
  void TearDown() override {
    if (rows().empty()) return;
    std::printf(
        "| routine | precision | cases | worst error vs long double | the same of double | worst bound violation | "
        "smallest safe bias found | paper's bias | ours |\n|---|---|---|---|---|---|---|---|---|\n");
    for (const Row& row : rows())
      std::printf("| %s | %s | %llu | %s | %s | %s | %s | %s | %s |\n", row.routine.c_str(), row.precision.c_str(),
                  static_cast<unsigned long long>(row.cases), text(row.error).c_str(), text(row.doubleError).c_str(),
                  text(row.violation).c_str(), text(row.safeBias).c_str(), text(row.paperBias).c_str(),
                  text(row.bias).c_str());
  }
};
[[maybe_unused]] testing::Environment* const table = testing::AddGlobalTestEnvironment(new Table);

}  // namespace

void report(const Row& row) { rows().push_back(row); }

std::uint64_t stressCases() {
  const char* wanted = std::getenv("TYNDALL_STRESS_CASES");
  if (!wanted) return 1000000;
  char* end = nullptr;
  const unsigned long long cases = std::strtoull(wanted, &end, 10);
  if (*end != 0 || cases < 1000) {
    std::fprintf(stderr, "TYNDALL_STRESS_CASES: \"%s\" is not a number of cases; give a whole number from 1000 on\n",
                 wanted);
    std::exit(2);
  }
  return cases;
}

}  // namespace tyndall::stability
