#include "engine/frame/windows.hpp"
#include "engine/effects/fog/fog.hpp"
#include "engine/effects/outline/outline.hpp"
#include "engine/effects/portal/portal.hpp"
#include <algorithm>
#include <span>

namespace afterglow
{
namespace
{
constexpr std::size_t kMostWindows = 16;  // of each kind that one eye sees: the largest
constexpr std::size_t kMostPictures = 64; // of one frame, portals in mirrors and in portals included: beyond it a flat is its own surface

// `portals`: through how many more the look may go. `left`: how many more pictures the frame may have.
std::vector<VirtualPicture> draw(Graph& graph, const Stage& stage, const std::vector<VirtualView>& views, const Shadows& shadows,
                                 const Settings& settings, uint portals, std::size_t& left)
{
    const Plan& plan = stage.plan;
    const GpuLevel& level = *stage.level;
    std::vector<VirtualPicture> pictures;
    const std::size_t count = std::min(views.size(), left); // before what is seen in them: lighting counts on every mirror's picture
    left -= count;
    for (const VirtualView& from : std::span(views).first(count)) {
        const std::string around = graph.scope;
        graph.scope = around + nameOf(from) + ".";
        const View& eye = from.view;
        const GBuffer surfaces = geometry(graph, eye, level.scene, geometryParts(stage, settings));
        const LightingParts parts = lightingParts(stage);
        const Lit lit = lighting(graph, eye, surfaces, shadows, /* visibility= */ {}, level, stage.surroundings, parts);
        if (plan.on("toon")) toon(graph, surfaces, shadows, level, lit, parts, stage.ramps);
        std::vector<VirtualPicture> further;
        if (portals > 0) {
            const std::vector<VirtualView> seen = virtualViews(eye, level.scene, stage.flats.portals, kMostWindows);
            further = draw(graph, stage, seen, shadows, settings, portals - 1, left);
        }
        const auto open = [&](FlatPart part) {
            if (!further.empty()) portal(graph, eye, surfaces, level.scene, further, part, lit.radiance, {});
        };
        open(FlatPart::solid);
        if (plan.on("clear")) clearSurfaces(graph, eye, surfaces, shadows, level, lit, parts);
        open(FlatPart::clear);
        Texture image = lit.radiance;
        if (plan.on("fog")) image = fog(graph, nullptr, eye, surfaces, shadows, level, stage.surroundings.ambient, image, settings.fog);
        if (plan.on("outline")) outline(graph, eye, surfaces, level, stage.edges, image, settings.outline);
        graph.scope = around;
        pictures.push_back({from, image, surfaces.depth});
    }
    return pictures;
}
}

Windows windowsOf(const Stage& stage, const View& eye, const Settings& settings)
{
    Windows windows;
    const GpuScene& scene = stage.level->scene;
    windows.left = kMostPictures;
    windows.mirrors = virtualViews(eye, scene, stage.flats.mirrors, kMostWindows);
    if (settings.portal.depth > 0) windows.portals = virtualViews(eye, scene, stage.flats.portals, kMostWindows);
    return windows;
}

View marked(View eye, const GpuScene& scene, const std::vector<VirtualView>& mirrors)
{
    if (mirrors.empty()) return eye;
    eye.mirrored.assign(scene.draws.size(), 0);
    for (std::size_t i = 0; i < scene.draws.size(); ++i)
        for (const VirtualView& v : mirrors)
            if (belongs(scene.draws[i], *v.flat)) eye.mirrored[i] = 1;
    return eye;
}

GeometryParts geometryParts(const Stage& stage, const Settings& settings)
{
    const Plan& plan = stage.plan;
    const bool meetingsAreLines = plan.on("outline") && settings.outline.width > 0.0f && (settings.outline.kinds & kEdgeObject) != 0;
    return {.masked = plan.on("masked"), .emission = stage.emission, .objects = meetingsAreLines, .facets = stage.roughMetals};
}

LightingParts lightingParts(const Stage& stage)
{
    const Plan& plan = stage.plan;
    const GpuBaked& baked = stage.level->baked;
    return {.lightmaps = plan.on("lightmaps"),
            .directional = plan.on("lightmaps") && !baked.directions.empty(),
            .probes = plan.on("probes") && baked.probes,
            .reflections = plan.on("reflections") && !baked.reflections.empty(),
            .fog = plan.on("fog")};
}

std::vector<VirtualPicture> lookThrough(Graph& graph, const Stage& stage, const std::vector<VirtualView>& views, const Shadows& shadows,
                                        const Settings& settings, std::size_t& left)
{
    const bool through = stage.plan.on("portal") && settings.portal.depth > 0;
    Shadows mapped = shadows;
    mapped.traced = {}; // it knows the pixels of the picture itself
    return draw(graph, stage, views, mapped, settings, through ? settings.portal.depth - 1 : 0, left);
}
}
