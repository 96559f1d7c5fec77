#include "engine/scene/sky.hpp"
#include "shaders/color.h"
#include <cmath>

namespace afterglow
{
// Solid angle of a texel in row y goes with the sine at the row's middle.
static double rowSine(int y, int height) { return std::sin(double(kPi) * (y + 0.5) / height); }

// Mean over a texel of what lookups show there, which mix it with its neighbours by their distance: half of a small sun's light is beside
// its texel, and must be chosen there.
static double shownLuminance(const Image& image, int x, int y)
{
    const double weight[3] = {0.125, 0.75, 0.125};
    double sum = 0.0;
    for (int j = -1; j <= 1; j++)
        for (int i = -1; i <= 1; i++) {
            const float* p = image.at((x + i + image.width) % image.width, clamp(y + j, 0, image.height - 1));
            sum += weight[i + 1] * weight[j + 1] * double(luminance(vec3(p[0], p[1], p[2])));
        }
    return sum;
}

SkyTable skyTable(const Image& image)
{
    SkyTable table;
    table.rows.resize(std::size_t(image.height));
    table.columns.resize(std::size_t(image.width) * std::size_t(image.height));
    double total = 0.0;
    for (int y = 0; y < image.height; y++) {
        float* columns = &table.columns[std::size_t(y) * std::size_t(image.width)];
        double row = 0.0;
        for (int x = 0; x < image.width; x++) {
            row += shownLuminance(image, x, y);
            columns[x] = float(row);
        }
        for (int x = 0; x < image.width && row > 0.0; x++) columns[x] /= float(row);
        total += row * rowSine(y, image.height);
        table.rows[std::size_t(y)] = float(total);
    }
    if (total > 0.0)
        for (float& row : table.rows) row /= float(total);
    else
        table.rows.clear();
    return table;
}
}
