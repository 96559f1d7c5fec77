#include "bench/cycles.hpp"
#include "baker/atlas.hpp"
#include "bench/peer.hpp"
#include "engine/core/file.hpp"
#include "engine/core/jobs.hpp"
#include "shaders/constants.h"
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace afterglow
{
using nlohmann::json;

// Reads what exportRoom() wrote, bakes irradiance twice by other seeds, and says in one line what it took and what the two differ by: the
// variance of each is half of that.
constexpr const char* kScript = R"(
import bpy, json, sys, time
import numpy as np
folder, size_x, size_y, threads, samples, bounces = sys.argv[sys.argv.index("--") + 1:]
corners = np.fromfile(folder + "/corners", np.float32).reshape(-1, 5)
paint = np.fromfile(folder + "/paint", np.int32)
room = json.load(open(folder + "/room.json"))

bpy.ops.wm.read_factory_settings(use_empty=True)
scene = bpy.context.scene
scene.render.engine, scene.cycles.device = "CYCLES", "CPU"
scene.render.threads_mode, scene.render.threads = "FIXED", int(threads)
cycles = scene.cycles
cycles.samples, cycles.use_adaptive_sampling, cycles.use_denoising, cycles.use_fast_gi = int(samples), False, False, False
cycles.max_bounces = cycles.diffuse_bounces = int(bounces)
cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
scene.world = bpy.data.worlds.new("dark")
scene.world.use_nodes = True
scene.world.node_tree.nodes["Background"].inputs["Strength"].default_value = 0

page = bpy.data.images.new("page", int(size_x), int(size_y), alpha=True, float_buffer=True)
mesh = bpy.data.meshes.new("room")
mesh.from_pydata([(x, -z, y) for x, y, z, u, v in corners], [], [(i, i + 1, i + 2) for i in range(0, len(corners), 3)])
mesh.update(calc_edges=True)
places = mesh.uv_layers.new(name="page")
places.data.foreach_set("uv", np.column_stack([corners[:, 3], 1 - corners[:, 4]]).ravel())
for color in room["colors"]:
    material = bpy.data.materials.new("paint")
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    surface, out, target = (tree.nodes.new(kind) for kind in ("ShaderNodeBsdfDiffuse", "ShaderNodeOutputMaterial", "ShaderNodeTexImage"))
    surface.inputs["Color"].default_value = (*color, 1)
    tree.links.new(surface.outputs[0], out.inputs[0])
    target.image = page
    tree.nodes.active = target
    mesh.materials.append(material)
mesh.polygons.foreach_set("material_index", paint)
thing = bpy.data.objects.new("room", mesh)
scene.collection.objects.link(thing)
lamp = bpy.data.lights.new("lamp", "AREA")
lamp.energy, lamp.shape, lamp.size = room["watts"], "SQUARE", room["edge"]
hung = bpy.data.objects.new("lamp", lamp)
hung.location = room["lamp"]
scene.collection.objects.link(hung)
thing.select_set(True)
bpy.context.view_layer.objects.active = thing

def bake(seed):
    cycles.seed = seed
    began, cpu = time.time(), time.process_time()
    bpy.ops.object.bake(type="DIFFUSE", pass_filter={"DIRECT", "INDIRECT"}, margin=0, use_clear=True, target="IMAGE_TEXTURES", save_mode="INTERNAL")
    spent = time.time() - began, time.process_time() - cpu
    texels = np.empty(int(size_x) * int(size_y) * 4, np.float32)
    page.pixels.foreach_get(texels)
    return texels.reshape(-1, 4).astype(float), spent

(first, spent), (second, _) = bake(1), bake(2)
both = (first[:, 3] > 0) & (second[:, 3] > 0)
a, b = first[both, :3], second[both, :3]
print("AFTERGLOW " + json.dumps({"version": bpy.app.version_string, "texels": int(both.sum()), "samples": int(samples), "seconds": spent[0],
    "cpu_seconds": spent[1], "error": float(np.sqrt(((a - b) ** 2).mean() / 2) / ((a.mean() + b.mean()) / 2))}))
)";

// Triangles as they lie in the room and on the page; those that shine are the lamp.
static void exportRoom(const Scene& scene, const Atlas& atlas, const std::filesystem::path& folder)
{
    std::vector<float> corners;
    std::vector<std::int32_t> paint;
    json room = {{"colors", json::array()}};
    for (const Material& material : scene.materials)
        room["colors"].push_back({material.baseColor.x, material.baseColor.y, material.baseColor.z});
    for (std::size_t o = 0; o < scene.objects.size(); ++o) {
        const LightmapPlace& place = atlas.places[o];
        for (const Primitive& p : scene.meshes[scene.objects[o].mesh].primitives) {
            const Material& material = scene.materials[p.material];
            const Vertex* vertices = &scene.vertices[p.firstVertex];
            if (const float radiance = material.emission.x; radiance > 0.0f) {
                const vec3 a = vertices[0].position, b = vertices[2].position, middle = 0.5f * (a + b);
                const float edge = distance(a, b) / std::sqrt(2.0f);
                room["lamp"] = {middle.x, -middle.z, middle.y}, room["edge"] = edge, room["watts"] = radiance * kPi * edge * edge;
                continue;
            }
            for (uint i = 0; i < p.indexCount; ++i) {
                const Vertex& v = vertices[scene.indices[p.firstIndex + i]];
                const vec2 uv = v.uv1 * place.scale + place.offset;
                corners.insert(corners.end(), {v.position.x, v.position.y, v.position.z, uv.x, uv.y});
            }
            paint.insert(paint.end(), p.indexCount / 3, std::int32_t(p.material));
        }
    }
    writeFile(folder / "corners", corners.data(), corners.size() * sizeof corners[0]);
    writeFile(folder / "paint", paint.data(), paint.size() * sizeof paint[0]);
    writeText(folder / "room.json", room.dump());
    writeText(folder / "cycles.py", kScript);
}

json benchCycles(const Scene& scene, float texelsPerMetre, const BenchOptions& options, const std::filesystem::path& folder)
{
    const int samples = options.quick ? 16 : 64;
    Scene laidOut = scene;
    const Atlas atlas = makeAtlas(laidOut, {.texelsPerMetre = texelsPerMetre});
    exportRoom(laidOut, atlas, folder);
    const std::string said =
        outputOf(fmt::format("blender -b --factory-startup -t {} --python-exit-code 1 -P '{}' -- '{}' {} {} {} {} {} 2>/dev/null",
                             threadCount(options.threads), (folder / "cycles.py").string(), folder.string(), atlas.pageSizes[0].x,
                             atlas.pageSizes[0].y, threadCount(options.threads), samples, kRoomBounces));
    if (said.empty()) return {{"missing", "there is no blender; apt installs it"}};
    const std::string mark = "AFTERGLOW ";
    const std::size_t at = said.find(mark);
    const json answer =
        json::parse(at == std::string::npos ? "" : said.substr(at + mark.size(), said.find('\n', at) - at - mark.size()), nullptr,
                    /* allow_exceptions= */ false);
    return answer.is_object() && answer.contains("error") ? answer
                                                          : json{{"missing", "blender did not bake: " + said.substr(0, said.find('\n'))}};
}
}
