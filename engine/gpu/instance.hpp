// Inside of row 2: the Vulkan instance, its validation layer, and the devices seen through it.
#pragma once
#include "engine/gpu/vk.hpp"
#include <string>
#include <vector>

namespace afterglow
{
// Throws Error (exit 4) when there is no Vulkan at all, or no validation layer although it was asked for.
VkInstance makeInstance(bool validation, const std::vector<const char*>& extensions);

// Warnings and errors of the validation layer go to `messages`, which must outlive the messenger.
VkDebugUtilsMessengerEXT makeMessenger(VkInstance instance, std::vector<std::string>& messages);
void destroyMessenger(VkInstance instance, VkDebugUtilsMessengerEXT messenger);

std::vector<VkPhysicalDevice> physicalDevices(VkInstance instance);
bool hasExtension(VkPhysicalDevice physical, const char* name);
std::string raysInWords(bool queries, bool programs); // by what a device traces them, as a list of devices says it
std::string describeDevice(VkPhysicalDevice physical, std::size_t index);
}
