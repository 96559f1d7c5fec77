#version 460
// The law of the toon's edges, for the values that the test asks about.
#include "shaders/tones.h"
layout(local_size_x = 64) in;
struct Question { float response; float edge; float width; };
layout(set = 1, binding = 0, scalar) readonly buffer Questions { Question questions[]; };
layout(set = 1, binding = 1, scalar) writeonly buffer Answers { float answers[]; };
void main()
{
    const uint i = gl_GlobalInvocationID.x;
    if (i < questions.length()) answers[i] = toonShare(questions[i].response, questions[i].edge, questions[i].width);
}
