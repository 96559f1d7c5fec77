#include "engine/effects/display/display.hpp"
#include "engine/effects/display/display.h"

namespace afterglow
{
namespace
{
uint curveOf(ToneCurve curve)
{
    if (curve == ToneCurve::reinhard) return kToneReinhard;
    if (curve == ToneCurve::aces) return kToneAces;
    return curve == ToneCurve::hable ? kToneHable : kToneNone;
}

// One texel: the factor that shows the picture's mean as middle grey.
Texture measureExposure(Graph& graph, const Texture& radiance, float adapt)
{
    History exposures; // of the last frame and of this, where the eye adapts
    if (adapt < 1.0f)
        exposures = graph.history("exposure", VK_FORMAT_R32_SFLOAT, {1, 1});
    else
        exposures.current = graph.texture("exposure", VK_FORMAT_R32_SFLOAT, {1, 1});
    graph.compute("display.exposure", "engine/effects/display/exposure.comp")
        .read(radiance)
        .read(exposures.previous)
        .write(exposures.current)
        .specialize(kExposureAdapts, adapt < 1.0f)
        .push(ExposurePush{adapt})
        .dispatch(uvec2(kExposureThreads, 1));
    return exposures.current;
}
}

Texture display(Graph& graph, const Texture& radiance, const DisplayParameters& parameters)
{
    const float exposure = parameters.exposureEv ? exposureFromEv(*parameters.exposureEv) : 0.0f;
    // With a given exposure the shader still declares the measured one: bound to the picture, never read
    const Texture measured = parameters.exposureEv ? radiance : measureExposure(graph, radiance, parameters.adapt);
    const Texture displayed = graph.texture("displayed", VK_FORMAT_R8G8B8A8_UNORM, radiance.size());
    graph.fullscreen("display", "engine/effects/display/display.frag")
        .read(radiance)
        .read(measured)
        .write(displayed)
        .push(DisplayPush{exposure, curveOf(parameters.curve)});
    return displayed;
}
}
