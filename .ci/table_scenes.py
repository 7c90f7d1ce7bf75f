"""The scenes of `compare`, as the tables of the documentation call them, in their order."""

SCENES = {
    "gas": "gas: everything flies about",
    "swarm": "swarm: kinematic, no solver",
    "crowd": "crowd: everything walks, slowly",
    "sleeping": "sleeping: 1 % moves",
    "falling-balls": "falling balls",
    "pyramid": "pyramid, coming to rest",
    "ropes": "ropes",
    "net": "net: balls joined in rows and columns",
    "hopper": "hopper: grains are poured",
    "mixed-1.5": "sizes 1 to 1.5",
    "mixed-4": "sizes 1 to 4",
    "mixed-8": "sizes 1 to 8",
    "mixed-1000": "sizes 1 to 1000",
    "bullets": "bullets, with CCD",
    "churn": "churn: 2 % replaced each step",
    "shapes": "shapes: compounds, meshes, sensors",
    "soft": "soft bodies among balls",
    "tile-map": "map of fixed blocks, 500 balls",
    "ships": "three ships of 1,728 cubes",
    "ghosts": "ghosts: groups forbid contact",
    "player": "player: character, vehicle, 16 rays of its own",
    "stacks": "stacks of boxes, 0.05 apart",
    "wall": "brick wall",
    "pyramids": "many small pyramids",
    "chains": "slanting chains: boxes overlap, links do not",
    "falling-balls-8000": "falling balls, 8,000",
    "pyramid-8000": "pyramid of 8,000",
    "mixed-1.5-8000": "sizes 1 to 1.5, 8,000 bodies",
}


def scenes_of(sources, version):
    """The scenes of a page of `compare`, in the order of the tables: a page that was stored before a scene was made lacks it."""
    there = sources.scenes(version)
    return {name: label for name, label in SCENES.items() if name in there}
