#include "engine/frame/frame.hpp"
#include "engine/core/error.hpp"
#include "engine/effects/bloom/bloom.hpp"
#include "engine/effects/fog/fog.hpp"
#include "engine/effects/geometry/geometry.hpp"
#include "engine/effects/outline/outline.hpp"
#include "engine/effects/planar/planar.hpp"
#include "engine/effects/portal/portal.hpp"
#include "engine/effects/probe_view/probe_view.hpp"
#include "engine/effects/upscale/upscale.hpp"
#include "engine/frame/windows.hpp"
#include "engine/scene/picture.hpp"
#include <utility>

namespace afterglow
{
// A line is as wide as it is said to be in the picture that is shown, at whatever size the frame is drawn.
static Settings drawnAs(const View& eye, Settings settings)
{
    settings.outline.width *= float(eye.size.y) / float(settings.size.y);
    return settings;
}

// As a camera shows radiance.
static Pictures shown(Graph& graph, const Plan& plan, const Texture& radiance, const Settings& settings, const Layers& layers = {})
{
    const Texture bloomed = plan.on("bloom") ? bloom(graph, radiance, settings.bloom) : radiance;
    return {radiance, bloomed, display(graph, bloomed, settings.display), layers};
}

// Colours that mean something are displayed as they are.
static Pictures shownAsTheyAre(Graph& graph, const Texture& colors)
{
    return {colors, colors, display(graph, colors, {.exposureEv = 0.0f, .curve = ToneCurve::none}), {}};
}

// One more look at the surfaces, through the centres of the shown pixels: whatever the samples and the size of the frame are, a depth, a
// normal or an id is that of one surface.
static void lookAgain(Graph& graph, const Plan& plan, const View& view, const GpuScene& scene, Layers& layers)
{
    const std::string around = std::exchange(graph.scope, "layers.");
    const GBuffer surfaces = geometry(graph, view, scene, {.masked = plan.on("masked"), .objects = true});
    surfaceLayers(graph, view, surfaces, scene, layers);
    graph.scope = around;
}

Pictures drawFrame(Graph& graph, Stage& stage, const View& from, const Settings& asked)
{
    View eye = from;
    eye.last = stage.lastEye.value_or(eye.steady);
    if (stage.plan.on("antialias")) eye.resting = restingFrames(eye, stage.level->scene, stage.gathered);
    Settings settings = drawnAs(eye, asked);
    settings.shadow.denoise = stage.plan.on("shadow.denoise");
    settings.occlusion.range = stage.occlusionRange;
    settings.occlusion.denoise = stage.plan.on("occlusion.denoise");
    const Plan& plan = stage.plan;
    const GpuLevel& level = *stage.level;
    Windows windows = windowsOf(stage, eye, settings);
    const View view = marked(eye, level.scene, windows.mirrors);
    const GBuffer surfaces = geometry(graph, view, level.scene, geometryParts(stage, settings));
    Shadows shadows = plan.on("shadow") ? shadow(graph, stage.shadows, level.scene, view) : Shadows{};
    if (plan.on("shadow") && stage.shadowMethod == ShadowMethod::ray)
        shadows.traced = tracedShadows(graph, view, surfaces, level.scene, settings.shadow);
    Texture open;
    if (plan.on("occlusion"))
        open = occlusion(graph, view, surfaces, {stage.voxels, level.scene.rays}, stage.occlusionMethod, settings.occlusion,
                         /* mapped= */ settings.layers || !plan.on("lightmaps"));

    Layers made;
    Layers* layers = settings.layers ? &made : nullptr;
    LightingParts parts = lightingParts(stage);
    parts.mirrored = plan.on("reflection");
    Lit lit = lighting(graph, view, surfaces, shadows, open, level, stage.surroundings, parts, layers);
    if (plan.on("toon")) toon(graph, surfaces, shadows, level, lit, parts, stage.ramps, layers);
    if (plan.on("reflection"))
        lit = reflection(graph, view, surfaces, shadows, level, lit, parts, stage.reflectionMethod, settings.reflection, layers);
    const std::vector<VirtualPicture> mirrored = lookThrough(graph, stage, windows.mirrors, shadows, settings, windows.left);
    const std::vector<VirtualPicture> beyond = lookThrough(graph, stage, windows.portals, shadows, settings, windows.left);
    const auto windowsIn = [&](FlatPart part) {
        if (plan.on("planar")) planar(graph, view, surfaces, level.scene, mirrored, part, lit.radiance, made);
        if (plan.on("portal")) portal(graph, view, surfaces, level.scene, beyond, part, lit.radiance, made);
    };
    windowsIn(FlatPart::solid);
    if (plan.on("clear")) clearSurfaces(graph, view, surfaces, shadows, level, lit, parts, layers);
    windowsIn(FlatPart::clear);

    Texture image = lit.radiance;
    if (plan.on("fog"))
        image = fog(graph, &stage.fog, view, surfaces, shadows, level, stage.surroundings.ambient, image, settings.fog, layers);
    if (plan.on("outline")) outline(graph, view, surfaces, level, stage.edges, image, settings.outline, layers);
    if (settings.show != kShowNothing) image = probeView(graph, view, surfaces, level, stage.marks, image, settings.show);
    made.occlusion = open;
    if (layers) lookAgain(graph, plan, centred(eye, settings.size), level.scene, made);
    if (plan.on("antialias"))
        image = antialias(graph, view, surfaces, level.scene, image, {settings.size, plan.on("upscale")}, stage.gathered, layers);
    else if (plan.on("upscale"))
        image = upscale(graph, view, image, settings.size);
    settle(stage.level->scene);
    stage.lastEye = eye.steady;
    if (showsColors(settings.show)) return shownAsTheyAre(graph, image);
    return shown(graph, plan, image, settings, made);
}

Pictures drawTruth(Graph& graph, Stage& stage, const Camera& camera, const Settings& settings)
{
    check(stage.memory != nullptr, "the stage was made for paths");
    const Picture picture = pictureOf(camera, settings.size, settings.truth.seed, settings.portal.depth);
    const Texture mean = truth(graph, {*stage.memory, *stage.level, stage.paths, stage.tracing}, picture, stage.traced, settings.truth);
    return shown(graph, stage.plan, mean, settings);
}

Texture drawWiped(Graph& graph, const Stage& stage, const Texture& left, const Texture& right, float share, const Settings& settings)
{
    return shown(graph, stage.plan, wipe(graph, left, right, share), settings).displayed;
}
}
