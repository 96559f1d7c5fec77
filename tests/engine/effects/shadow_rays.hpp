// The share of lights that reaches the floor, by ray query.
#pragma once
#include "tests/engine/effects/lit_share.hpp"

namespace afterglow
{
class ShadowsByRay : public LitShare
{
protected:
    void SetUp() override
    {
        if (!gpu.device.rayQuery) GTEST_SKIP() << gpu.device.deviceName << " has no ray queries";
    }

    Image litShare(const Camera& camera, uint rays = 16)
    {
        ShadowParameters parameters = defaultShadowParameters();
        parameters.rays = rays;
        return litShareOf(camera, {.shadow = true, .shadowMethod = ShadowMethod::ray, .shadowParameters = parameters});
    }
};
}
