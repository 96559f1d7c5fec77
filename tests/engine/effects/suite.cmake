suite(effects_test
    SOURCES denoise_test.cpp denoised_blocks_test.cpp local_fit_test.cpp view_test.cpp geometry_test.cpp lods_test.cpp shadow_test.cpp shadow_rays_test.cpp shadow_rays_soft_test.cpp occlusion_test.cpp occlusion_light_test.cpp occlusion_laws_test.cpp occlusion_rays_test.cpp
            lighting_test.cpp lighting_probes_test.cpp toon_test.cpp reflection_test.cpp reflection_rays_test.cpp march_test.cpp planar_test.cpp portal_test.cpp probe_view_test.cpp fog_test.cpp
            fog_lights_test.cpp outline_test.cpp antialias_test.cpp upscale_test.cpp bloom_test.cpp display_test.cpp truth_test.cpp
    USES effects)
