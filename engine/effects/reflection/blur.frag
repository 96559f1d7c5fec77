#version 460
// One level of the pyramid of what the traced rays met: its colour, times the share of it, and its nearness, times the same share; so that
// what nothing was met at has no say. 4 x 4 texels weigh 1 3 3 1, for means of four would show their squares.
layout(set = 1, binding = 0) uniform sampler2D finerColor;
layout(set = 1, binding = 1) uniform sampler2D finerNearness;
layout(location = 0) out vec4 color;
layout(location = 1) out float nearness;

void main()
{
    vec2 texel = 1.0 / vec2(textureSize(finerColor, 0));
    vec2 middle = (2.0 * floor(gl_FragCoord.xy) + 1.0) * texel, apart = 0.75 * texel; // a filtered tap there weighs its two texels 3 : 1
    vec2 a = middle - apart, b = middle + vec2(apart.x, -apart.y), c = middle + vec2(-apart.x, apart.y), d = middle + apart;
    color = 0.25 * (textureLod(finerColor, a, 0.0) + textureLod(finerColor, b, 0.0) + textureLod(finerColor, c, 0.0) +
                    textureLod(finerColor, d, 0.0));
    nearness = 0.25 * (textureLod(finerNearness, a, 0.0).r + textureLod(finerNearness, b, 0.0).r + textureLod(finerNearness, c, 0.0).r +
                       textureLod(finerNearness, d, 0.0).r);
}
