// What is left of the noise of few rays, by their number, in a picture with penumbras of every width: the tables of the READMEs.
#include "tests/engine/effects/lit_share.hpp"

namespace afterglow
{
// Twelve blocks and six slanted boards under a lamp of 25 cm, one of 5 cm, and the sun: wide and narrow penumbras, and contact.
class DenoisedBlocks : public LitShare
{
protected:
    void SetUp() override
    {
        if (!gpu.device.rayQuery) GTEST_SKIP() << gpu.device.deviceName << " has no ray queries";
    }
    static constexpr uint kTruth = 64, kFrames = 16; // the truth: rays, of the mean of so many frames
    static constexpr uint kLots = 4;                 // frames that are judged
    const Camera camera = lookAt(vec3(0, 3.5f, 5), vec3(0, 0.2f, 0));

    void block(vec3 lower, vec3 upper)
    {
        const vec3 s = upper - lower, x(s.x, 0, 0), y(0, s.y, 0), z(0, 0, s.z);
        addQuad(scene, lower + y, z, x, grey());
        addQuad(scene, lower, y, x, grey());
        addQuad(scene, lower + z, x, y, grey());
        addQuad(scene, lower, z, y, grey());
        addQuad(scene, lower + x, y, z, grey());
    }
    void blocks()
    {
        floor(8.0f);
        for (int i = 0; i < 12; ++i) {
            const float turn = 2.4f * float(i), away = 0.5f + 0.25f * float(i), high = 0.2f + 0.12f * float(i);
            const vec3 middle(away * std::cos(turn), high, away * std::sin(turn)), half(0.2f, high, 0.2f);
            block(middle - half, middle + half);
        }
        for (int i = 0; i < 6; ++i) addQuad(scene, vec3(i - 3, 1.5f, 0.3f * float(i) - 3), vec3(0, 0, 1.5f), vec3(0.3f, 0.1f, 0), grey());
        size = {400, 225};
    }
    // Root of the mean square of how far frames lie from `truth`; shown(frame) draws one.
    template <typename Shown>
    double errorOf(Shown shown, const Image& truth)
    {
        double sum = 0;
        for (uint k = 0; k < kLots; ++k) {
            const Image image = shown(k);
            for (std::size_t i = 0; i < truth.pixels.size(); ++i) sum += std::pow(double(image.pixels[i] - truth.pixels[i]), 2);
        }
        return std::sqrt(sum / (double(truth.pixels.size()) * kLots));
    }
    template <typename Shown>
    static Image meanOf(Shown shown)
    {
        Image mean = shown(1000u);
        for (uint k = 1; k < kFrames; ++k) {
            const Image image = shown(1000u + k);
            for (std::size_t i = 0; i < mean.pixels.size(); ++i) mean.pixels[i] += image.pixels[i];
        }
        for (float& value : mean.pixels) value /= float(kFrames);
        return mean;
    }
};

TEST_F(DenoisedBlocks, slowShadowsByTheNumberOfRays)
{
    blocks();
    Light large = pointLight(vec3(-2, 4, 2), vec3(50.0f)), small = pointLight(vec3(3, 3, -1), vec3(50.0f)),
          sun = sunLight(vec3(1, -1.5f, 0.3f), vec3(3.0f));
    large.radius = 0.25f, small.radius = 0.05f, sun.sinAngle = std::sin(0.265f * kPi / 180.0f);
    for (const auto& [name, light] : {std::pair("lamp of 25 cm", large), std::pair("lamp of 5 cm", small), std::pair("sun", sun)}) {
        GpuScene uploaded = uploadScene(gpu, scene, placed(), {light}, lods);
        uploaded.rays = buildRays(gpu, scene, placed());
        const GpuLevel level(gpu, std::move(uploaded), uploadBaked(gpu, baked, {}));
        const auto shares = [&](uint rays, uint denoise) {
            return [&, rays, denoise](uint frame) {
                View view = makeView(camera, size);
                view.frame = frame;
                ShadowParameters parameters = defaultShadowParameters();
                parameters.rays = rays, parameters.denoise = denoise;
                Graph graph;
                const Texture traced = tracedShadows(graph, view, geometry(graph, view, level.scene, {}), level.scene, parameters);
                graph.output(traced);
                executor.run(graph, level.set);
                Image all = executor.download(traced), one(all.width, all.height, 1);
                for (std::size_t i = 0; i < one.pixels.size(); ++i) one.pixels[i] = all.pixels[4 * i];
                return one;
            };
        };
        const Image truth = meanOf(shares(kTruth, 0));
        for (const uint rays : {4u, 8u, 16u, 32u}) {
            const double raw = errorOf(shares(rays, 0), truth), filtered = errorOf(shares(rays, 1), truth);
            std::printf("%s, %u rays: RMSE %.4f, filtered %.4f\n", name, rays, raw, filtered);
            if (light.radius == large.radius) {
                EXPECT_LT(filtered, raw) << rays << " rays";
            } else if (rays <= defaultShadowParameters().rays) {                    // penumbras no wider than the filter
                EXPECT_LT(filtered, 1.05 * raw) << name << ", " << rays << " rays"; // a lot's worth
            }
        }
    }
}

TEST_F(DenoisedBlocks, slowContactByTheNumberOfRays)
{
    blocks();
    GpuScene uploaded = uploadScene(gpu, scene, placed(), {}, lods);
    uploaded.rays = buildRays(gpu, scene, placed());
    const GpuLevel level(gpu, std::move(uploaded), uploadBaked(gpu, baked, {}));
    const GpuVoxels none;
    const auto open = [&](uint rays, uint divisor, uint smooth, uint denoise) {
        return [&, rays, divisor, smooth, denoise](uint frame) {
            View view = makeView(camera, size);
            view.frame = frame;
            OcclusionParameters parameters = defaultOcclusionParameters();
            parameters.rays = rays, parameters.divisor = divisor, parameters.smooth_ = smooth, parameters.denoise = denoise;
            Graph graph;
            const GBuffer surfaces = geometry(graph, view, level.scene, {});
            const Texture seen = occlusion(graph, view, surfaces, {none, level.scene.rays}, OcclusionMethod::ray, parameters);
            graph.output(seen);
            executor.run(graph, level.set);
            return executor.download(seen);
        };
    };
    const Image truth = meanOf(open(kTruth, 1, 0, 0));
    for (const uint rays : {2u, 4u, 8u, 16u}) {
        const double averaged = errorOf(open(rays, 2, 1, 0), truth), filtered = errorOf(open(rays, 2, 1, 1), truth);
        std::printf("contact, %u rays: RMSE %.4f averaged, %.4f filtered\n", rays, averaged, filtered);
        if (rays < kFewestFiltered)
            EXPECT_EQ(filtered, averaged) << rays << " rays"; // of two pictures that are one
        else
            EXPECT_LT(filtered, averaged) << rays << " rays";
    }
}
}
