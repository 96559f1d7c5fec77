#include "engine/baked/probe_tables.hpp"

namespace afterglow
{
ProbeTables probeTables(const std::vector<ProbeVolume>& volumes)
{
    ProbeTables tables;
    for (const ProbeVolume& volume : volumes) {
        ProbeBox box;
        box.toWorld = mat4x3(volume.toWorld);
        box.toUnit = mat4x3(inverse(volume.toWorld));
        box.count = volume.count;
        box.first = uint(tables.probes.size());
        tables.boxes.push_back(box);
        for (std::size_t i = 0; i < volume.irradiance.size(); ++i) tables.probes.push_back({volume.irradiance[i], volume.validity[i]});
    }
    return tables;
}
}
