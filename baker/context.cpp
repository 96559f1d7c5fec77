#include "baker/context.hpp"
#include "engine/core/error.hpp"
#include <algorithm>

namespace afterglow
{
bool recalled(const Journal& journal, const Unit& unit, std::initializer_list<ByteSpan> result, RayCount& rays)
{
    const std::optional<Done> done = journal.recall(unit);
    std::size_t size = 0;
    for (const ByteSpan part : result) size += part.size();
    if (!done || done->bytes.size() != size) return false;
    auto from = done->bytes.begin();
    for (const ByteSpan part : result) {
        std::copy_n(from, part.size(), part.begin());
        from += std::ptrdiff_t(part.size());
    }
    rays = done->rays;
    return true;
}

static void keep(Journal& journal, const Unit& unit, std::initializer_list<ByteSpan> result, const RayCount& rays)
{
    std::vector<std::uint8_t> bytes;
    for (const ByteSpan part : result) bytes.insert(bytes.end(), part.begin(), part.end());
    journal.keep(unit, bytes, rays);
}

void readBack(const BakeContext& context, const Unit& unit, std::initializer_list<ByteSpan> result)
{
    RayCount counted;
    if (!recalled(*context.journal, unit, result, counted))
        throw Error(
            "the disk does not hold the light that waits there, as --max-memory or --light-layers say; free some space beside the output");
}

void doUnit(BakeContext& context, const Unit& unit, std::initializer_list<ByteSpan> result, std::uint64_t amount,
            const std::function<void(RayCount& rays)>& work)
{
    RayCount rays;
    const bool found = context.journal && recalled(*context.journal, unit, result, rays);
    if (!found) work(rays);
    if (!found && context.journal) keep(*context.journal, unit, result, rays);
    context.count(rays);
    if (found)
        context.progress.find(amount);
    else
        context.progress.advance(amount);
}
}
