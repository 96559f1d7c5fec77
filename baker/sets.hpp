// Sets of numbers that grow together; each is known by its smallest.
#pragma once
#include "shaders/glsl.h"
#include <numeric>
#include <vector>

namespace afterglow
{
using namespace shared;

class Sets
{
public:
    explicit Sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }
    uint root(uint i)
    {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(uint a, uint b)
    {
        a = root(a), b = root(b);
        parent_[max(a, b)] = min(a, b);
    }

private:
    std::vector<uint> parent_;
};
}
