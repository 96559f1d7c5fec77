// What light that meets one facet alone loses between the facets of a rough metal, and how it comes back: a lobe as wide as a matte one's,
//   f = c * loss(o) * loss(i) / (pi * mean loss), c the colour of light that met two facets or more.
// It is reciprocal, and a white metal then sends back all that it receives. glTF's own formula ends at the first facet: viewers that keep
// to it show rough metals darker and less saturated, a white one as 0.41 at roughness 1.
// Based on: Kulla & Conty 2017, "Revisiting Physically Based Shading at Imageworks"; the colour by Hill 2018, "A Multi-Faceted Exploration
// (Part 2)".
#ifndef AFTERGLOW_FACETS_H
#define AFTERGLOW_FACETS_H
#include "shaders/microfacet.h"
SHARED_BEGIN

// The loss at mu, 1 - (directional albedo of GGX with F = 1), of one roughness: a polynomial without constant in q = mu / (mu + 3/4 alpha).
// Least one, by a linear program over 4000 quadratures, that is nowhere above the truth by 1e-4; below by 0.008 at most, 0.003 on average.
struct FacetLoss {
    vec4 terms;  // of q to q^4
    float last;  // of q^5
    float alpha; // of the round lobe that loses it
    float mean;  // its cosine average; from above, by what costs 0.002 of the light at most
    float share; // of it that comes back: 1; less of brushed metals, which lose less at grazing angles than a round lobe; 0 of mirrors
};

FN FacetLoss facetLossOf(vec2 alpha)
{
    FacetLoss loss;
    float a = sqrt(alpha.x * alpha.y), a2 = a * a;
    loss.alpha = a;
    vec4 powers = vec4(1.0f, a, a2, a * a2);
    loss.terms = vec4(dot(vec4(0.171f, 0.108f, 3.467f, -0.629f), powers), dot(vec4(-0.75f, 0.098f, -10.018f, -3.138f), powers),
                      dot(vec4(4.528f, -3.716f, 25.17f, 21.393f), powers), dot(vec4(-7.68f, 7.435f, -21.778f, -57.342f), powers));
    loss.last = dot(vec4(3.726f, -3.713f, -0.45f, 50.378f), powers);
    float below = dot(vec4(1.0f, -8.703f, 151.727f, 93.983f), powers) + 270.255f * a2 * a2;
    loss.mean = a2 * dot(vec3(1.659f, -3.529f, 300.0f), vec3(powers)) / below;
    loss.share = isMirror(alpha) ? 0.0f : min(alpha.x, alpha.y) / max(alpha.x, alpha.y);
    return loss;
}

FN float facetLoss(IN(FacetLoss) loss, float mu)
{
    float q = mu / (mu + 0.75f * loss.alpha);
    return max(q * (loss.terms.x + q * (loss.terms.y + q * (loss.terms.z + q * (loss.terms.w + q * loss.last)))), 0.0f);
}

// Colour of what comes back, of a metal of reflectance f0. The mean of Schlick's term is f = (1 + 20 f0) / 21; of what one facet sends on,
// 1 - e meets the next, again and again: f e f (1 + (1 - e) f + ...), e the mean albedo of one facet.
FN vec3 facetColor(vec3 f0, float meanLoss)
{
    vec3 f = (f0 * 20.0f + 1.0f) / 21.0f;
    return f * f * (1.0f - meanLoss) / (vec3(1.0f) - f * meanLoss);
}

SHARED_END
#endif
