#include "baker/world_embree.hpp"
#include "engine/core/error.hpp"
#include "shaders/ray_scene.h"
#include <algorithm>

namespace afterglow
{
World::World(const Scene& scene, Content content) : scene_(scene), embree_(std::make_unique<Embree>())
{
    // Flatten the instances into world space
    std::vector<Triangle> filtered;
    std::vector<uint> filteredOrder;
    uint triangle = 0;
    const std::vector<Instance> all = instances(scene);
    for (uint number = 0; number < all.size(); number++) {
        const Instance& instance = all[number];
        if (content == Content::staticOnly && (instance.flags & kInstanceStatic) == 0) continue;
        placed_.push_back(instance);
        uint lowest = ~0u, highest = 0;
        for (uint i = 0; i < instance.indexCount; i++) {
            lowest = std::min(lowest, scene.indices[instance.firstIndex + i]);
            highest = std::max(highest, scene.indices[instance.firstIndex + i]);
        }
        if (instance.indexCount == 0) continue;
        uint base = uint(vertices_.size());
        for (uint i = lowest; i <= highest; i++) vertices_.push_back(placedVertex(instance, scene.vertices[instance.firstVertex + i]));
        const bool mayPass = mayLetThrough(scene.materials[instance.material]);
        auto& target = mayPass ? filtered : triangles_;
        auto& targetOrder = mayPass ? filteredOrder : order_;
        for (uint i = 0; i + 2 < instance.indexCount; i += 3) {
            const uint* corner = &scene.indices[instance.firstIndex + i];
            target.push_back({{corner[0] - lowest + base, corner[1] - lowest + base, corner[2] - lowest + base},
                              instance.material,
                              instance.object,
                              number});
            targetOrder.push_back(triangle++);
        }
    }
    opaque_ = triangles_.size();
    triangles_.insert(triangles_.end(), filtered.begin(), filtered.end());
    order_.insert(order_.end(), filteredOrder.begin(), filteredOrder.end());

    embree_->device = rtcNewDevice("threads=1,set_affinity=0");
    if (!embree_->device) throw Error("Embree could not start on this processor; a CPU with SSE2 is needed", Exit::noDevice);
    rtcSetDeviceMemoryMonitorFunction(embree_->device, Embree::count, embree_.get());
    embree_->scene = rtcNewScene(embree_->device);
    rtcSetSceneBuildQuality(embree_->scene, RTC_BUILD_QUALITY_MEDIUM);
    rtcSetSceneFlags(embree_->scene, RTC_SCENE_FLAG_ROBUST); // no light through the edges that closed rooms are made of
    embree_->positions.reserve(vertices_.size() * 3 + 4);
    for (const Vertex& v : vertices_) embree_->positions.insert(embree_->positions.end(), {v.position.x, v.position.y, v.position.z});
    embree_->positions.resize(vertices_.size() * 3 + 4);
    for (std::size_t i = 0; i < triangles_.size(); i++) {
        auto& indices = i < opaque_ ? embree_->opaque : embree_->filtered;
        indices.insert(indices.end(), triangles_[i].vertex, triangles_[i].vertex + 3);
    }
    if (!embree_->opaque.empty()) embree_->attach(embree_->opaque, this);
    if (!embree_->filtered.empty()) embree_->attach(embree_->filtered, this);
    rtcCommitScene(embree_->scene);
}

World::~World() = default;

std::uint64_t World::bytes() const
{
    const auto of = [](const auto& list) { return std::uint64_t(list.capacity()) * sizeof list[0]; };
    return of(placed_) + of(order_) + of(vertices_) + of(triangles_) + of(embree_->positions) + of(embree_->opaque) +
           of(embree_->filtered) + std::uint64_t(std::max(embree_->bytes.load(), std::int64_t(0)));
}
}
