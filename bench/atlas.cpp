// The atlas beside xatlas, where the system's python has it: the same meshes on one page of 1024 texels at a padding of 2, in one run.
#include "baker/atlas.hpp"
#include "bench/bench.hpp"
#include "bench/child.hpp"
#include "bench/peer.hpp"
#include "engine/core/error.hpp"
#include "engine/core/file.hpp"
#include "shaders/constants.h"
#include <array>
#include <ctime>
#include <functional>
#include <nlohmann/json.hpp>

namespace afterglow
{
using nlohmann::json;

constexpr int kPage = 1024; // texels

// Reads what exportMeshes() wrote and answers with the row's numbers: texels over metres per object, as AtlasReport has them.
constexpr const char* kPeer = R"(
import json, sys, time
try:
    import numpy, xatlas
except ImportError as error:
    print(json.dumps({"missing": "python3 has no module " + error.name})); sys.exit()
folder, page = sys.argv[1], int(sys.argv[2])
counts = json.load(open(folder + "/counts.json"))
points = numpy.fromfile(folder + "/points", numpy.float32).reshape(-1, 3)
indices = numpy.fromfile(folder + "/indices", numpy.uint32).reshape(-1, 3)
meshes, p, i = [], 0, 0
for vertices, triangles in counts:
    meshes.append((points[p:p + vertices].copy(), indices[i:i + triangles].copy()))
    p, i = p + vertices, i + triangles
began = time.process_time()
atlas = xatlas.Atlas()
for mesh in meshes: atlas.add_mesh(*mesh)
pack = xatlas.PackOptions()
pack.padding, pack.resolution = 2, page
atlas.generate(xatlas.ChartOptions(), pack)
seconds = time.process_time() - began
surface = texels = stretch = 0.0
for k, (points, _) in enumerate(meshes):
    vertex, index, uv = atlas[k]
    at, on = points[vertex][index].astype(float), uv[index].astype(float) * [atlas.width, atlas.height]
    e, f, a, b = at[:, 1] - at[:, 0], at[:, 2] - at[:, 0], on[:, 1] - on[:, 0], on[:, 2] - on[:, 0]
    twice = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    area = numpy.linalg.norm(numpy.cross(e, f), axis=1) / 2
    keep = numpy.abs(twice) > 2e-9
    e, f, a, b, twice, area = (x[keep] for x in (e, f, a, b, twice, area))
    u, v = (e * b[:, 1:] - f * a[:, 1:]) / twice[:, None], (f * a[:, :1] - e * b[:, :1]) / twice[:, None]
    s, t = area.sum(), numpy.abs(twice).sum() / 2
    surface, texels = surface + s, texels + t
    stretch += t / s * ((u * u + v * v).sum(1) * area).sum() / 2 if s > 0 else 0
print(json.dumps({"charts": atlas.chart_count, "pages": atlas.atlas_count, "stretch": (stretch / surface) ** 0.5,
                  "utilisation": texels / (atlas.width * atlas.height * atlas.atlas_count), "cpu_seconds": seconds}))
)";

using At = std::function<vec3(float u, float v)>;

// n x m quads over the unit square, as an object of its own.
static void addGrid(Scene& scene, uint n, uint m, const At& at)
{
    Primitive primitive{uint(scene.vertices.size()), (n + 1) * (m + 1), uint(scene.indices.size()), 6 * n * m, 0};
    for (uint j = 0; j <= m; ++j)
        for (uint i = 0; i <= n; ++i) scene.vertices.push_back({.position = at(i == n ? 0.0f : float(i) / float(n), float(j) / float(m))});
    for (uint j = 0; j < m; ++j)
        for (uint i = 0; i < n; ++i) {
            const uint a = j * (n + 1) + i, c = a + n + 1;
            for (uint v : {a, a + 1, c + 1, a, c + 1, c}) scene.indices.push_back(v);
        }
    Object object;
    object.mesh = uint(scene.meshes.size());
    scene.meshes.push_back({"", {primitive}});
    scene.objects.push_back(object);
}

// An organic mesh: a sphere with bumps, 32 on its way round.
static Scene blob()
{
    Scene scene;
    addGrid(scene, 120, 72, [](float u, float v) {
        const float a = 2.0f * kPi * u, b = kPi * (0.02f + 0.96f * v);
        const vec3 d(std::sin(b) * std::cos(a), std::cos(b), -std::sin(b) * std::sin(a));
        return d * (1.0f + 0.1f * std::sin(5.0f * d.x) * std::sin(6.0f * d.y + 1.0f) * std::sin(5.0f * d.z) +
                    0.01f * std::sin(16.0f * a) * std::sin(b));
    });
    return scene;
}

// Turned parts: bolts of seven bands, between creases, and bent pipes.
static Scene parts()
{
    Scene scene;
    constexpr std::array<vec2, 8> profile{vec2(0.01f, 0.6f), vec2(0.18f, 0.6f), vec2(0.2f, 0.56f),   vec2(0.2f, 0.46f),
                                          vec2(0.1f, 0.44f), vec2(0.1f, -0.4f), vec2(0.07f, -0.44f), vec2(0.01f, -0.44f)};
    for (int k = 0; k < 24; ++k)
        addGrid(scene, 64, 7, [&](float u, float v) {
            const vec2 p = profile[std::size_t(std::round(7.0f * v))] * (1.0f + 0.05f * float(k));
            return vec3(p.x * std::cos(2.0f * kPi * u) + 2.0f * float(k), p.y, -p.x * std::sin(2.0f * kPi * u));
        });
    for (int k = 0; k < 8; ++k)
        addGrid(scene, 40, 48, [&](float u, float v) {
            const float a = 0.5f * kPi * v, b = 2.0f * kPi * u, r = 0.7f + (0.12f + 0.02f * float(k)) * std::cos(b);
            return vec3(r * std::cos(a), (0.12f + 0.02f * float(k)) * std::sin(b), -r * std::sin(a));
        });
    return scene;
}

static json ours(const Scene& level)
{
    Scene scene = level;
    const std::clock_t began = std::clock();
    const AtlasReport report = makeAtlas(scene, {.pageSize = kPage, .padding = 2, .pages = 1}).report;
    return {{"charts", report.charts},
            {"pages", report.pages},
            {"stretch", report.stretch},
            {"utilisation", report.utilisation},
            {"texels_per_metre", report.texelsPerMetre},
            {"cpu_seconds", double(std::clock() - began) / CLOCKS_PER_SEC}};
}

// Each object that gets a place, in metres of the world.
static void exportMeshes(const Scene& scene, const std::filesystem::path& folder)
{
    json counts = json::array();
    std::vector<vec3> points;
    std::vector<uint> indices;
    for (const Object& object : scene.objects) {
        if (!object.isStatic) continue;
        const std::size_t firstPoint = points.size(), firstIndex = indices.size();
        for (const Primitive& p : scene.meshes[object.mesh].primitives) {
            const uint shift = uint(points.size() - firstPoint);
            for (uint v = 0; v < p.vertexCount; ++v)
                points.emplace_back(object.toWorld * dvec4(dvec3(scene.vertices[p.firstVertex + v].position), 1.0));
            for (uint i = 0; i < p.indexCount / 3 * 3; ++i) indices.push_back(shift + scene.indices[p.firstIndex + i]);
        }
        counts.push_back({points.size() - firstPoint, (indices.size() - firstIndex) / 3});
    }
    const auto write = [&](const char* name, const auto& values) {
        writeText(folder / name, std::string(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values[0])));
    };
    write("points", points), write("indices", indices);
    writeText(folder / "counts.json", counts.dump());
    writeText(folder / "peer.py", kPeer);
}

static json peers(const Scene& scene, const std::filesystem::path& folder)
{
    exportMeshes(scene, folder);
    const std::string command =
        "python3 '" + (folder / "peer.py").string() + "' '" + folder.string() + "' " + std::to_string(kPage) + " 2>/dev/null";
    const json answer = json::parse(outputOf(command), nullptr, /* allow_exceptions= */ false);
    return answer.is_discarded() ? json{{"missing", "python3 does not run"}} : answer;
}

json benchAtlas(const BenchOptions& options, const std::filesystem::path& folder)
{
    return inChild([&] {
        json rows = json::array();
        const auto row = [&](const std::string& name, const Scene& scene) {
            std::uint64_t triangles = 0;
            for (const Object& object : scene.objects)
                for (const Primitive& p : scene.meshes[object.mesh].primitives) triangles += object.isStatic ? p.indexCount / 3 : 0;
            rows.push_back({{"what", name}, {"triangles", triangles}, {"ours", ours(scene)}, {"xatlas", peers(scene, folder)}});
        };
        row(options.level.filename().string(), loadLevel(options.level));
        row("turned parts", parts());
        if (!options.quick) row("a bumpy sphere", blob());
        return json{{"rows", rows}};
    });
}
}
