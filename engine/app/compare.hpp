// `afterglow compare A B`: how far two pictures are apart, in numbers and as a person sees it.
#pragma once
#include "engine/core/image.hpp"
#include <filesystem>

namespace afterglow
{
struct CompareOptions {
    std::filesystem::path a;       // the picture in question
    std::filesystem::path b;       // the reference, of the same size and kind
    std::filesystem::path heatMap; // .png of FLIP per pixel; empty: none
    bool json = false;
};

// Prints to stdout. Displayed pictures (.png, .jpg) are measured in display values 0..1, radiance (.exr, .hdr) in
// its own unit with PSNR against the reference's brightest value. Throws Error.
void compare(const CompareOptions& options);
}
