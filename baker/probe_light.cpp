#include "baker/probe_light.hpp"
#include "baker/sphere_sums.hpp"

namespace afterglow
{
static const std::array<vec3, 512> kAxis = spiral<512>(); // tried for the lobe
static constexpr int kBatch = 32;                         // paths that are summed in floats, and that tell how paths vary
static constexpr float kGrowth = 4.0f;                    // times as many paths, at most, before their noise is asked again

// Sums of one point, of batches: a float that sums all paths one by one loses digits.
struct Total {
    Sh9 radiance[2] = {shZero(), shZero()}; // of each half
    std::array<vec3, kSphereNormals> irradiance{};
    double squares[2] = {0.0, 0.0}; // of each half: of the batches' irradiance
    int batches = 0;                // of each half

    void add(int half, const SphereSums& sums)
    {
        for (int c = 0; c < 9; c++) radiance[half].c[c] += sums.radiance.c[c];
        for (std::size_t i = 0; i < kSphereNormals; i++)
            irradiance[i] += vec3(sums.irradiance[0][i], sums.irradiance[1][i], sums.irradiance[2][i]);
        squares[half] += double(squareOf(shConvolveCosine(sums.radiance)));
        batches += half;
    }

    static float squareOf(const Sh9& sh)
    {
        float square = 0.0f;
        for (int c = 0; c < 9; c++) square += dot(sh.c[c], sh.c[c]);
        return square;
    }

    // Relative, as ProbeLight::difference(): what halves would differ by if their paths alone were to blame, not the light that both look up.
    float noise() const
    {
        double varied = 0.0, all = 0.0;
        for (int half = 0; half < 2; half++) {
            const Sh9 sum = shConvolveCosine(radiance[half]);
            varied += squares[half] - double(squareOf(sum)) / batches;
            all += double(sum.c[0].x + sum.c[0].y + sum.c[0].z);
        }
        varied = std::max(varied, 0.0) * batches / std::max(batches - 1, 1);
        return all > 0.0 ? float(std::sqrt(3.0 * varied) / all) : 0.0f;
    }
};

// One path, and the lights straight from where they are.
static void sampleOnce(Tracer here, Tracer beyond, vec3 position, Sampler random, SphereSums& sums)
{
    const Ray ray{position, sampleUniformSphere(next2(random)), kRayFar};
    const Hit hit = closestHit(beyond, ray);
    sums.add(ray.direction, radianceAlong(here, beyond, ray, hit, uniformSpherePdf(), random) / uniformSpherePdf());
    for (uint category = 0; category < kDirectCategories; category++) {
        if (!hasDirect(here, category)) continue;
        const float choice = next1(random);
        const LightSample light = sampleDirect(here, category, position, choice, next2(random));
        if (!(light.pdf > 0.0f)) continue;
        const float weight = light.delta == 0u ? powerHeuristic(light.pdf, uniformSpherePdf()) / light.pdf : 1.0f;
        sums.add(light.direction, arriving(here, position, position, light, weight * light.radiance));
    }
}

// The one clamped cosine that explains most of what the bands leave: tried over the sphere, then ever nearer about the best.
static void fitLobe(const std::array<vec3, kSphereNormals>& left, ProbeLight& light)
{
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
        const float gain = dot(along, along) / square;
        if (gain > most) most = gain, light.toward = axis, light.lobe = along / square;
    };
    for (vec3 axis : kAxis) tryAxis(axis);
    if (!(most > 0.0f)) return;
    for (float step : {0.08f, 0.04f, 0.02f, 0.01f}) { // radians; the first tries lie 0.11 apart
        const Frame frame = makeFrame(light.toward);
        for (int i = 0; i < 8; i++)
            tryAxis(
                normalize(toWorld(frame, vec3(step * std::cos(kPi * 0.25f * float(i)), step * std::sin(kPi * 0.25f * float(i)), 1.0f))));
    }
}

static ProbeLight bandsOf(const Total& total, int each)
{
    ProbeLight light;
    light.paths = 2 * each;
    const float share = 1.0f / float(each);
    for (int half = 0; half < 2; half++) light.half[half] = shScaleBands(shConvolveCosine(total.radiance[half]), share, share, share);
    return light;
}

// The rest, once the paths are enough.
static ProbeLight whole(ProbeLight light, const Total& total, int each)
{
    const float share = 1.0f / float(each);
    const Probe bands = light.probe();
    std::array<vec3, kSphereNormals> left;
    for (std::size_t i = 0; i < kSphereNormals; i++)
        left[i] = 0.5f * share * total.irradiance[i] - probeIrradiance(bands, kSphereNormal[i]);
    fitLobe(left, light);
    return light;
}

// Paths of each half that leave so much noise, by what those so far say.
static int pathsFor(float noise, const Total& total, int each, int batch, int most)
{
    const float off = total.noise();
    if (each >= most || (total.batches > 1 && off <= noise)) return each;
    const float times = total.batches > 1 && noise > 0.0f ? min(off / noise * (off / noise), kGrowth) : kGrowth;
    return min(int(std::ceil(times * float(each) / float(batch))) * batch, most);
}

ProbeLight probeLight(BakeContext& context, vec3 position, uint seed, const ProbePaths& paths, RayCount& rays)
{
    const Tracer here{&context.transport, &context.direct, &rays};
    Tracer beyond{&context.transport, &context.transport.lights, &rays};
    beyond.cache = context.cache.get();
    int done = 0, each = max(paths.samples / 2, 1);
    const int batch = clamp(each / 2, 1, kBatch);
    Total total;
    while (done < each) {
        for (int half = 0; half < 2; half++) {
            beyond.half = half;
            for (int first = done; first < each; first += batch) {
                SphereSums sums;
                for (int s = first; s < min(first + batch, each); s++)
                    sampleOnce(here, beyond, position, makeSampler(hash2(seed, uint(half)), uint(s)), sums);
                total.add(half, sums);
            }
        }
        done = each;
        each = pathsFor(paths.noise, total, done, batch, paths.most / 2);
    }
    return whole(bandsOf(total, done), total, done);
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

float ProbeLight::difference() const
{
    float square = 0.0f, all = 0.0f;
    for (int c = 0; c < 9; c++) square += dot(half[0].c[c] - half[1].c[c], half[0].c[c] - half[1].c[c]);
    for (int channel = 0; channel < 3; channel++) all += half[0].c[0][channel] + half[1].c[0][channel];
    return all > 0.0f ? std::sqrt(3.0f * square) / all : 0.0f;
}
}
