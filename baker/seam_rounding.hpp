// What the file of a lightmap page makes of a patch of seams: it rounds every texel, and dark channels beside a bright one by as much as a
// display shows.
#pragma once
#include "baker/agreement.hpp"

namespace afterglow
{
// Where plain rounding leaves a point with a step above `target`, texels are rounded otherwise, until it is below or nothing helps. Others
// stay as they are.
void roundTogether(const SeamPatch& patch, std::vector<vec3>& light, const StepOf& stepOf, double target);
}
