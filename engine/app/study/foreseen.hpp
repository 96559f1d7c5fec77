// What can be said of a study before its level is baked.
#pragma once
#include "engine/frame/plan.hpp"

namespace afterglow
{
// The plan of the level and a bake of all that it calls for. Only what the baker finds none of, though it is called for, is otherwise
// later.
Plan foreseenPlan(const Scene& level, const Settings& settings);
}
