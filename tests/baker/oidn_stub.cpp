// A library with the C interface of Open Image Denoise that averages all of its picture: the worst that a filter can do to charts.
// It fails, by its error, whatever is not called as the interface says.
#include <cstddef>
#include <cstring>

static const char* failed = nullptr;
static void demand(bool holds, const char* sentence)
{
    if (!holds) failed = sentence;
}

struct Picture {
    float* texels;
    std::size_t count;
};
struct Filter {
    Picture color, output;
    bool directional, committed;
};
static Filter filter;
static bool deviceReady = false;

extern "C" {
void* oidnNewDevice(int type) { return type == 1 ? &failed : nullptr; }
void oidnCommitDevice(void*) { deviceReady = true; }
void oidnReleaseDevice(void*) { deviceReady = false; }
int oidnGetDeviceError(void*, const char** sentence)
{
    *sentence = failed;
    const int code = failed ? 1 : 0;
    failed = nullptr;
    return code;
}
void oidnSetDevice1i(void*, const char* name, int) { demand(std::strcmp(name, "numThreads") == 0, "no such number"); }
void* oidnNewFilter(void*, const char* type)
{
    demand(deviceReady, "the device is not committed");
    demand(std::strcmp(type, "RTLightmap") == 0, "not the filter for lightmaps");
    filter = {};
    return &filter;
}
void oidnSetSharedFilterImage(void*, const char* name, void* texels, int format, std::size_t width, std::size_t height, std::size_t,
                              std::size_t, std::size_t)
{
    demand(format == 3, "not three floats");
    (std::strcmp(name, "output") == 0 ? filter.output : filter.color) = {static_cast<float*>(texels), width * height};
}
void oidnSetFilter1b(void*, const char* name, bool value)
{
    demand(std::strcmp(name, "directional") == 0, "no such choice");
    filter.directional = value;
}
void oidnCommitFilter(void*) { filter.committed = true; }
void oidnExecuteFilter(void*)
{
    demand(filter.committed && filter.output.count == filter.color.count, "the filter is not ready");
    float sum[3] = {};
    for (std::size_t i = 0; i < filter.color.count; i++)
        for (int c = 0; c < 3; c++) {
            const float value = filter.color.texels[3 * i + std::size_t(c)];
            demand(filter.directional ? value >= -1.0f && value <= 1.0f : value >= 0.0f, "a value out of range");
            sum[c] += value;
        }
    for (std::size_t i = 0; i < 3 * filter.output.count; i++) filter.output.texels[i] = sum[i % 3] / float(filter.color.count);
}
void oidnReleaseFilter(void*) {}
}
