// Shares the pages out among the objects: an object's charts lie together on one page.
#pragma once
#include "baker/atlas_press.hpp"

namespace afterglow
{
using Footprints = std::vector<const Footprint*>; // of one object

struct Pages {
    std::vector<ivec2> sizes;
    std::vector<int> page;                // per object
    std::vector<std::vector<Spot>> spots; // per object and footprint
};

struct PageLimits {
    int edge = 1024;        // of a page that several objects share
    int largestEdge = 4096; // of a page that one object may ask for
    int grain = 8;          // sizes are multiples of it
};

// As many pages as it takes, none larger than what it holds. An object too large for the largest page is a programmer's error: ask fitsPage() first.
Pages sharePages(const std::vector<Footprints>& objects, const PageLimits& limits);

// A given number of pages of limits.edge. The last one holds what is left, and is as high as that makes it.
Pages fillPages(const std::vector<Footprints>& objects, int count, const PageLimits& limits);

// The same objects on the same pages when all footprints have grown by a factor, `larger`; nothing when they could not be pressed in.
std::optional<Pages> pressPages(const std::vector<Footprints>& objects, Pages pages, double larger, Patience& patience);

bool fitsPage(const Footprints& object, const PageLimits& limits);
}
