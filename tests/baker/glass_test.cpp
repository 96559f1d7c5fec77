// Bodies of clear glass on the way of a path: in the air, of the index of what is around them, one within another.
#include "asked.hpp"

namespace afterglow::test
{
namespace
{
// `ior`: of what is within over what is around.
Material glass(float ior)
{
    Material m = matte(1.0f);
    m.flags = 0;
    m.transmission = 1.0f;
    m.roughness = 0.0f;
    m.ior = ior;
    m.specular = 1.0f;
    m.specularColor = vec3(1.0f);
    m.thickness = 1.0f; // it is a body
    m.attenuationColor = vec3(1.0f);
    m.attenuationDistance = 1.0f;
    return m;
}
}

// H43. Before a sky of many colours no pixel of it shows.
TEST(Glass, OfTheIndexOfAirIsInvisible)
{
    Scene scene;
    scene.sky.radiance = vec3(1.0f);
    scene.sky.image = Image(32, 16, 3);
    Random random;
    for (float& value : scene.sky.image.pixels) value = 0.5f + 0.1f * random.next();
    TruthOptions options;
    options.samples = 4;
    const Image without = lookingUp(scene, options, 0.3f, 1.0f);
    add(scene, moved(box(vec3(1.0f)), vec3(0.0f, 3.0f, 0.0f)), glass(1.0f));
    const Image with = lookingUp(scene, options, 0.3f, 1.0f);
    for (std::size_t i = 0; i < with.pixels.size(); i++) EXPECT_NEAR(with.pixels[i], without.pixels[i], 1e-6f) << i;
}

// H43. Within a slab, which by all its inner reflections lets 2 n / (n^2 + 1) pass at right angles, a cube of the slab's index changes
// nothing.
TEST(Glass, OfTheIndexOfTheGlassAroundItIsInvisible)
{
    Scene scene;
    scene.sky.radiance = vec3(1.0f);
    scene.sky.image = Image(8, 16, 3);
    for (int y = 0; y < 8; y++) // the upper half
        for (int x = 0; x < 8; x++)
            for (int c = 0; c < 3; c++) scene.sky.image.at(x, y)[c] = 1.0f;
    add(scene, moved(box(vec3(8.0f, 3.0f, 8.0f)), vec3(0.0f, 2.0f, 0.0f)), glass(1.5f));
    add(scene, moved(box(vec3(1.0f)), vec3(0.0f, 2.0f, 0.0f)), glass(1.0f));
    const Mean found = redOf(lookingUp(scene, {}));
    EXPECT_NEAR(found.value(), 3.0 / 3.25, 4.0 * found.error() + 1e-4);
}

// H43. Under a white sky all is white: at no angle, the critical ones among them, is light lost or made. A cube in a cube, askew: rays meet
// the faces at all angles, and normals are those of the faces.
TEST(Glass, WithinAnotherNeitherTakesNorMakesLight)
{
    Scene scene;
    scene.sky.radiance = vec3(1.0f);
    add(scene, moved(box(vec3(2.0f)), vec3(0.0f, 3.0f, 0.0f)), glass(1.33f));
    const mat3 askew(vec3(0.48f, 0.64f, -0.6f), vec3(-0.8f, 0.6f, 0.0f), vec3(0.36f, 0.48f, 0.8f));
    Shape inner = box(vec3(1.0f));
    for (vec3& p : inner.positions) p = askew * p;
    add(scene, moved(inner, vec3(0.0f, 3.0f, 0.0f)), glass(1.5f));
    TruthOptions options;
    options.samples = 256;
    const Image image = lookingUp(scene, options, 0.0f, 0.8f);
    const Mean found = redOf(image);
    for (float value : image.pixels) EXPECT_TRUE(std::isfinite(value));
    EXPECT_NEAR(found.value(), 1.0, 4.0 * found.error() + 1e-4);
    EXPECT_LT(found.error(), 5e-3); // or it says nothing
}

// H95. Under a slab of glass a point of light leaves nothing, by no path that is sampled (the shadow ray meets the glass). A sphere of a
// little size is met by chance: about I (1 - F) / (1 + F) / d^2 with F = 0.04 of a slab at right angles, which lifts the floor by
// t (1 - 1 / n); at 9 degrees off, where this one ends, that is right to 1 %.
TEST(Glass, HidesALampWithoutASize)
{
    for (const float radius : {0.0f, 0.3f}) {
        Scene scene;
        add(scene, plate(vec3(0.0f), 5.0f), matte(0.0f));
        add(scene, moved(box(vec3(8.0f, 0.3f, 8.0f)), vec3(0.0f, 0.5f, 0.0f)), glass(1.5f));
        scene.lights = {pointLight(vec3(0.0f, 2.0f, 0.0f), radius)};
        const PointIrradiance found = irradianceAt(scene, vec3(0.0f), vec3(0, 1, 0), 1 << 17);
        const double height = 2.0 - 0.3 * (1.0 - 1.0 / 1.5), truth = radius > 0.0f ? 0.96 / 1.04 / (height * height) : 0.0;
        EXPECT_NEAR(double(found.value[0].x), truth, 4.0 * double(found.error[0].x) + 0.01 * truth) << radius;
    }
}
}
