// Makes the two sides of a seam agree: texels that lookups on seams touch are moved, the less the better they are known, until both sides
// read the same.
#pragma once
#include "baker/seam_steps.hpp"

namespace afterglow
{
// Pages are filtered and dilated; `seams` knows their texels (remember()), and no points but those of one surface (dropParted()). Dilated
// texels are guesses and yield first; those with light of their own yield by their noise and, where their chart covers but a part of them,
// by what light may differ from there to their middle. A step counts by how it is seen, and less where light changes from texel to texel:
// that is the likeliest light. Where it steps by more than a display shows, all yield further. No texel becomes negative; directions are
// stitched like light, but no further than is likely. The same for any number of threads.
void stitch(std::vector<Lightmap>& pages, const Seams& seams, const Shown& shown, int threads);
}
