#include "baker/atlas_net.hpp"
#include <algorithm>

namespace afterglow
{
void number(Net& net, Sets& sets, const std::vector<dvec2>& corners, const std::vector<uint>& order)
{
    std::vector<uint> id(corners.size(), ~0u);
    std::vector<double> members;
    net.points.clear();
    for (uint c : order)
        if (uint& v = id[sets.root(c)]; v == ~0u) v = uint(members.size()), members.push_back(0.0);
    net.points.assign(members.size(), dvec2(0.0));
    net.vertex.resize(corners.size());
    for (uint c = 0; c < corners.size(); ++c) {
        const uint v = net.vertex[c] = id[sets.root(c)];
        net.points[v] += corners[c], members[v] += 1.0;
    }
    for (std::size_t v = 0; v < members.size(); ++v) net.points[v] /= members[v];
}

// Joins the corners of a net that share a point; its corners start at `shift`. Returns the first corner of each point.
static std::vector<uint> bind(const Net& net, uint shift, Sets& sets)
{
    std::vector<uint> first(net.points.size(), ~0u);
    for (uint c = 0; c < net.vertex.size(); ++c)
        if (first[net.vertex[c]] == ~0u)
            first[net.vertex[c]] = shift + c;
        else
            sets.join(shift + c, first[net.vertex[c]]);
    return first;
}

Net sewn(const Net& into, const Net& from, const std::vector<std::pair<uint, uint>>& ends)
{
    std::vector<dvec2> corners;
    for (uint v : into.vertex) corners.push_back(into.points[v]);
    const uint offset = uint(corners.size());
    for (uint v : from.vertex) corners.push_back(from.points[v]);
    Sets sets(corners.size());
    std::vector<uint> order = bind(into, 0, sets); // both nets', and last where they touch: neither fills the other in
    for (uint corner : bind(from, offset, sets)) order.push_back(corner);

    dvec2 to(0.0), middle(0.0), turn(0.0);
    for (const auto& [x, y] : ends) to += corners[x], middle += corners[offset + y];
    to /= double(ends.size()), middle /= double(ends.size());
    for (const auto& [x, y] : ends) {
        const dvec2 p = corners[offset + y] - middle, q = corners[x] - to;
        turn += dvec2(dot(p, q), p.x * q.y - p.y * q.x);
        sets.join(x, offset + y);
    }
    turn = length(turn) > 0.0 ? normalize(turn) : dvec2(1.0, 0.0);
    for (std::size_t c = offset; c < corners.size(); ++c) {
        const dvec2 p = corners[c] - middle;
        corners[c] = to + dvec2(turn.x * p.x - turn.y * p.y, turn.y * p.x + turn.x * p.y);
    }
    Net net;
    net.triangles = into.triangles;
    net.triangles.insert(net.triangles.end(), from.triangles.begin(), from.triangles.end());
    std::vector<bool> touches(corners.size());
    for (const auto& [x, y] : ends) touches[sets.root(x)] = true;
    std::stable_partition(order.begin(), order.end(), [&](uint c) { return !touches[sets.root(c)]; });
    number(net, sets, corners, order);
    return net;
}
}
