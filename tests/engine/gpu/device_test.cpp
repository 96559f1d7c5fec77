// The device: what it is picked by, what it says when there is none.
#include "engine/core/error.hpp"
#include "engine/gpu/instance.hpp"
#include "tests/engine/gpu/validated.hpp"

namespace afterglow
{
TEST_F(Validated, DeviceIsOneOfTheList)
{
    bool listed = false;
    for (const std::string& line : deviceList()) listed = listed || line.find(gpu.device.deviceName) != std::string::npos;
    EXPECT_TRUE(listed);
    EXPECT_GT(gpu.device.timestampMilliseconds, 0);
}

TEST_F(Validated, DeviceIsFoundByPartOfItsNameAndByIndex)
{
    Device byName({gpu.device.deviceName.substr(0, 5)});
    EXPECT_EQ(byName.deviceName.substr(0, 5), gpu.device.deviceName.substr(0, 5));
    Device byIndex({"0"});
    EXPECT_EQ(deviceList()[0].find("0: " + byIndex.deviceName), 0u);
    // A number is an index, whatever digits a name holds
    for (const char digit : gpu.device.deviceName) {
        const bool beyond = digit >= '0' && digit <= '9' && std::size_t(digit - '0') >= deviceList().size();
        if (!beyond) continue;
        EXPECT_THROW(Device(DeviceOptions{std::string(1, digit)}), Error) << digit;
    }
}

TEST(Device, SaysByWhatItTracesRays)
{
    EXPECT_EQ(raysInWords(true, true), "ray queries");
    EXPECT_EQ(raysInWords(true, false), "ray queries");
    EXPECT_EQ(raysInWords(false, true), "ray-tracing pipelines, no ray queries");
    EXPECT_EQ(raysInWords(false, false), "no ray queries");
}

TEST(Device, UnknownNameIsOneSentenceWithTheListAndExitCodeFour)
{
    try {
        Device device({"Voodoo 2"});
        FAIL() << "there is no such device";
    } catch (const Error& error) {
        EXPECT_EQ(error.exit, Exit::noDevice);
        EXPECT_NE(std::string(error.what()).find("Voodoo 2"), std::string::npos);
        EXPECT_NE(std::string(error.what()).find(deviceList()[0]), std::string::npos);
    }
}

TEST_F(Validated, ValidationMessagesAreKept)
{
    VkBufferCreateInfo wrong{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO}; // size 0, no usage
    VkBuffer buffer = VK_NULL_HANDLE;
    if (vkCreateBuffer(gpu.device.device, &wrong, nullptr, &buffer) == VK_SUCCESS) vkDestroyBuffer(gpu.device.device, buffer, nullptr);
    EXPECT_FALSE(gpu.device.messages.empty());
    gpu.device.messages.clear();
}
}
