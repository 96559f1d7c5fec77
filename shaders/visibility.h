// What ambient occlusion takes from the light that reaches the eye. Visibility: 1 open, 0 hidden, weighted by the cosine.
// Based on: Jimenez et al. 2016 (the fit of several bounces), Lagarde & de Rousiers 2014 (specular occlusion).
#ifndef AFTERGLOW_VISIBILITY_H
#define AFTERGLOW_VISIBILITY_H
#include "shaders/constants.h"
SHARED_BEGIN

// What hides the light sends some of it back, tinted: as if it had the albedo of the point itself. Never less than the visibility.
FN vec3 bouncedVisibility(float visibility, vec3 albedo)
{
    vec3 a = 2.0404f * albedo - 0.3324f;
    vec3 b = -4.7951f * albedo + 0.6417f;
    vec3 c = 2.7552f * albedo + 0.6903f;
    return clamp(((a * visibility + b) * visibility + c) * visibility, vec3(visibility), vec3(1.0f));
}

// Of a mirrored lobe instead of the whole hemisphere: a sharp lobe is hidden late and then at once, a wide one as the matte base is. The
// fit is of alpha (Lagarde, de Rousiers 2014); `roughness` is perceptual.
FN float specularVisibility(float visibility, float cosEye, float roughness)
{
    return clamp(pow(cosEye + visibility, exp2(-16.0f * roughness * roughness - 1.0f)) - 1.0f + visibility, 0.0f, 1.0f);
}

SHARED_END
#endif
