#include "baker/probe_light.hpp"

namespace afterglow
{
static constexpr int kBatch = 32; // paths, at most

// Axes that are tried for the lobe, those of a half sphere, for what is left has no sense; and what a lobe about each says to a normal.
static constexpr std::size_t kAxes = 256;
struct Tries {
    std::array<vec3, 2 * kAxes> axis = spiral<2 * kAxes>();
    float remainder[kSphereNormals][kAxes], square[kAxes] = {};
    Tries()
    {
        for (std::size_t i = 0; i < kSphereNormals; i++)
            for (std::size_t a = 0; a < kAxes; a++) {
                remainder[i][a] = cosineRemainder(dot(kSphereNormal[i], axis[a]));
                square[a] += remainder[i][a] * remainder[i][a];
            }
    }
};

static const double kMean = double(shBasis(0, vec3(0.0f))); // of a function by its first coefficient, over the sphere

// Mean over the sphere and the channels.
static double meanSquareOf(const Sh9& sh)
{
    double square = 0.0;
    for (int c = 0; c < 9; c++) square += dot(dvec3(sh.c[c]), dvec3(sh.c[c]));
    return kMean * kMean / 3.0 * square;
}

ProbeSums noPaths(uint seed, int paths)
{
    const int each = max((paths + 1) / 2, 1), batches = each < 2 ? 1 : max((each + kBatch - 1) / kBatch, 2);
    return {.seed = seed, .batch = (each + batches - 1) / batches};
}

static void addBatch(ProbeSums& sums, int half, const SphereSums& batch)
{
    for (int c = 0; c < 9; c++) sums.radiance[half].c[c] += batch.radiance.c[c];
    for (std::size_t i = 0; i < kSphereNormals; i++)
        sums.irradiance[i] += vec3(batch.irradiance[0][i], batch.irradiance[1][i], batch.irradiance[2][i]);
    sums.squares[half] += meanSquareOf(shConvolveCosine(batch.radiance));
}

double ProbeSums::variance() const
{
    if (batches < 2) return 0.0;
    double varied = 0.0;
    for (int half = 0; half < 2; half++) varied += squares[half] - meanSquareOf(shConvolveCosine(radiance[half])) / batches;
    return std::max(varied, 0.0) * batches / (batches - 1) / (double(paths()) * paths());
}

// One path, and the lights straight from where they are.
static void sampleOnce(Tracer here, Tracer beyond, vec3 position, Sampler random, SphereSums& sums)
{
    const Ray ray{position, sampleUniformSphere(next2(random)), kRayFar};
    const Hit hit = closestHit(beyond, ray);
    bool whole = true;
    const auto add = [&](vec3 direction, vec3 light) { isFinite(light) ? sums.add(direction, light) : void(whole = false); };
    add(ray.direction, radianceAlong(here, beyond, ray, hit, uniformSpherePdf(), random) / uniformSpherePdf());
    for (uint category = 0; category < kDirectCategories; category++) {
        if (!hasDirect(here, category)) continue;
        const float choice = next1(random);
        const LightSample light = sampleDirect(here, category, position, choice, next2(random));
        if (!(light.pdf > 0.0f)) continue;
        const float weight = light.delta == 0u ? powerHeuristic(light.pdf, uniformSpherePdf()) / light.pdf : 1.0f;
        add(light.direction, arriving(here, position, position, light, weight * light.radiance));
    }
    here.rays->notFinite += whole ? 0u : 1u;
}

// What of it a lobe about an axis holds, by its sums with what is left.
static float gainOf(vec3 along, float square) { return dot(along, along) / square; }

static std::size_t bestTry(const Tries& tries, const std::array<vec3, kSphereNormals>& left)
{
    float along[3][kAxes] = {};
    for (std::size_t i = 0; i < kSphereNormals; i++)
        for (int c = 0; c < 3; c++)
            for (std::size_t a = 0; a < kAxes; a++) along[c][a] += tries.remainder[i][a] * left[i][c];
    std::size_t best = 0;
    float most = 0.0f;
    for (std::size_t a = 0; a < kAxes; a++)
        if (const float gain = gainOf(max(vec3(along[0][a], along[1][a], along[2][a]), vec3(0.0f)), tries.square[a]); gain > most)
            most = gain, best = a;
    return best;
}

// The one clamped cosine that explains most of what the bands leave: tried over the sphere, then ever nearer about the best.
static void fitLobe(const std::array<vec3, kSphereNormals>& left, ProbeLight& light)
{
    static const Tries tries;
    float most = 0.0f;
    const auto tryAxis = [&](vec3 axis) {
        vec3 along(0.0f);
        float square = 0.0f;
        for (std::size_t i = 0; i < kSphereNormals; i++) {
            const float r = cosineRemainder(dot(kSphereNormal[i], axis));
            along += r * left[i];
            square += r * r;
        }
        along = max(along, vec3(0.0f));
        if (const float gain = gainOf(along, square); gain > most) most = gain, light.toward = axis, light.lobe = along / square;
    };
    tryAxis(tries.axis[bestTry(tries, left)]);
    if (!(most > 0.0f)) return;
    for (float step : {0.08f, 0.04f, 0.02f, 0.01f}) { // radians; the first tries lie 0.11 apart
        const Frame frame = makeFrame(light.toward);
        for (int i = 0; i < 8; i++)
            tryAxis(
                normalize(toWorld(frame, vec3(step * std::cos(kPi * 0.25f * float(i)), step * std::sin(kPi * 0.25f * float(i)), 1.0f))));
    }
}

void tracePaths(BakeContext& context, vec3 position, int paths, RayCount& rays, ProbeSums& sums)
{
    const Tracer here{&context.transport, &context.direct, &rays};
    Tracer beyond{&context.transport, &context.transport.lights, &rays};
    beyond.cache = context.cache.get();
    for (; sums.paths() < paths; sums.batches++)
        for (int half = 0; half < 2; half++) {
            beyond.half = half;
            SphereSums batch;
            for (int s = sums.batches * sums.batch; s < (sums.batches + 1) * sums.batch; s++)
                sampleOnce(here, beyond, position, makeSampler(hash2(sums.seed, uint(half)), uint(s)), batch);
            addBatch(sums, half, batch);
        }
}

ProbeLight lightOf(const ProbeSums& sums)
{
    ProbeLight light;
    const float share = 2.0f / float(max(sums.paths(), 1));
    for (int half = 0; half < 2; half++) light.half[half] = shScaleBands(shConvolveCosine(sums.radiance[half]), share, share, share);
    const Probe bands = light.probe();
    std::array<vec3, kSphereNormals> left;
    for (std::size_t i = 0; i < kSphereNormals; i++) left[i] = 0.5f * share * sums.irradiance[i] - probeIrradiance(bands, kSphereNormal[i]);
    fitLobe(left, light);
    return light;
}

Probe ProbeLight::probe() const
{
    Probe whole{shZero(), lobe, toward};
    for (int c = 0; c < 9; c++) whole.irradiance.c[c] = 0.5f * (half[0].c[c] + half[1].c[c]);
    return whole;
}

void ProbeLight::keep(int order)
{
    if (order > 1) return;
    for (Sh9& sh : half) sh = shScaleBands(sh, 1.0f, 1.0f, 0.0f);
    lobe = toward = vec3(0.0f);
}

double ProbeLight::light() const
{
    double all = 0.0;
    for (const Sh9& sh : half) all += 0.5 * double(sh.c[0].x + sh.c[0].y + sh.c[0].z);
    return kMean / 3.0 * all;
}

double ProbeLight::variance() const
{
    Sh9 between;
    for (int c = 0; c < 9; c++) between.c[c] = 0.5f * (half[0].c[c] - half[1].c[c]);
    return meanSquareOf(between);
}
}
