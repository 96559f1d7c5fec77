// Display: exposure, tone curve, sRGB; radiance in, RGBA8 out.
#pragma once
#include "engine/effects/view.hpp"

namespace afterglow
{
struct DisplayParameters {
    std::optional<float> exposureEv; // EV at ISO 100; absent: chosen from the picture
    ToneCurve curve = ToneCurve::aces;
    float adapt = 1.0f; // share of the way to the picture's own exposure in this frame; below 1 the last frame counts: a viewer only
};

// RGBA8, display-referred: ready for a .png or a window.
Texture display(Graph& graph, const Texture& radiance, const DisplayParameters& parameters);
}
