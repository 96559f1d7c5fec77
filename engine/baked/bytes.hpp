// Little-endian numbers in and out of bytes, on any machine.
#pragma once
#include <bit>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace afterglow
{
using Bytes = std::vector<std::uint8_t>;

template <class Number>
void put(Bytes& bytes, std::type_identity_t<Number> number)
{
    for (std::size_t i = 0; i < sizeof(Number); ++i) bytes.push_back(std::uint8_t(std::uint64_t(number) >> (8 * i)));
}
inline void put32(Bytes& bytes, std::uint32_t number) { put<std::uint32_t>(bytes, number); }
inline void put64(Bytes& bytes, std::uint64_t number) { put<std::uint64_t>(bytes, number); }
inline void putFloat(Bytes& bytes, float number) { put32(bytes, std::bit_cast<std::uint32_t>(number)); }

// The caller knows that the bytes are there.
template <class Number>
Number get(const std::uint8_t* at)
{
    std::uint64_t number = 0;
    for (std::size_t i = 0; i < sizeof(Number); ++i) number |= std::uint64_t(at[i]) << (8 * i);
    return Number(number);
}
inline std::uint16_t get16(const std::uint8_t* at) { return get<std::uint16_t>(at); }
inline std::uint32_t get32(const std::uint8_t* at) { return get<std::uint32_t>(at); }
inline std::uint64_t get64(const std::uint8_t* at) { return get<std::uint64_t>(at); }
inline float getFloat(const std::uint8_t* at) { return std::bit_cast<float>(get32(at)); }

// Zeros up to a multiple of `alignment`.
inline void pad(Bytes& bytes, std::size_t alignment) { bytes.resize((bytes.size() + alignment - 1) / alignment * alignment); }
}
