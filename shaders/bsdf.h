// The law of a surface: what it does to light. A metal, or a dielectric layer over a matte base, or a dielectric that light passes through,
// and every mixture; one GGX roughness for all interfaces.
// Local frame: +z = shading normal on the side of wo. wo (to the eye) and wi (to the light) both point away from the surface.
// Values are f in 1/sr without the cosine. Ideal mirrors and clear glass are deltas: only sampleBsdf meets them.
//
// Mean of the mixture:  f = metallic * f_metal + (1 - metallic) * (f_layer + base)
//   f_metal: GGX, Schlick from the base colour to white, as glTF says (Cycles' glossy metal has no such edge), and what its facets send to
//            each other before it leaves (shaders/facets.h). A white one gives a white furnace of 1.
//   f_layer: GGX with the exact dielectric Fresnel F(h.o), scaled by KHR_materials_specular.
//   base:    matte, albedo * T(o) T(i) / mean(T), with T(mu) = 1 - (directional albedo of the layer at mu). It is reciprocal, and its own
//            directional albedo is exactly albedo * T(o): what the layer does not send back, the base receives. An albedo of 1 gives a
//            white furnace of 1; Cycles' mix by the view's Fresnel gives the same in the limit of a smooth layer, but is not reciprocal.
//   through: in place of (a share of) the base. Refraction after Walter et al. 2007, or, for thin walls, the reflection lobe turned
//   through.
#ifndef AFTERGLOW_BSDF_H
#define AFTERGLOW_BSDF_H
#include "shaders/diffuse.h"
#include "shaders/facets.h"
#include "shaders/frame.h"
#include "shaders/fresnel.h"
#include "shaders/layer.h"
#include "shaders/microfacet.h"
#include "shaders/sampling.h"
SHARED_BEGIN

struct Bsdf {
    vec3 diffuse;      // albedo of the matte base, times (1 - metallic)(1 - transmission)
    float roughness;   // of the base: EON r, 0 = Lambert
    vec3 metal;        // reflectance of the metal part at normal incidence
    float metallic;    // share of the metal part
    vec3 layer;        // reflectance of the dielectric layer at normal incidence
    float layerEdge;   // and at grazing angles (specularFactor); 0: no layer
    vec3 transmission; // tint of what passes through, times (1 - metallic) * transmission; radiance, eta^2 scaling included
    float eta;         // n on the other side / n on the side of wo
    vec2 alpha;        // GGX, along local x and y
    float thin;        // 1: both faces of a thin wall at once, light passes straight on
    float layerEta;    // index of the layer's Fresnel curve, as seen from wo: see prepareBsdf, which fills both
    float layerKeep;   // 1, less where the layer reflects more than any index explains
    float baseGain;    // 1 / mean(T)
    LayerRow layerRow; // of the layer's albedo
    FacetLoss facets;  // of the metal part, if any; of its own facets, where a pixel that holds many normals has widened alpha
};

const uint kLobeDiffuse = 1u;
const uint kLobeReflection = 2u;
const uint kLobeTransmission = 4u;
const uint kLobeDelta = 8u;

// What depends on the view alone: worked out once for all the directions that are asked about at a point.
struct BsdfView {
    vec3 wo;
    vec3 lobes; // chances of the three lobes: x diffuse, y reflection, z transmission; all 0 below the horizon
    float pass; // of the layer, to the base
    vec3 again; // of light from everywhere, what leaves a metal after several facets
    float wide; // chance that a reflection is sampled for that, as from a matte surface
};

struct BsdfSample {
    vec3 direction; // local, unit
    vec3 weight;    // f |cos| / pdf, the choice of the lobe included; 0: absorbed, end the path
    float pdf;      // solid angle, of all non-delta lobes together; 0 for a delta lobe
    uint lobe;      // kLobe... bits
};

struct BsdfValue {
    vec3 f;
    float pdf;
};

FN float meanOf(vec3 c) { return (c.x + c.y + c.z) * (1.0f / 3.0f); }
FN float largestOf(vec3 c) { return max(max(c.x, c.y), c.z); }

// The layer's reflectance in colour, where a clear one of its index has the reflectance `clear`.
FN vec3 layerColor(IN(Bsdf) b, float clear)
{
    float f0 = dielectricF0(b.layerEta);
    float rise = (clear - f0) / (1.0f - f0); // from normal incidence (0) to 1; a little below 0 before Brewster's angle of a high index
    return max(mix(b.layer, vec3(b.layerEdge), rise), vec3(0.0f));
}
FN vec3 layerReflectance(IN(Bsdf) b, float c) { return layerColor(b, fresnelDielectric(c, b.layerEta)); }
// All interfaces of the mixture at a facet at cosine c.
FN vec3 interfaceReflectance(IN(Bsdf) b, float c)
{
    vec3 r = vec3(0.0f, 0.0f, 0.0f);
    if (b.metallic > 0.0f) r += b.metallic * mix(b.metal, vec3(1.0f), schlickWeight(c));
    if (b.layerEdge > 0.0f) r += (1.0f - b.metallic) * layerReflectance(b, c);
    return r;
}
// What a facet at cosine c lets through, of any colour: a scalar, so that a tinted reflection does not tint what lies below.
FN float layerPassOf(IN(Bsdf) b, float reflectance) { return max(1.0f - b.layerEdge * (1.0f - b.layerKeep * (1.0f - reflectance)), 0.0f); }
FN float layerPass(IN(Bsdf) b, float c) { return layerPassOf(b, fresnelDielectric(c, b.layerEta)); }

// What a clear layer of that index and roughness as a whole sends back at mu.
FN float clearAlbedo(IN(Bsdf) b, float mu)
{
    float f = fresnelDielectric(mu, b.layerEta);
    return isMirror(b.alpha) ? f : f * layerRatio(b.layerRow, mu);
}
// What the layer as a whole sends back at mu, and T(mu), what it lets through to the base: of any one colour they add up to 1 at most.
FN vec3 layerAlbedo(IN(Bsdf) b, float mu) { return b.layerEdge > 0.0f ? layerColor(b, clearAlbedo(b, mu)) : vec3(0.0f); }
FN float basePass(IN(Bsdf) b, float mu) { return b.layerEdge > 0.0f ? layerPassOf(b, clearAlbedo(b, mu)) : 1.0f; }

// Fills what is derived; call it once the other members stand.
// A tinted or scaled layer is that of the index which its largest channel asks for: its facets reflect layerEdge * F(c, layerEta) there.
// Beyond an index of 3.5 (F0 = 0.31: no clear solid) the curve is that of 3.5, lifted to the F0 asked for: 1 - R = keep * (1 - F). As no
// albedo exceeds 1, the same lift of the layer's albedo bound is again a bound.
FN void prepareBsdf(INOUT(Bsdf) b)
{
    const float kLargestRoot = 0.5555556f; // sqrt(F0) at eta = 3.5, inside the table of layer.h
    const float kTableSlack = 2e-4f;       // its averages are bounds from below up to this
    b.layerEta = 1.0f;
    b.layerKeep = 1.0f;
    b.baseGain = 1.0f;
    if (b.metallic > 0.0f) b.facets = facetLossOf(b.alpha);
    if (!(b.layerEdge > 0.0f)) return;
    float f0 = min(largestOf(b.layer) / b.layerEdge, 1.0f);
    float root = min(sqrt(f0), kLargestRoot);
    float thick = (1.0f + root) / (1.0f - root);
    b.layerEta = b.eta < 1.0f ? 1.0f / thick : thick;
    b.layerKeep = min((1.0f - f0) / (1.0f - root * root), 1.0f);
    b.layerRow = layerRow(min(b.alpha.x, b.alpha.y), b.layerEta);
    if (b.eta < 1.0f) return;
    float mean = fresnelAverage(thick);
    if (!isMirror(b.alpha)) mean = mean * layerMeanRatio(min(b.alpha.x, b.alpha.y), thick) - kTableSlack;
    // A rough base sends more light upright, where the layer lets more through, than the cosine: its own mean of T lies between the
    // cosine's and T(1), at most 0.21 r of the way by quadrature over mu, r, alpha and eta
    float pass = layerPassOf(b, mean);
    float gain = max(pass, mix(pass, basePass(b, 1.0f), 0.21f * b.roughness));
    b.baseGain = gain > 0.0f ? 1.0f / gain : 0.0f;
}

FN Bsdf lambertBsdf(vec3 albedo)
{
    Bsdf b;
    b.diffuse = albedo;
    b.roughness = 0.0f;
    b.metal = vec3(0.0f, 0.0f, 0.0f);
    b.metallic = 0.0f;
    b.layer = vec3(0.0f, 0.0f, 0.0f);
    b.layerEdge = 0.0f;
    b.transmission = vec3(0.0f, 0.0f, 0.0f);
    b.eta = 1.0f;
    b.alpha = vec2(1.0f, 1.0f);
    b.thin = 0.0f;
    b.layerEta = 1.0f;
    b.layerKeep = 1.0f;
    b.baseGain = 1.0f;
    return b;
}

// Any lobe that exists keeps a chance.
FN BsdfView viewBsdf(IN(Bsdf) b, vec3 wo)
{
    float least = isMirror(b.alpha) ? 0.0f : 0.02f; // a facet may reflect (or pass) where the mean surface does not
    BsdfView view;
    view.wo = wo;
    view.lobes = vec3(0.0f, 0.0f, 0.0f);
    view.pass = 0.0f;
    view.again = vec3(0.0f, 0.0f, 0.0f);
    view.wide = 0.0f;
    if (!(wo.z > 0.0f)) return view;
    view.pass = basePass(b, wo.z);
    vec3 w = vec3(meanOf(b.diffuse) * view.pass, 0.0f, 0.0f);
    if (b.metallic > 0.0f || b.layerEdge > 0.0f) w.y = meanOf(interfaceReflectance(b, wo.z)) + least;
    if (b.metallic > 0.0f && b.facets.share > 0.0f) {
        view.again = facetColor(b.metal, b.facets.mean) * (b.metallic * b.facets.share * facetLoss(b.facets, wo.z));
        float again = meanOf(view.again);
        w.y += again;
        view.wide = again / w.y;
    }
    w.z = meanOf(b.transmission);
    if (w.z > 0.0f) w.z *= layerPass(b, wo.z) + least;
    float sum = w.x + w.y + w.z;
    view.lobes = sum > 0.0f ? w / sum : w;
    return view;
}

// Matte base: with roughness, part of the samples are uniform, for its lobe grows without bound toward grazing retro-reflection.
FN float baseUniformShare(IN(Bsdf) b) { return 0.5f * b.roughness; }
FN float basePdf(IN(Bsdf) b, vec3 wi) { return mix(cosineHemispherePdf(wi.z), kInvTwoPi, baseUniformShare(b)); }
FN vec3 baseValue(IN(Bsdf) b, IN(BsdfView) view, vec3 wi)
{
    return eon(b.diffuse, b.roughness, view.wo, wi) * (view.pass * basePass(b, wi.z) * b.baseGain);
}

// All interfaces, but for delta lobes; wi on the side of wo.
FN vec3 onceValue(IN(Bsdf) b, IN(BsdfView) view, vec3 wi)
{
    return interfaceReflectance(b, dot(view.wo, normalize(view.wo + wi))) * ggxReflect(view.wo, wi, b.alpha);
}
FN vec3 againValue(IN(Bsdf) b, IN(BsdfView) view, vec3 wi)
{
    return view.wide > 0.0f ? view.again * (facetLoss(b.facets, wi.z) / (kPi * b.facets.mean)) : vec3(0.0f);
}
FN float reflectionPdf(IN(Bsdf) b, IN(BsdfView) view, vec3 wi)
{
    float pdf = ggxReflectPdf(view.wo, wi, b.alpha);
    return view.wide > 0.0f ? mix(pdf, cosineHemispherePdf(wi.z), view.wide) : pdf;
}

// Of light from wi that leaves by `f`, the base's share.
FN vec3 baseShare(IN(Bsdf) b, IN(BsdfView) view, vec3 wi, vec3 f)
{
    if (!(wi.z > 0.0f && view.lobes.x > 0.0f)) return vec3(0.0f, 0.0f, 0.0f);
    return baseValue(b, view, wi) / max(f, vec3(1e-30f, 1e-30f, 1e-30f));
}

// The facet normal that refracts wo into wi, on the side of wo; (0,0,0) when there is none.
FN vec3 refractionHalf(vec3 wo, vec3 wi, float eta)
{
    vec3 h = wi * eta + wo;
    float l = length(h);
    if (!(l > 1e-6f)) return vec3(0.0f, 0.0f, 0.0f);
    h = h / (h.z < 0.0f ? -l : l);
    return dot(wo, h) > 0.0f && dot(wi, h) < 0.0f ? h : vec3(0.0f, 0.0f, 0.0f);
}

// Rough transmission, wi.z < 0. Walter's Jacobian |i.h| / (i.h + o.h / eta)^2; radiance is scaled by 1 / eta^2 as seen from wo.
FN BsdfValue transmissionValue(IN(Bsdf) b, vec3 wo, vec3 wi)
{
    BsdfValue v;
    v.f = vec3(0.0f, 0.0f, 0.0f);
    v.pdf = 0.0f;
    if (b.thin > 0.0f) {
        vec3 turned = vec3(wi.x, wi.y, -wi.z);
        vec3 h = normalize(wo + turned);
        v.f = b.transmission * (layerPass(b, dot(wo, h)) * ggxReflect(wo, turned, b.alpha));
        v.pdf = ggxReflectPdf(wo, turned, b.alpha);
        return v;
    }
    vec3 h = refractionHalf(wo, wi, b.eta);
    if (!(h.z > 0.0f)) return v;
    float o = dot(wo, h), i = dot(wi, h);
    float q = i + o / b.eta;
    if (!(q * q > 1e-12f)) return v;
    float jacobian = -i / (q * q);
    v.f = b.transmission * (layerPass(b, o) * ggxD(h, b.alpha) * 4.0f * ggxVisibility(wo, wi, b.alpha) * o * jacobian / (b.eta * b.eta));
    v.pdf = ggxVisiblePdf(wo, h, b.alpha) * jacobian;
    return v;
}

// f and the density of sampleBsdf, without the delta lobes.
FN BsdfValue valueBsdf(IN(Bsdf) b, IN(BsdfView) view, vec3 wi)
{
    BsdfValue v;
    v.f = vec3(0.0f, 0.0f, 0.0f);
    v.pdf = 0.0f;
    if (wi.z == 0.0f) return v;
    bool mirror = isMirror(b.alpha);
    if (wi.z > 0.0f) {
        if (view.lobes.x > 0.0f) {
            v.f = baseValue(b, view, wi);
            v.pdf = view.lobes.x * basePdf(b, wi);
        }
        if (view.lobes.y > 0.0f && !mirror) {
            v.f += onceValue(b, view, wi) + againValue(b, view, wi);
            v.pdf += view.lobes.y * reflectionPdf(b, view, wi);
        }
    } else if (view.lobes.z > 0.0f && !mirror) {
        v = transmissionValue(b, view.wo, wi);
        v.pdf *= view.lobes.z;
    }
    return v;
}
FN BsdfValue bsdfValue(IN(Bsdf) b, vec3 wo, vec3 wi) { return valueBsdf(b, viewBsdf(b, wo), wi); }
FN vec3 bsdfEvaluate(IN(Bsdf) b, vec3 wo, vec3 wi) { return bsdfValue(b, wo, wi).f; }
FN float bsdfPdf(IN(Bsdf) b, vec3 wo, vec3 wi) { return bsdfValue(b, wo, wi).pdf; }

// uLobe chooses the lobe, u the direction in it.
FN BsdfSample sampleBsdf(IN(Bsdf) b, IN(BsdfView) view, float uLobe, vec2 u)
{
    BsdfSample s;
    s.direction = vec3(0.0f, 0.0f, 1.0f);
    s.weight = vec3(0.0f, 0.0f, 0.0f);
    s.pdf = 0.0f;
    s.lobe = 0u;
    vec3 wo = view.wo, lobes = view.lobes;
    if (!(wo.z > 0.0f)) return s;
    bool mirror = isMirror(b.alpha);

    if (uLobe < lobes.x) {
        s.lobe = kLobeDiffuse;
        float share = baseUniformShare(b), choice = uLobe / lobes.x;
        s.direction = choice < share ? sampleUniformHemisphere(u) : sampleCosineHemisphere(u);
    } else if (uLobe < lobes.x + lobes.y || (lobes.z == 0.0f && lobes.y > 0.0f)) {
        s.lobe = kLobeReflection;
        if (uLobe - lobes.x < view.wide * lobes.y) {
            s.direction = sampleCosineHemisphere(u);
        } else {
            vec3 h = mirror ? vec3(0.0f, 0.0f, 1.0f) : sampleGgxVisible(wo, b.alpha, u);
            s.direction = mirrorDirection(wo, h);
        }
        if (mirror) {
            s.lobe |= kLobeDelta;
            s.weight = interfaceReflectance(b, wo.z) / lobes.y;
            return s;
        }
        if (!(s.direction.z > 0.0f)) return s;
    } else if (lobes.z > 0.0f) {
        s.lobe = kLobeTransmission;
        vec3 h = mirror ? vec3(0.0f, 0.0f, 1.0f) : sampleGgxVisible(wo, b.alpha, u);
        float scale = 1.0f;
        if (b.thin > 0.0f) {
            vec3 reflected = mirrorDirection(wo, h);
            s.direction = vec3(reflected.x, reflected.y, -reflected.z);
        } else {
            vec3 bent;
            if (!refractDirection(wo, h, b.eta, bent)) return s; // Total reflection: the other lobe's
            s.direction = bent;
            scale = 1.0f / (b.eta * b.eta);
        }
        if (mirror) {
            s.lobe |= kLobeDelta;
            s.weight = b.transmission * (layerPass(b, wo.z) * scale / lobes.z);
            return s;
        }
        if (!(s.direction.z < 0.0f)) return s;
    } else {
        return s;
    }
    BsdfValue v = valueBsdf(b, view, s.direction);
    s.pdf = v.pdf;
    if (v.pdf > 0.0f) s.weight = v.f * (abs(s.direction.z) / v.pdf);
    return s;
}
FN BsdfSample bsdfSample(IN(Bsdf) b, vec3 wo, float uLobe, vec2 u) { return sampleBsdf(b, viewBsdf(b, wo), uLobe, u); }

SHARED_END
#endif
