// OpenEXR, behind image.hpp: the only file that knows it is exr.cpp.
#pragma once
#include "engine/core/image.hpp"

namespace afterglow
{
Image readExr(const std::filesystem::path& path);
}
