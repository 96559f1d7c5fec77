// The stb readers and writers of .png, .jpg and .hdr, behind image.hpp: the only file that knows them is stb.cpp.
#pragma once
#include "engine/core/image.hpp"

namespace afterglow
{
Image readHdr(const std::vector<std::uint8_t>& bytes, const std::string& what);
void writeHdr(const std::filesystem::path& path, const Image& image); // values finite

// Display values 0..1, as stored: 8 or 16 bits a channel, three channels or four.
Image readDisplayed(const std::vector<std::uint8_t>& bytes, const std::string& what);
}
