// A second pi, and a second luminance: both must be found.
const float area = 4.0f * 3.14159f;
float grey(float r, float g, float b) { return 0.2126f * r + 0.7152f * g + 0.0722f * b; }
