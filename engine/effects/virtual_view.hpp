// An eye behind a mirror or a portal: the level as a flat surface shows it, in the pixels that the surface may cover and in no others, so
// that whatever is drawn for it, full-screen passes too, costs what the surface takes of the picture.
#pragma once
#include "engine/effects/surface_draws.hpp"
#include "engine/scene/flats.hpp"

namespace afterglow
{
struct VirtualView {
    const Flat* flat = nullptr;
    std::size_t number = 0; // of the flat in its list
    View view;              // its near plane is the flat: what lies before it, or behind the mirror, is not there
    ivec2 corner{0};        // of its picture in the picture that it was made for, px; beyond the border where ripples may look
    float side = 1.0f;      // of the plane on which the eye is: -1 where it looks at the back of a mirror
    bool flipped = false;   // in x, so that fronts of triangles stay fronts: a mirror image
};

// Of the passes that draw it, and of the one that puts its picture in place: "planar.0", "portal.1".
std::string nameOf(const VirtualView& view);

// What was drawn for it.
struct VirtualPicture {
    VirtualView from;
    Texture radiance, depth;
};

// The flats that show something to this eye, those that cover most of the picture first, `most` at most. An eye on the plane of a flat, or
// behind one that has no back, sees nothing in it. `flats` must outlive the frame.
std::vector<VirtualView> virtualViews(const View& eye, const GpuScene& scene, const std::vector<Flat>& flats, std::size_t most);

bool belongs(const DrawItem& item, const Flat& flat);

// What is seen in a flat is drawn when its own surface is: with the solid ones, so that what is clear can stand before it, or after the
// clear ones, of which it is one. Coplanar surfaces may be of both kinds.
enum class FlatPart { solid, clear };

// What puts one picture in place, in a pass of that name.
using PutInPlace = std::function<void(const std::string& pass, const VirtualPicture&)>;
// All whose flats have that part; without any picture once, with an empty one, so that an effect that is forced on has its pipeline.
void eachInPlace(const std::string& effect, const std::vector<VirtualPicture>& pictures, const GpuScene& scene, FlatPart part,
                 const PutInPlace& put);

// For Pass::draw of a pass that uses surface.vert: that part of the flat, as `eye` sees it. `scene` and `flat` must outlive the run.
std::function<void(Draw&)> flatDraws(const GpuScene& scene, const View& eye, const Flat& flat, FlatPart part);
}
