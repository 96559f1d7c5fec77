#include "baker/reach.hpp"
#include "engine/core/jobs.hpp"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace afterglow
{
static Unit leftUnit(const BakeContext& context) { return {Job::layers, 0, 0, context.layer.family}; }

Former formerOf(const BakeContext& context, std::size_t tiles)
{
    Former former{0, std::vector<LeftTile>(tiles)};
    RayCount rays;
    const bool found =
        context.earlier && context.layer.number != 0 &&
        recalled(*context.earlier, leftUnit(context), {bytesOf(std::span(&former.layer, 1)), bytesOf(std::span(former.tiles))}, rays);
    return found ? former : Former{};
}

void leave(BakeContext& context, const std::vector<Tile>& tiles)
{
    if (context.layer.number == 0) return;
    Former former{context.layer.number, {}};
    for (const Tile& tile : tiles) former.tiles.push_back({tile.layer, tile.noise.samples, tile.squares, tile.told});
    doUnit(context, leftUnit(context), {bytesOf(std::span(&former.layer, 1)), bytesOf(std::span(former.tiles))}, 0, [](RayCount&) {});
}

TileChange changeOf(const std::vector<TexelLight>& before, const std::vector<TexelLight>& now)
{
    TileChange change;
    for (std::size_t t = 0; t < now.size(); t++) {
        const TexelLight &was = before[t], &is = now[t];
        const bool same = was.count[0] == is.count[0] && was.count[1] == is.count[1] && was.points == is.points &&
                          was.position == is.position && was.normal == is.normal;
        if (!same) return {};
        if (!is.valid()) continue;
        const dvec3 seen = (is.half[0] - was.half[0]) / double(std::max(is.count[0], 1)),
                    told = (is.half[1] - was.half[1]) / double(std::max(is.count[1], 1));
        change.seen += grey(seen * seen);
        change.told += told * told;
    }
    change.kept = true;
    return change;
}

void keepLeastChanged(std::vector<TileChange>& tiles)
{
    double room = 0.0;
    for (const TileChange& tile : tiles) room += kGivenUp * tile.error;
    std::vector<std::size_t> order(tiles.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return tiles[a].seen < tiles[b].seen; });
    for (std::size_t i : order) {
        TileChange& tile = tiles[i];
        tile.kept = tile.kept && tile.seen <= room && tile.seen <= tile.error; // no tile by more than its noise: its edge would show
        if (tile.kept) room -= tile.seen;
    }
}

Aim aimOf(const BakeContext& context, const std::vector<Tile>& tiles, double target)
{
    ErrorSum all, own;
    for (const Tile& tile : tiles) {
        all.add(tile);
        if (tile.layer == context.layer.number) own.add(tile);
    }
    if (!context.layer.asksForMoves() || !(all.total > 0.0)) return {all.relative(), target, {}};
    const double most = target * target * all.total * all.total / all.texels, // squares
        kept = all.squares - own.squares, left = most - kept - std::max(all.told, kRoom * most);
    if (left >= 0.5 * most * own.texels / all.texels) return {std::sqrt(own.squares), std::sqrt(left), context.layer.number};
    return {std::sqrt(all.squares + all.told), std::sqrt((1.0 - kRoom) * most), {}};
}

using Texels = std::vector<TexelLight>;

// So many samples of a former tile.
static bool recalled(const BakeContext& context, const LeftTile& left, std::size_t number, int samples, Texels& light)
{
    RayCount rays;
    return recalled(*context.earlier, unitOf(number, samples, left.layer), {bytesOf(std::span(light))}, rays);
}

static TileChange changeOf(const BakeContext& context, const LeftTile& left, std::size_t number, Tile& tile)
{
    Texels before(kTileTexels), now = takeLight(context, number, tile);
    TileChange change;
    if (left.samples > tile.noise.samples && recalled(context, left, number, tile.noise.samples, before)) change = changeOf(before, now);
    change.error = left.error;
    giveLight(context, tile, std::move(now));
    return change;
}

// The tile as it was, and its first paths, into this bake's journal.
static void takeOver(BakeContext& context, const LeftTile& left, std::size_t number, dvec3 told, Tile& tile)
{
    Texels first(kTileTexels), light(kTileTexels);
    const int samples = int(left.samples), few = std::min(samples, kPilotSamples);
    if (!recalled(context, left, number, samples, light)) return;
    const auto copy = [&](int of, Texels& texels) {
        doUnit(context, unitOf(number, of, left.layer), {bytesOf(std::span(texels))}, 0, [](RayCount&) {});
    };
    if (few < samples && recalled(context, left, number, few, first)) copy(few, first);
    copy(samples, light);
    context.progress.find(std::uint64_t(std::max(samples - tile.noise.samples, 0)) * kTileTexels);
    tile.layer = left.layer;
    tile.told = told;
    tile.kept = true;
    tile.noise.samples = samples;
    giveLight(context, tile, std::move(light));
}

void takeOver(BakeContext& context, const Former& former, std::vector<Tile>& tiles)
{
    if (former.layer == 0) return;
    const bool isSame = former.layer == context.layer.number;
    std::vector<TileChange> changes(tiles.size());
    parallelFor(tiles.size(), context.threads, [&](std::size_t i) {
        changes[i] = isSame ? TileChange{.told = former.tiles[i].told, .kept = true} : changeOf(context, former.tiles[i], i, tiles[i]);
    });
    if (!isSame) keepLeastChanged(changes);
    parallelFor(tiles.size(), context.threads, [&](std::size_t i) {
        if (changes[i].kept) takeOver(context, former.tiles[i], i, changes[i].told, tiles[i]);
    });
}
}
