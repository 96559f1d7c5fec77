#include "engine/effects/virtual_view.hpp"
#include <algorithm>
#include <cmath>

namespace afterglow
{
namespace
{
// Of the level's diagonal: nothing nearer to the plane of a flat is seen in it. Rounding of a vertex is 1e-7 of its coordinates, so the
// flat itself, which lies in its own near plane, stays out.
constexpr double kGap = 1e-5;
constexpr int kGrain = 32;            // px: pictures grow in such steps, so that their memory serves the next frame too
constexpr double kRippleMargin = 0.1; // of the picture's height: how far beyond the flat, and beyond the border, ripples look
constexpr double kLeastCosine = 1e-3; // between a flat and an orthographic eye

double diagonalOf(const GpuScene& scene) { return std::max(double(distance(scene.lower, scene.upper)), 1.0); }

// 1: the eye looks at its front, -1: at a back that mirrors too, 0: neither.
float sideOf(const Flat& flat, const View& eye, double gap)
{
    const double towards = dot(flat.normal, dvec3(eye.eye));
    const double off = eye.eye.w > 0.0f ? (towards - flat.offset) / gap : towards / kLeastCosine;
    if (off > 1.0) return 1.0f;
    return flat.twoSided && off < -1.0 ? -1.0f : 0.0f;
}

using Polygon = std::vector<dvec4>; // clip space

// What of it lies where `inside` is positive, a linear function.
template <typename Inside>
Polygon cut(const Polygon& all, Inside inside)
{
    Polygon kept;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const dvec4 &a = all[i], &b = all[(i + 1) % all.size()];
        const double fa = inside(a), fb = inside(b);
        if (fa >= 0.0) kept.push_back(a);
        if ((fa >= 0.0) != (fb >= 0.0)) kept.push_back(a + (b - a) * (fa / (fa - fb)));
    }
    return kept;
}

struct Area {
    ivec2 lower{0}, upper{0};
};

// The pixels that a flat may cover, outwards to whole grains; none: it is out of sight.
std::optional<Area> areaOf(const View& eye, const Flat& flat)
{
    Polygon corners;
    for (const dvec3& corner : flat.corners) corners.push_back(dmat4(eye.worldToClip) * dvec4(corner, 1.0));
    corners = cut(corners, [](const dvec4& c) { return c.w - 1e-6; });
    corners = cut(corners, [](const dvec4& c) { return c.w - c.z; });
    const dvec2 size(eye.size);
    dvec2 lower(1e9), upper(-1e9);
    for (const dvec4& c : corners) {
        const dvec2 pixel = (dvec2(c) / c.w * 0.5 + 0.5) * size;
        lower = min(lower, pixel);
        upper = max(upper, pixel);
    }
    const dvec2 margin(flat.rippled ? kRippleMargin * size.y : 0.0);
    if (!(lower.x < size.x && lower.y < size.y && upper.x > 0.0 && upper.y > 0.0)) return std::nullopt;
    lower = max(lower - margin, -margin);
    upper = min(upper + margin, size + margin);
    const auto grains = [](dvec2 pixels) { return ivec2(floor(pixels / double(kGrain))) * kGrain; };
    const ivec2 border(ceil(margin));
    return Area{max(grains(lower), -border), min(grains(upper + double(kGrain)), ivec2(eye.size) + border)};
}

// Of the eye's clip space to that of the area, flipped or not.
dmat4 fit(const Area& area, uvec2 picture, bool flipped)
{
    const dvec2 size(picture), own(area.upper - area.lower);
    const dvec2 scale = size / own, offset = (size - 2.0 * dvec2(area.lower) - own) / own;
    const double side = flipped ? -1.0 : 1.0;
    dmat4 m(1.0);
    m[0][0] = side * scale.x;
    m[1][1] = scale.y;
    m[3][0] = side * offset.x;
    m[3][1] = offset.y;
    return m;
}

std::optional<VirtualView> viewThrough(const View& eye, const GpuScene& scene, const Flat& flat)
{
    const double diagonal = diagonalOf(scene), gap = kGap * diagonal;
    const float side = sideOf(flat, eye, gap);
    if (side == 0.0f) return std::nullopt;
    const std::optional<Area> area = areaOf(eye, flat);
    if (!area) return std::nullopt;

    VirtualView made;
    made.flat = &flat;
    made.corner = area->lower;
    made.side = side;
    made.flipped = flat.kind == FlatKind::mirror;
    View& view = made.view;
    view.size = uvec2(area->upper - area->lower);
    view.frame = eye.frame;
    view.textureBias = eye.textureBias;
    view.mayStray = eye.mayStray;
    view.jitter = eye.jitter * vec2(made.flipped ? -1.0f : 1.0f, 1.0f);
    view.fromNear = true;
    view.eye = vec4(flat.through * dvec4(eye.eye)); // a place or, with w = 0, a direction
    dmat4 toClip = fit(*area, eye.size, made.flipped) * dmat4(eye.worldToClip) * inverse(flat.through);
    // The end of the view, by which the depth is measured out: directions of a perspective, and of parallel rays where the level ends
    const dvec3 centre = 0.5 * dvec3(scene.lower + scene.upper);
    const dvec4 last = view.eye.w > 0.0f ? dvec4(0, 0, 0, 1)
                                         : dvec4(dvec3(view.eye) / (2.0 * diagonal), 0.5 - dot(dvec3(view.eye), centre) / (2.0 * diagonal));
    for (int c = 0; c < 4; ++c) toClip[c][2] = last[c];
    const vec4 plane(side * vec3(flat.beyond), float(-double(side) * flat.beyondOffset - gap));
    const float reach = obliqueReach(mat4(inverse(toClip)), plane);
    if (!(reach > 0.0f)) return std::nullopt; // nothing beyond it is in view
    view.worldToClip = obliqueNearPlane(mat4(toClip), plane, reach);
    view.clipToWorld = mat4(inverse(dmat4(view.worldToClip)));
    return made;
}

int pixels(const VirtualView& v) { return int(v.view.size.x * v.view.size.y); }
}

std::vector<VirtualView> virtualViews(const View& eye, const GpuScene& scene, const std::vector<Flat>& flats, std::size_t most)
{
    std::vector<VirtualView> views;
    for (std::size_t i = 0; i < flats.size(); ++i) {
        std::optional<VirtualView> seen = viewThrough(eye, scene, flats[i]);
        if (!seen) continue;
        seen->number = i;
        views.push_back(std::move(*seen));
    }
    std::stable_sort(views.begin(), views.end(), [](const VirtualView& a, const VirtualView& b) { return pixels(a) > pixels(b); });
    if (views.size() > most) views.resize(most);
    return views;
}

std::string nameOf(const VirtualView& view)
{
    return (view.flat->kind == FlatKind::mirror ? "planar." : "portal.") + std::to_string(view.number);
}

bool belongs(const DrawItem& item, const Flat& flat)
{
    return std::find(flat.surfaces.begin(), flat.surfaces.end(), item.place) != flat.surfaces.end();
}

static bool isOf(const DrawItem& item, const Flat& flat, FlatPart part)
{
    return (item.kind == DrawKind::clear) == (part == FlatPart::clear) && belongs(item, flat);
}

static bool hasPart(const GpuScene& scene, const Flat& flat, FlatPart part)
{
    return std::any_of(scene.draws.begin(), scene.draws.end(), [&](const DrawItem& item) { return isOf(item, flat, part); });
}

void eachInPlace(const std::string& effect, const std::vector<VirtualPicture>& pictures, const GpuScene& scene, FlatPart part,
                 const PutInPlace& put)
{
    for (const VirtualPicture& picture : pictures)
        if (hasPart(scene, *picture.from.flat, part)) put(nameOf(picture.from) + (part == FlatPart::clear ? ".clear" : ""), picture);
    if (pictures.empty() && part == FlatPart::solid) put(effect, {});
}

std::function<void(Draw&)> flatDraws(const GpuScene& scene, const View& eye, const Flat& flat, FlatPart part)
{
    return [&scene, eye, &flat, part](Draw& draw) {
        draw.indices(scene.indices);
        for (const DrawItem& item : scene.draws)
            if (isOf(item, flat, part) && mayBeSeen(eye.worldToClip, item.lower, item.upper)) drawSurface(draw, scene, eye, item);
    };
}
}
