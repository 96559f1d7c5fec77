"""The gallery's materials by name, each with its pictures: `Materials(level).gold` is an index for Level.place."""
import pictures


class Materials:
    def __init__(self, level):
        texture, material = level.texture, level.material
        plaster = texture("plaster_normals", pictures.plaster_normals())
        limestone = texture("limestone", pictures.limestone())
        walnut = texture("walnut", pictures.walnut())

        # The room
        self.floor = material("oak_floor", roughness=0.38, picture=texture("oak_floor", pictures.oak_floor()),
                              normal=texture("oak_floor_normals", pictures.oak_floor_normals()))
        self.plaster = material("plaster", (0.80, 0.78, 0.74), roughness=0.9, normal=plaster, normal_scale=0.6)
        self.ceiling = material("ceiling", (0.82, 0.81, 0.78), roughness=0.95)
        self.slate = material("slate_blue_wall", (0.25, 0.31, 0.39), roughness=0.8, normal=plaster, normal_scale=0.6)
        self.white = material("white_lacquer", (0.78, 0.77, 0.74), roughness=0.35)
        self.walnut = material("walnut", roughness=0.45, picture=walnut)
        self.bronze_frame = material("window_bronze", (0.10, 0.085, 0.07), metallic=0.6, roughness=0.5)
        self.limestone = material("limestone", roughness=0.7, picture=limestone)
        self.rug = material("rug", roughness=1.0, picture=texture("rug", pictures.rug(), clamp=True), lambert=True)
        self.leather = material("leather", (0.27, 0.10, 0.055), roughness=0.5)
        self.rope = material("velvet_rope", (0.28, 0.02, 0.035), roughness=0.9)
        self.black = material("black_steel", (0.025, 0.025, 0.028), metallic=0.0, roughness=0.4)
        self.mirror = material("mirror", (0.95, 0.95, 0.95), metallic=1.0, roughness=0.0)

        # The exhibits
        self.gold = material("gold", (1.0, 0.72, 0.30), metallic=1.0, roughness=0.20)
        self.copper = material("copper", (0.93, 0.55, 0.40), metallic=1.0, roughness=0.32)
        self.bronze = material("bronze", (0.50, 0.34, 0.18), metallic=1.0, roughness=0.42)
        self.steel = material("brushed_steel", (0.60, 0.60, 0.61), metallic=1.0, roughness=0.28)
        self.brass = material("brass", (0.87, 0.68, 0.35), metallic=1.0, roughness=0.22)
        self.marble = material("marble", roughness=0.30, picture=texture("marble", pictures.marble()))
        self.porcelain = material("porcelain", roughness=0.12, picture=texture("glaze", pictures.glaze()))
        self.celadon = material("celadon", (0.30, 0.50, 0.40), roughness=0.10)
        self.terracotta = material("terracotta", (0.50, 0.20, 0.11), roughness=0.85, ag_sigma_deg=20.0)
        self.obsidian = material("obsidian", (0.012, 0.012, 0.016), roughness=0.06)
        self.amethyst = material("amethyst", (0.30, 0.10, 0.42), roughness=0.06)
        self.leaf = material("leaf", roughness=0.55, picture=texture("leaf", pictures.leaf(), clamp=True), mask=0.5, double_sided=True)
        self.stem = material("stem", (0.16, 0.20, 0.07), roughness=0.8)
        self.hedge = material("hedge", roughness=1.0, picture=texture("hedge", pictures.hedge()), lambert=True)
        self.roughness_row = [material(f"row_{k}", (0.86, 0.87, 0.88), metallic=1.0, roughness=r) for k,
                              r in enumerate((0.05, 0.15, 0.3, 0.5, 0.8))]
        self.paints = [material(f"mobile_{name}", color, roughness=0.4, double_sided=True) for name, color in
                       (("red", (0.62, 0.06, 0.04)), ("black", (0.03, 0.03, 0.035)), ("yellow", (0.80, 0.52, 0.05)),
                        ("blue", (0.04, 0.15, 0.40)), ("white", (0.80, 0.79, 0.76)))]
        self.neon = material("neon", (0.9, 0.5, 0.4), emission=(14.0, 2.4, 1.1))
        self.lamp = material("lamp_glow", (0.0, 0.0, 0.0), emission=(30.0, 22.0, 13.0))
        self.canvas = {name: material(name, roughness=0.8, picture=texture(name, getattr(pictures, name)(), clamp=True))
                       for name in ("sunset", "circles", "planes", "dunes")}
