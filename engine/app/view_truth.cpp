// The truth in the viewer: path traced while the camera rests, in place of the raster frame, beside it, or as the difference that a person
// sees between the two.
#include "engine/app/heat.hpp"
#include "engine/app/viewer.hpp"
#include "engine/core/error.hpp"
#include "engine/core/flip.hpp"
#include <algorithm>

namespace afterglow
{
namespace
{
constexpr int kDifferenceWidth = 320; // px at most: FLIP of 320x180 takes a frame or two, and means of blocks leave less of the noise

// Means of blocks.
Image shrunk(const Image& image, int block)
{
    Image small((image.width + block - 1) / block, (image.height + block - 1) / block, 3);
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x) {
            const int right = std::min((x + 1) * block, image.width), below = std::min((y + 1) * block, image.height);
            const float share = 1.0f / float((right - x * block) * (below - y * block));
            for (int v = y * block; v < below; ++v)
                for (int u = x * block; u < right; ++u)
                    for (int c = 0; c < 3; ++c) small.at(x, y)[c] += share * image.at(u, v)[c];
        }
    return small;
}

// RGBA, as large as the window.
Image8 enlarged(const Image8& small, int block, uvec2 size)
{
    Image8 large{int(size.x), int(size.y), 4, {}};
    for (int y = 0; y < large.height; ++y)
        for (int x = 0; x < large.width; ++x) {
            const std::uint8_t* p = &small.pixels[(std::size_t(y / block) * std::size_t(small.width) + std::size_t(x / block)) * 3];
            large.pixels.insert(large.pixels.end(), {p[0], p[1], p[2], 255});
        }
    return large;
}
}

void readyPaths(Viewer& viewer)
{
    if (viewer.look == ViewMode::raster || viewer.settings.mode == Mode::both) return;
    try {
        tracingOn(viewer.gpu.device, viewer.settings.tracing);
    } catch (const Error& cannot) {
        viewer.messages = {std::string(cannot.what()) + ": the raster frame stays"};
        viewer.look = ViewMode::raster;
        return;
    }
    viewer.settings.mode = Mode::both;
    viewer.settings.truth.samples = kMostTruthSamples;
    viewer.restage = true;
}

ShownPictures drawShown(Graph& graph, Viewer& viewer)
{
    ShownPictures drawn;
    Pictures raster, truth;
    if (viewer.look != ViewMode::truth)
        raster = drawFrame(graph, viewer.stage, nextView(viewer.stage, viewer.eye, viewer.settings), viewer.settings);
    if (viewer.look != ViewMode::raster) truth = drawTruth(graph, viewer.stage, viewer.eye, viewer.settings);
    drawn.raster = raster.radiance;
    drawn.truth = truth.radiance;
    drawn.displayed = viewer.look == ViewMode::raster ? raster.displayed : truth.displayed;
    if (viewer.look == ViewMode::wipe)
        drawn.displayed = drawWiped(graph, viewer.stage, drawn.raster, drawn.truth, viewer.wipe, viewer.settings);
    return drawn;
}

void showDifference(Viewer& viewer, const ShownPictures& drawn)
{
    const uint samples = viewer.stage.traced.count;
    const bool due = (samples & (samples - 1)) == 0 && samples < kMostTruthSamples; // noise halves with every fourth: enough
    if (!due && viewer.differs) return;
    const uvec2 size(viewer.picture.shape.size);
    const int block = (int(size.x) + kDifferenceWidth - 1) / kDifferenceWidth;
    const Image raster = shrunk(viewer.executor.download(drawn.raster), block),
                truth = shrunk(viewer.executor.download(drawn.truth), block);
    const Flip flip = flipRadiance(raster, truth, kPixelsPerDegree / float(block));
    const Image8 map = enlarged(heat(flip.map), block, size);
    viewer.gpu.memory.upload(viewer.picture, map.pixels.data(), map.pixels.size());
    viewer.differs = flip.mean;
}
}
