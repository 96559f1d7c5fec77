// Random numbers: hashes, and the sampler of every estimator: Owen-scrambled Sobol points, padded by pairs of dimensions.
// Based on: Jarzynski & Olano 2020 (PCG hash), Burley 2020 (hash-based Owen scrambling), Vegdahl 2021 (its constants).
#ifndef AFTERGLOW_RANDOM_H
#define AFTERGLOW_RANDOM_H
#include "shaders/constants.h"
SHARED_BEGIN

FN uint hash1(uint x)
{
    uint state = x * 747796405u + 2891336453u;
    uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}
FN uint hash2(uint x, uint y) { return hash1(x ^ hash1(y)); }
FN uint hash3(uint x, uint y, uint z) { return hash1(x ^ hash1(y ^ hash1(z))); }

// [0, 1): 24 bits, at most 1 - 2^-24.
FN float unitFloat(uint bits) { return float(bits >> 8u) * (1.0f / 16777216.0f); }
FN float hashFloat(uint x) { return unitFloat(hash1(x)); }

// A random permutation that keeps the tree of bits: the low bits steer the high ones (Laine-Karras).
FN uint treeHash(uint x, uint seed)
{
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16u) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return x;
}

// Second Sobol dimension of the index, bit-reversed: Pascal's triangle mod 2 times the bits (Ahmed 2024).
FN uint pascalBits(uint index)
{
    index ^= (index >> 1u) & 0x55555555u;
    index ^= (index >> 2u) & 0x33333333u;
    index ^= (index >> 4u) & 0x0f0f0f0fu;
    index ^= (index >> 8u) & 0x00ff00ffu;
    index ^= index >> 16u;
    return index;
}

// The stream of one path. Equal seeds share one point set: their indices 0, 1, 2... cover the unit square evenly, in every pair.
struct Sampler {
    uint seed;
    uint index;     // sample index, bit-reversed
    uint dimension; // pairs drawn so far
};

FN Sampler makeSampler(uint pixelOrTexelSeed, uint sampleIndex)
{
    Sampler s;
    s.seed = hash1(pixelOrTexelSeed);
    s.index = bitfieldReverse(sampleIndex);
    s.dimension = 0u;
    return s;
}
FN uint sampleIndexOf(Sampler s) { return bitfieldReverse(s.index); } // as makeSampler was given it

FN vec2 next2(INOUT(Sampler) s)
{
    // Shuffle the order of the points for this pair, then scramble each axis: pairs are independent, each is a (0,2)-sequence.
    uint order = hash2(s.dimension, s.seed);
    s.dimension += 1u;
    uint index = bitfieldReverse(treeHash(s.index, order));
    uint x = bitfieldReverse(treeHash(index, hash1(order)));
    uint y = bitfieldReverse(treeHash(pascalBits(index), hash1(order + 1u)));
    return vec2(unitFloat(x), unitFloat(y));
}

FN float next1(INOUT(Sampler) s)
{
    uint order = hash2(s.dimension, s.seed);
    s.dimension += 1u;
    uint index = bitfieldReverse(treeHash(s.index, order));
    return unitFloat(bitfieldReverse(treeHash(index, hash1(order))));
}

SHARED_END
#endif
