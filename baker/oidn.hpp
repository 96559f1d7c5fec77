// Intel's Open Image Denoise for lightmaps, where the machine has it: its library is opened at run time, versions 1.4 to 2.
#pragma once
#include "baker/islands.hpp"
#include <memory>
#include <string>

namespace afterglow
{
// The library, and what is called of it.
class Oidn
{
public:
    // Throws Error (exit 4) when none of these is there, or it is no such library. Names as dlopen() takes them.
    explicit Oidn(int threads, const std::vector<std::string>& names = {"libOpenImageDenoise.so.2", "libOpenImageDenoise.so.1",
                                                                        "libOpenImageDenoise.so.0", "libOpenImageDenoise.so"});
    ~Oidn();

    enum class Kind { light, direction }; // light >= 0 of any range; numbers from -1 to 1
    // A picture of so many columns and rows, in its place. Throws Error with what the library says.
    void filter(std::vector<vec3>& texels, ivec2 size, Kind kind) const;

private:
    struct Library;
    std::unique_ptr<Library> library_;
};

// Filters the baked texels (valid = 1) of a page. The library knows nothing of charts: each island of baked texels is a picture of its own,
// filled by dilation around it, so that no chart can shine into another. A step for each island.
void denoise(Lightmap& lightmap, const TexelGuides& guides, const Islands& islands, const Oidn& oidn, const Advance& advance = unheard);
}
