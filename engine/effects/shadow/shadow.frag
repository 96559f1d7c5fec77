#version 460
// A caster's depth, pushed back by what it rises within the filter. Less is farther: depth is reversed.
#include "engine/effects/shadow/shadow.h"

layout(push_constant, scalar) uniform Push { ShadowPush push; };
layout(depth_less) out float gl_FragDepth;

void main() { gl_FragDepth = pushedBack(gl_FragCoord.z, fwidth(gl_FragCoord.z), push.furthest); }
