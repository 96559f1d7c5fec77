// The slope of a surface as its depths tell it.
#ifndef AFTERGLOW_SLOPE_GLSL
#define AFTERGLOW_SLOPE_GLSL

// Cosine between a face, as the slopes tell it, and its shading normal that normal maps and smooth shading keep; less, and the slope is
// that of the surface beside.
const float kOneSurface = 0.7;

// Depth is affine over a plane's pixels. Of its two neighbours the flatter one lies on the same surface. `first`, `last`: at the picture's
// border.
float slopeOf(float before, float here, float after, bool first, bool last)
{
    float down = here - before, up = after - here;
    if (first) return last ? 0.0 : up;
    return last || abs(down) < abs(up) ? down : up;
}

#endif
