// Choice and refusal of devices; what the validation layer hears.
#include <cstdlib>

#include "gpu_test.hpp"
#include "state.hpp"

namespace tyndall::gpu::test {
namespace {

class Environment {
 public:
  Environment(const char* name, const char* value) : name_(name) {
    if (const char* old = std::getenv(name)) old_ = old, had_ = true;
    ::setenv(name, value, 1);
  }
  ~Environment() { had_ ? ::setenv(name_, old_.c_str(), 1) : ::unsetenv(name_); }

 private:
  const char* name_;
  std::string old_;
  bool had_ = false;
};

TEST(GpuDevice, HeadlessDeviceKnowsItself) {
  auto device = Device::create({});
  ASSERT_TRUE(device.ok()) << device.error().message;
  const DeviceInfo& info = (*device)->info();
  EXPECT_FALSE(info.name.empty());
  EXPECT_FALSE(info.driver.empty());
  EXPECT_GE(info.maxPushDescriptors, 32u);
  EXPECT_GE(info.limits.maxPushConstantsSize, 128u);
  EXPECT_GT(info.timestampPeriodNs, 0);
  EXPECT_GT(info.subgroupSize, 0u);
  EXPECT_EQ((*device)->submittedFrames(), 0u);
}

TEST(GpuDevice, IsFoundByAPartOfItsNameAndByItsIndex) {
  std::string name;
  {
    auto device = Device::create({.name = "0"});
    ASSERT_TRUE(device.ok()) << device.error().message;
    name = (*device)->info().name;
  }
  std::string part = name.substr(1, 5);
  for (char& c : part) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  auto device = Device::create({.name = part});
  ASSERT_TRUE(device.ok()) << device.error().message;
  EXPECT_EQ((*device)->info().name, name);
}

TEST(GpuDevice, ANumberIsAnIndexAndNeverPartOfAName) {
  using List = std::vector<std::size_t>;
  const std::vector<std::string> names{"Radeon 1100", "GeForce 4090", "llvmpipe (LLVM 15.0.6, 256 bits)"};
  EXPECT_EQ(matchingDevices(names, ""), (List{0, 1, 2}));
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(matchingDevices(names, std::to_string(i)), List{i});
    EXPECT_EQ(matchingDevices(names, "00" + std::to_string(i)), List{i});
  }
  for (const char* beyond : {"3", "11", "15", "256", "4090", "99999999999999999999"})
    EXPECT_EQ(matchingDevices(names, beyond), List{}) << beyond;
  EXPECT_EQ(matchingDevices({"llvmpipe (LLVM 15.0.6, 256 bits)"}, "1"), List{});
  EXPECT_EQ(matchingDevices(names, "GEFORCE"), List{1});
  EXPECT_EQ(matchingDevices(names, "e 4090"), List{1});
  EXPECT_EQ(matchingDevices(names, "15.0"), List{2});
  EXPECT_EQ(matchingDevices(names, "-1"), List{});
  EXPECT_EQ(matchingDevices(names, "e"), (List{0, 1, 2}));
}

TEST(GpuDevice, UnknownNameListsWhatThereIs) {
  auto device = Device::create({.name = "Voodoo 2"});
  ASSERT_FALSE(device.ok());
  EXPECT_EQ(device.error().kind, ErrorKind::kBadCall);
  EXPECT_NE(device.error().message.find("Voodoo 2"), std::string::npos) << device.error().message;
  EXPECT_NE(device.error().message.find("0 '"), std::string::npos) << device.error().message;
  EXPECT_EQ(device.error().message.find('\n'), std::string::npos);
  std::uint32_t count = 0;
  {
    auto first = Device::create({.name = "0"});
    ASSERT_TRUE(first.ok()) << first.error().message;
    vkEnumeratePhysicalDevices((*first)->instance(), &count, nullptr);
  }
  auto beyond = Device::create({.name = std::to_string(count)});
  ASSERT_FALSE(beyond.ok()) << "the first index that there is not";
  EXPECT_EQ(beyond.error().kind, ErrorKind::kBadCall);
  EXPECT_NE(beyond.error().message.find("0 '"), std::string::npos) << beyond.error().message;
}

TEST(GpuDevice, EnvironmentNamesTheDeviceUnlessTheCallDoes) {
  const Environment wanted("TYNDALL_DEVICE", "Voodoo 2");
  auto device = Device::create({});
  ASSERT_FALSE(device.ok());
  EXPECT_NE(device.error().message.find("TYNDALL_DEVICE"), std::string::npos) << device.error().message;
  EXPECT_TRUE(Device::create({.name = "0"}).ok());
}

TEST(GpuDevice, AMissingDriverIsOneLine) {
  const Environment drivers("VK_ICD_FILENAMES", "/nowhere/driver.json");
  const Environment newer("VK_DRIVER_FILES", "/nowhere/driver.json");
  auto device = Device::create({});
  ASSERT_FALSE(device.ok());
  EXPECT_EQ(device.error().kind, ErrorKind::kFailed);
  EXPECT_NE(device.error().message.find("install a driver"), std::string::npos) << device.error().message;
  EXPECT_EQ(device.error().message.find('\n'), std::string::npos);
}

TEST(GpuDevice, AnUnknownInstanceExtensionIsNamed) {
  DeviceOptions options;
  options.instanceExtensions = {"VK_KHR_crystal_ball"};
  auto device = Device::create(options);
  ASSERT_FALSE(device.ok());
  EXPECT_NE(device.error().message.find("VK_KHR_crystal_ball"), std::string::npos);
}

TEST(GpuDevice, TheSwapchainExtensionComesWithAWindowOnly) {
  DeviceOptions options;
  options.window = true;
  options.instanceExtensions = {"VK_KHR_surface"};
  auto device = Device::create(options);
  ASSERT_TRUE(device.ok()) << device.error().message;
  EXPECT_NE(vkGetDeviceProcAddr((*device)->handle(), "vkCreateSwapchainKHR"), nullptr);
}

TEST(GpuDevice, AMissingValidationLayerIsAnError) {
  const Environment layers("VK_LAYER_PATH", "/nowhere");
  auto device = Device::create({.validation = true});
  ASSERT_FALSE(device.ok());
  EXPECT_NE(device.error().message.find("VK_LAYER_KHRONOS_validation"), std::string::npos) << device.error().message;
}

class GpuValidation : public GpuTest {};

TEST_F(GpuValidation, AWrongLayoutIsCounted) {
  auto image = device->createImage({.name = "wrong",
                                    .format = VK_FORMAT_R8G8B8A8_UNORM,
                                    .width = 8,
                                    .height = 8,
                                    .usage = VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_SAMPLED_BIT});
  TY_EXPECT_OK(image);
  EXPECT_EQ(device->validationMessages(), 0u);
  TY_EXPECT_OK(device->submitAndWait([&](VkCommandBuffer commands) {
    transition(commands, *image, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_GENERAL);
    transition(commands, *image, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL,
               VK_IMAGE_LAYOUT_GENERAL);  // it is in GENERAL
  }));
  EXPECT_GT(device->validationMessages(), 0u);
  expectedMessages = device->validationMessages();
}

TEST_F(GpuValidation, AMissingBarrierIsCounted) {
  auto a = device->createBuffer(
      {.name = "a", .size = 256, .usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT});
  auto b = device->createBuffer(
      {.name = "b", .size = 256, .usage = VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT});
  TY_EXPECT_OK(a);
  TY_EXPECT_OK(b);
  const VkBufferCopy copy{0, 0, 256};
  const auto record = [&](bool barrier) {
    return device->submitAndWait([&](VkCommandBuffer commands) {
      vkCmdCopyBuffer(commands, a->handle(), b->handle(), 1, &copy);
      if (barrier) fullBarrier(commands);
      vkCmdCopyBuffer(commands, b->handle(), a->handle(), 1, &copy);
    });
  };
  TY_EXPECT_OK(record(true));
  EXPECT_EQ(device->validationMessages(), 0u);
  TY_EXPECT_OK(record(false));
  EXPECT_GT(device->validationMessages(), 0u) << "synchronization validation is off";
  expectedMessages = device->validationMessages();
}

}  // namespace
}  // namespace tyndall::gpu::test
