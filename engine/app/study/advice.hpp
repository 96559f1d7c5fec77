// What a person should do about a curve, in one sentence that its numbers say.
#pragma once
#include "engine/app/study/study.hpp"

namespace afterglow
{
// 2.3 ms, 41 ms, 1.2 s.
std::string spokenTime(double ms);
std::string spokenBytes(double bytes);

// The same by the sweep's clock: of one ray, where there are a million.
std::string spokenPrice(const Sweep& sweep, double ms);

// 1.2 % of radiance; 0.012 of values; 0 % of hits; less than can be told (noise 1.2 %).
std::string spokenError(const Sweep& sweep, const Point& point);

// After markPareto(): it compares with what the whole chart holds.
std::string adviceOf(const Curve& curve, const std::vector<const Curve*>& chart);
}
