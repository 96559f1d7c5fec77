// What each stage of a bake is reckoned to take before it has begun, for the remaining time of the whole.
#pragma once
#include "baker/baker.hpp"
#include "engine/core/forecast.hpp"

namespace afterglow
{
// `made`: resolved, with the products that are made. `area`: m2 of what carries lightmaps, whose light is of so many layers.
std::vector<StageForecast> reckoned(const Scene& scene, const BakeOptions& made, double area, std::size_t layers = 1);
}
