// This work is based on: the C interface that Open Image Denoise documents, and its filter "RTLightmap" for light and for directional data.
#include "baker/oidn.hpp"
#include "baker/dilate.hpp"
#include "engine/core/error.hpp"
#include "shaders/lightmap.h"
#include <dlfcn.h>

namespace afterglow
{
// What we call of it. A device or a filter is a pointer that only the library looks behind.
struct Oidn::Library {
    static constexpr int kCpu = 1, kFloat3 = 3; // OIDNDeviceType, OIDNFormat

    void* handle = nullptr;
    void* device = nullptr;
    void* (*newDevice)(int type) = nullptr;
    void (*commitDevice)(void* device) = nullptr;
    void (*releaseDevice)(void* device) = nullptr;
    int (*deviceError)(void* device, const char** sentence) = nullptr;
    void (*setDeviceInt)(void* device, const char* name, int value) = nullptr;
    void* (*newFilter)(void* device, const char* type) = nullptr;
    void (*setImage)(void* filter, const char* name, void* texels, int format, std::size_t width, std::size_t height, std::size_t offset,
                     std::size_t texelStride, std::size_t rowStride) = nullptr;
    void (*setFilterBool)(void* filter, const char* name, bool value) = nullptr;
    void (*commitFilter)(void* filter) = nullptr;
    void (*executeFilter)(void* filter) = nullptr;
    void (*releaseFilter)(void* filter) = nullptr;

    // By the name of version 2, or that of version 1.
    template <typename Function>
    void find(Function*& function, const char* name, const char* older = nullptr)
    {
        function = reinterpret_cast<Function*>(dlsym(handle, name));
        if (!function && older) function = reinterpret_cast<Function*>(dlsym(handle, older));
        if (!function)
            throw Error("--denoise oidn: the library that calls itself Open Image Denoise has no " + std::string(name) +
                            "; install version 1.4 or 2, or use --denoise builtin",
                        Exit::noDevice);
    }
    void demandNoError() const
    {
        const char* sentence = nullptr;
        if (deviceError(device, &sentence) != 0)
            throw Error("--denoise oidn: Open Image Denoise says: " + std::string(sentence ? sentence : "an error without a name") +
                            "; use --denoise builtin",
                        Exit::noDevice);
    }
    ~Library()
    {
        if (device) releaseDevice(device);
        if (handle) dlclose(handle);
    }
};

Oidn::Oidn(int threads, const std::vector<std::string>& names) : library_(std::make_unique<Library>())
{
    Library& l = *library_;
    for (const std::string& name : names)
        if (!l.handle) l.handle = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!l.handle)
        throw Error("--denoise oidn: this machine has no Open Image Denoise (" + names.front() +
                        " was looked for); install it where the loader finds it, or use --denoise builtin",
                    Exit::noDevice);
    l.find(l.newDevice, "oidnNewDevice");
    l.find(l.commitDevice, "oidnCommitDevice");
    l.find(l.releaseDevice, "oidnReleaseDevice");
    l.find(l.deviceError, "oidnGetDeviceError");
    l.find(l.setDeviceInt, "oidnSetDeviceInt", "oidnSetDevice1i");
    l.find(l.newFilter, "oidnNewFilter");
    l.find(l.setImage, "oidnSetSharedFilterImage");
    l.find(l.setFilterBool, "oidnSetFilterBool", "oidnSetFilter1b");
    l.find(l.commitFilter, "oidnCommitFilter");
    l.find(l.executeFilter, "oidnExecuteFilter");
    l.find(l.releaseFilter, "oidnReleaseFilter");
    l.device = l.newDevice(Library::kCpu); // a graphics card's would not see our memory
    if (!l.device)
        throw Error("--denoise oidn: Open Image Denoise has no device for this processor; use --denoise builtin", Exit::noDevice);
    if (threads > 0) l.setDeviceInt(l.device, "numThreads", threads);
    l.commitDevice(l.device);
    l.demandNoError();
}

Oidn::~Oidn() = default;

void Oidn::filter(std::vector<vec3>& texels, ivec2 size, Kind kind) const
{
    const Library& l = *library_;
    std::vector<vec3> filtered(texels.size());
    void* filter = l.newFilter(l.device, "RTLightmap");
    if (!filter) l.demandNoError();
    const auto image = [&](const char* name, std::vector<vec3>& data) {
        l.setImage(filter, name, data.data(), Library::kFloat3, std::size_t(size.x), std::size_t(size.y), 0, 0, 0);
    };
    image("color", texels);
    image("output", filtered);
    if (kind == Kind::direction) l.setFilterBool(filter, "directional", true);
    l.commitFilter(filter);
    l.executeFilter(filter);
    l.releaseFilter(filter);
    l.demandNoError();
    texels.swap(filtered);
}

// Directions have no bound; the filter's range is -1 to 1.
static vec3 bounded(vec3 d) { return d / (1.0f + length(d)); }
static vec3 unbounded(vec3 d) { return d / max(1.0f - length(d), 1.0f / 128.0f); }

static void filterPicture(Lightmap& picture, const Oidn& oidn)
{
    const ivec2 size(picture.width, picture.height);
    oidn.filter(picture.texels, size, Oidn::Kind::light);
    for (vec3& texel : picture.texels) texel = max(texel, vec3(0.0f));
    if (picture.direction.empty()) return;
    std::vector<vec3> directions;
    for (const vec4& d : picture.direction) directions.push_back(bounded(vec3(d)));
    oidn.filter(directions, size, Oidn::Kind::direction);
    for (std::size_t i = 0; i < directions.size(); i++) picture.direction[i] = vec4(unbounded(directions[i]), 0.0f);
}

void denoise(Lightmap& lightmap, const TexelGuides& guides, const Islands& islands, const Oidn& oidn, const Advance& advance)
{
    std::vector<ivec2> lower(std::size_t(islands.count), ivec2(lightmap.width, lightmap.height)), upper(lower.size(), ivec2(-1));
    for (int y = 0; y < lightmap.height; y++)
        for (int x = 0; x < lightmap.width; x++)
            if (const int island = islands.of[std::size_t(y * lightmap.width + x)]; island > 0) {
                lower[std::size_t(island - 1)] = min(lower[std::size_t(island - 1)], ivec2(x, y));
                upper[std::size_t(island - 1)] = max(upper[std::size_t(island - 1)], ivec2(x, y));
            }
    for (int island = 1; island <= islands.count; island++) {
        const ivec2 from = lower[std::size_t(island - 1)], size = upper[std::size_t(island - 1)] - from + 1;
        const auto onPage = [&](int i) { return std::size_t((from.y + i / size.x) * lightmap.width + from.x + i % size.x); };
        const int count = size.x * size.y;
        Lightmap picture;
        picture.width = size.x, picture.height = size.y;
        for (int i = 0; i < count; i++) {
            const bool own = islands.of[onPage(i)] == island;
            picture.texels.push_back(own ? lightmap.texels[onPage(i)] : vec3(0.0f));
            picture.valid.push_back(own ? 1 : 0);
            if (!lightmap.direction.empty()) picture.direction.push_back(own ? lightmap.direction[onPage(i)] : directionUnbent());
        }
        dilate(picture, std::vector<uint>(picture.texels.size(), kNobody), max(size.x, size.y)); // as far as it reaches
        filterPicture(picture, oidn);
        for (int i = 0; i < count; i++) {
            if (islands.of[onPage(i)] != island) continue;
            lightmap.texels[onPage(i)] = picture.texels[std::size_t(i)];
            if (!lightmap.direction.empty())
                lightmap.direction[onPage(i)] = directionAbout(vec3(picture.direction[std::size_t(i)]), guides.normal[onPage(i)]);
        }
        advance(1);
    }
}
}
