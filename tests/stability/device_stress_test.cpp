// shaders/lib on the device under the stress that the CPU takes: the same stored inputs, results against long double.
#include <functional>

#include "bias_search.hpp"
#include "gpu_test.hpp"
#include "medium_cases.hpp"
#include "shaders/record.h"

namespace tyndall::stability {
namespace {

using gpu::test::bytesOf;
using gpu::test::isOk;

class DeviceStress : public gpu::test::GpuTest {
 protected:
  void SetUp() override {
    GpuTest::SetUp();
    gpu::ShaderFolder folder(std::filesystem::path(TYNDALL_STABILITY_SHADERS));
    auto shader = folder.get("maths.comp");
    TY_EXPECT_OK(shader);
    auto made = createPipeline(
        *device,
        gpu::ComputePipelineDesc{.name = "maths", .shader = *shader, .bindings = {{0}, {1}}, .pushConstantBytes = 4});
    TY_EXPECT_OK(made);
    pipeline_.emplace(made.take());
    constexpr VkBufferUsageFlags kUsage =
        VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT;
    auto in = device->createBuffer({.name = "records", .size = kBatch * sizeof(Record), .usage = kUsage});
    auto out = device->createBuffer({.name = "results", .size = kBatch * sizeof(glm::vec4), .usage = kUsage});
    TY_EXPECT_OK(in);
    TY_EXPECT_OK(out);
    in_.emplace(in.take());
    out_.emplace(out.take());
  }
  void TearDown() override {
    pipeline_.reset();
    in_.reset();
    out_.reset();
    GpuTest::TearDown();
  }

  std::vector<glm::vec4> run(const std::vector<Record>& records) {
    TY_EXPECT_OK(device->upload(*in_, bytesOf(records)));
    const auto count = static_cast<std::uint32_t>(records.size());
    TY_EXPECT_OK(device->submitAndWait([&](VkCommandBuffer commands) {
      vkCmdBindPipeline(commands, pipeline_->bindPoint(), pipeline_->handle());
      gpu::Descriptors(commands, *pipeline_).storageBuffer(0, in_->handle()).storageBuffer(1, out_->handle()).push();
      vkCmdPushConstants(commands, pipeline_->layout(), VK_SHADER_STAGE_ALL, 0, sizeof count, &count);
      vkCmdDispatch(commands, (count + 63) / 64, 1, 1);
    }));
    auto bytes = device->readback(*out_);
    EXPECT_TRUE(bytes.ok());
    auto results = gpu::test::valuesOf<glm::vec4>(*bytes);
    results.resize(records.size());
    return results;
  }

  /// `cases` cases in batches: `make` gives a case and its record, `check` takes the case and the device's result.
  template <class Case>
  void forCases(std::uint64_t cases, const std::function<Record(Case&)>& make,
                const std::function<void(const Case&, const glm::vec4&)>& check) {
    for (std::uint64_t done = 0; done < cases && !HasFatalFailure();) {
      std::vector<Case> batch(std::min<std::uint64_t>(kBatch, cases - done));
      std::vector<Record> records;
      for (Case& c : batch) records.push_back(make(c));
      const std::vector<glm::vec4> results = run(records);
      for (std::size_t i = 0; i < batch.size(); ++i) check(batch[i], results[i]);
      done += batch.size();
    }
  }

 private:
  static constexpr std::size_t kBatch = 32768;
  std::optional<gpu::Pipeline> pipeline_;
  std::optional<gpu::Buffer> in_, out_;
};

struct MomentCase {
  Texel texel;
  float zf = 0;
  Truth truth;
};

TEST_F(DeviceStress, MomentsHoldTheirBounds) {
  for (const Format& format : kFormats) {
    const MomentStorage s = storageOf(format);
    Random random{11};
    Row row{.routine = format.moments == 4 ? "visibility4, device" : "visibility6, device",
            .precision = format.name,
            .cases = shareOfCases(0.016),
            .error = 0,
            .violation = 0,
            .paperBias = format.paper,
            .bias = static_cast<double>(s.bias)};
    forCases<MomentCase>(
        row.cases,
        [&](MomentCase& c) {
          const Blockers blockers = makeBlockers(random);
          const auto b = momentsOf(blockers);
          std::array<float, 7> rounded{};
          for (std::size_t i = 0; i < b.size(); ++i) rounded[i] = static_cast<float>(b[i]);
          c = {stored(format, rounded), rayDepth(random, blockers.z), {}};
          c.truth = visibilityAt(blockers, c.zf);
          const Texel& t = c.texel;
          if (format.moments == 4)
            return Record{
                kVisibility4, s.quantise, {t.four.x, t.four.y, t.four.z, t.four.w, s.bias, s.evenTarget, c.zf}};
          return Record{
              kVisibility6, s.quantise, {t.odd.x, t.odd.y, t.odd.z, t.even.x, t.even.y, t.even.z, s.bias, c.zf}};
        },
        [&](const MomentCase& c, const glm::vec4& got) {
          for (int side = 0; side < 2; ++side) {
            ASSERT_TRUE(got[side] >= 0 && got[side] <= 1) << got[side];
            const long double exact = visibility<long double>(format, c.texel, s.bias, c.zf, static_cast<float>(side));
            raise(row.error, static_cast<double>(std::abs(static_cast<long double>(got[side]) - exact)));
          }
          raise(row.violation,
                std::max(static_cast<double>(got.x) - c.truth.high, c.truth.low - static_cast<double>(got.y)));
        });
    report(row);
    EXPECT_LT(row.violation, row.bias + kSlack) << format.name;
  }
}

TEST_F(DeviceStress, TwoDepthsKeepTheMoments) {
  Random random{12};
  Row row{.routine = "twoDepths, device", .precision = "float", .cases = shareOfCases(0.01), .error = 0};
  forCases<glm::dvec3>(
      row.cases,
      [&](glm::dvec3& c) {
        const auto b = momentsOf(makeBlockers(random));
        c = {b[1], b[2], b[3]};
        return Record{kTwoDepths, 0, {static_cast<float>(c.x), static_cast<float>(c.y), static_cast<float>(c.z)}};
      },
      [&](const glm::dvec3& c, const glm::vec4& got) {
        ASSERT_TRUE(got.x >= -1 && got.x <= got.y && got.y <= 1 && got.z >= 0 && got.w >= 0) << got.x << ' ' << got.y;
        ASSERT_NEAR(static_cast<double>(got.z + got.w), 1, 1e-6);
        const glm::dvec4 d(got);
        for (int power = 1; power <= 3; ++power)
          raise(row.error, std::abs(d.z * std::pow(d.x, power) + d.w * std::pow(d.y, power) - c[power - 1]));
      });
  report(row);
  EXPECT_LT(row.error, 4e-6);  // two_depths_test.cpp
}

TEST_F(DeviceStress, FourierAgreesWithDirectSums) {
  Random random{13};
  Row row{.routine = "fourier 4 to 128, device", .precision = "float", .cases = shareOfCases(0.004), .error = 0};
  forCases<glm::vec3>(
      row.cases,
      [&](glm::vec3& c) {
        c = {static_cast<float>(random.next()), static_cast<float>(random.next()),
             static_cast<float>(4 + random.below(125))};
        if (random.next() < 0.1) c.x = std::round(c.x);
        if (random.next() < 0.1) c.y = c.x;
        return Record{kFourier, 0, {c.x, c.y, c.z}};
      },
      [&](const glm::vec3& c, const glm::vec4& got) {
        long double sum = 0.5L;
        for (int i = 0; i < static_cast<int>(c.z); ++i) {
          const long double f = (2 * (i / 2) + 1) * 3.14159265358979323846L, x = f * static_cast<long double>(c.x),
                            z = f * static_cast<long double>(c.y);
          sum += 2 / f * (i % 2 == 0 ? std::sin(x) * std::cos(z) : -std::cos(x) * std::sin(z));
        }
        raise(row.error, static_cast<double>(std::abs(static_cast<long double>(got.x) - sum)));
      });
  report(row);
  EXPECT_LT(row.error, 1e-4);  // the CPU's 6e-5 and the device's own sine
}

// A compiler that reorders sums would make nothing of lostInSum().
TEST_F(DeviceStress, CompensatedAveragesForgetNothing) {
  Random random{14};
  Row row{.routine = "average of 4096 columns, compensated, device", .precision = "float", .cases = 256, .error = 0};
  double plain = 0;
  forCases<glm::vec3>(
      row.cases,
      [&](glm::vec3& c) {
        const double z = random.between(-1, 1);
        c = {static_cast<float>(z + random.decades(1e-7, 1e-4)), static_cast<float>(z), 4096};
        return Record{kAverage, 0, {c.x, c.y, c.z}};
      },
      [&](const glm::vec3& c, const glm::vec4& got) {
        const double truth = (static_cast<double>(c.x) + 4095 * static_cast<double>(c.y)) / 4096;
        raise(row.error, std::abs(static_cast<double>(got.x) - truth));
        raise(plain, std::abs(static_cast<double>(got.y) - truth));
      });
  report(row);
  report(
      {.routine = "average of 4096 columns, plain, device", .precision = "float", .cases = row.cases, .error = plain});
  EXPECT_LT(row.error, 1.2e-7);  // an ulp below 1
  EXPECT_GT(plain, 1e-6) << "the plain average has become exact: lostInSum() is no longer needed";
}

TEST_F(DeviceStress, MediumAgreesWithLongDouble) {
  for (int r = 0; r < static_cast<int>(Routine::kCount); ++r) {
    const RoutineRow& about = kRoutines[static_cast<std::size_t>(r)];
    Random random{static_cast<std::uint64_t>(200 + r)};
    Row row{.routine = std::string(about.name) + ", device",
            .precision = "float",
            .cases = shareOfCases(0.001),
            .error = 0};
    MediumCase worst{};
    forCases<MediumCase>(
        row.cases,
        [&](MediumCase& c) {
          c = makeMediumCase(random, static_cast<Routine>(r));
          return Record{kMedium, r, {c.in[0], c.in[1], c.in[2], c.in[3]}};
        },
        [&](const MediumCase& c, const glm::vec4& got) {
          ASSERT_TRUE(std::isfinite(got.x) && std::isfinite(got.y))
              << about.name << " of " << c.in[0] << ' ' << c.in[1];
          const double error = errorOf(c, {got.x, got.y});
          if (!(error <= row.error)) worst = c;
          raise(row.error, error);
        });
    report(row);
    // A device's exp, log, division and atan err by several ulp where the CPU's err by half: ten times the CPU's
    // tolerance (lavapipe needs 4.2 times, for atan).
    EXPECT_LT(row.error, 10 * about.allowed)
        << about.name << " of " << worst.in[0] << ' ' << worst.in[1] << ' ' << worst.in[2];
  }
}

}  // namespace
}  // namespace tyndall::stability
