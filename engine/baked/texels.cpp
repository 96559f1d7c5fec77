#include "engine/baked/texels.hpp"
#include "engine/baked/bytes.hpp"
#include "engine/core/error.hpp"
#include "shaders/lightmap.h"
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace afterglow
{
using shared::vec3;
using shared::vec4;

static float largest(Ktx2Format format)
{
    if (format == Ktx2Format::rgb9e5) return shared::kSharedExponentMax;
    return format == Ktx2Format::rgba16f ? shared::kHalfMax : shared::kFloatMax;
}

static constexpr float kFaint = 1.52587890625e-5f; // 2^-16: the steps of a shared exponent end at 2^-24, 2^-8 of this

Ktx2Format holding(std::span<const vec4> texels, Ktx2Format wanted)
{
    const bool shares = wanted == Ktx2Format::rgb9e5;
    float brightest = 0.0f;
    for (const vec4& texel : texels)
        for (int c = 0; c < (shares ? 3 : 4); ++c)
            if (std::abs(texel[c]) > brightest) brightest = std::abs(texel[c]); // NaN fails the comparison
    const bool faint = shares && brightest > 0.0f && brightest < kFaint;
    return std::isfinite(brightest) && (faint || brightest > largest(wanted)) ? Ktx2Format::rgba32f : wanted;
}

std::vector<std::uint8_t> packTexels(std::span<const vec4> texels, Ktx2Format format)
{
    Bytes bytes;
    bytes.reserve(texels.size() * std::size_t(texelBytes(format)));
    const float bound = largest(format);
    for (const vec4& texel : texels) {
        if (format == Ktx2Format::rgb9e5) {
            put32(bytes, shared::encodeSharedExponent(vec3(texel)));
            continue;
        }
        for (int c = 0; c < 4; ++c) {
            const float value = std::isnan(texel[c]) ? 0.0f : std::clamp(texel[c], -bound, bound);
            if (format == Ktx2Format::rgba16f)
                put<std::uint16_t>(bytes, glm::packHalf1x16(value));
            else
                putFloat(bytes, value);
        }
    }
    return bytes;
}

std::vector<vec4> unpackTexels(std::span<const std::uint8_t> bytes, Ktx2Format format)
{
    std::vector<vec4> texels(bytes.size() / std::size_t(texelBytes(format)), vec4(0.0f, 0.0f, 0.0f, 1.0f));
    const std::uint8_t* at = bytes.data();
    for (vec4& texel : texels) {
        if (format == Ktx2Format::rgb9e5)
            texel = vec4(shared::decodeSharedExponent(get32(at)), 1.0f);
        else if (format == Ktx2Format::rgba16f)
            for (int c = 0; c < 4; ++c) texel[c] = glm::unpackHalf1x16(get16(at + 2 * c));
        else
            for (int c = 0; c < 4; ++c) texel[c] = getFloat(at + 4 * c);
        at += texelBytes(format);
        for (int c = 0; c < 4; ++c)
            if (!std::isfinite(texel[c])) texel[c] = 0.0f; // never written; a foreign file may hold it
    }
    return texels;
}

std::string numbersText(std::span<const double> numbers)
{
    std::string text;
    for (double number : numbers) {
        char digits[32];
        const auto end = std::to_chars(digits, digits + sizeof digits, number).ptr; // shortest that reads back to the bit
        if (!text.empty()) text += ' ';
        text.append(digits, end);
    }
    return text;
}

std::vector<double> readNumbersText(const Ktx2& texture, const std::string& key, std::size_t count, const std::string& what)
{
    std::vector<double> numbers;
    const auto entry = texture.keys.find(key);
    if (entry != texture.keys.end()) {
        const char* at = entry->second.data();
        const char* const end = at + entry->second.size();
        while (at < end) {
            double number = 0.0;
            const auto [next, failed] = std::from_chars(at, end, number);
            if (failed != std::errc() || !(std::abs(number) <= double(std::numeric_limits<float>::max()))) break;
            numbers.push_back(number);
            at = next < end && *next == ' ' ? next + 1 : next;
        }
    }
    if (numbers.size() != count)
        throw Error("cannot read " + what + ": its key " + key + " does not hold " + std::to_string(count) + " numbers");
    return numbers;
}
}
