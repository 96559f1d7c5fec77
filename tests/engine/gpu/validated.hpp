// The fixture of every test that touches the GPU: validation and synchronization validation are on, and a word from them fails the test.
#pragma once
#include "engine/gpu/gpu.hpp"
#include <gtest/gtest.h>

namespace afterglow
{
inline DeviceOptions validatedOptions()
{
    DeviceOptions options = deviceOptions("");
    options.validation = true; // a missing layer throws, with what to install
    return options;
}

class Validated : public ::testing::Test
{
protected:
    ~Validated() override
    {
        for (const std::string& message : gpu.device.messages) ADD_FAILURE() << message;
    }
    Gpu gpu{validatedOptions()};
};
}
