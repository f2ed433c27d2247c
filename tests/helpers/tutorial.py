"""The tutorial's robot: the reference for tests of the robot's files and of the package."""

# Written out here, not imported: these are the reference values.
LEGS = {"LF": (0.15, 0.10), "RF": (0.15, -0.10), "LH": (-0.15, 0.10), "RH": (-0.15, -0.10)}
JOINTS = (
    "LF_hip_joint",
    "LF_knee_joint",
    "RF_hip_joint",
    "RF_knee_joint",
    "LH_hip_joint",
    "LH_knee_joint",
    "RH_hip_joint",
    "RH_knee_joint",
)
LIMITS = {"hip": (-1.5, 1.5), "knee": (-2.0, 0.0)}
EFFORT, VELOCITY = 10.0, 5.0
GRAY, BLUE, BLACK = (0.5, 0.5, 0.5, 1.0), (0.2, 0.3, 0.8, 1.0), (0.1, 0.1, 0.1, 1.0)
LINKS = ("base_link", "LF_hip", "LF_leg", "RF_hip", "RF_leg", "LH_hip", "LH_leg", "RH_hip", "RH_leg")
SHAPES = {
    "base_link": ("box", (0.30, 0.15, 0.08), GRAY, (0.0, 0.0, 0.0)),
    "hip": ("sphere", (0.03,), BLUE, (0.0, 0.0, 0.0)),
    "leg": ("cylinder", (0.02, 0.16), BLACK, (0.0, 0.0, -0.08)),
}
"""Shape, size, colour and centre of each link in the tutorial; its inertia follows from the shape."""
MASSES = {"base_link": 2.2, "hip": 0.25, "leg": 0.20}


def kind(name):
    """`hip`, `leg` or `knee` of a link or joint; `base_link` for itself."""
    return name if name == "base_link" else name.split("_")[1]


def geoms(model, link, group):
    """Ids of a body's geoms in a group: 2 is visual, 3 is collision."""
    body = model.body(link).id
    return [i for i in range(model.ngeom) if model.geom_bodyid[i] == body and model.geom_group[i] == group]


def random_positions(rng, *shape):
    return rng.uniform(
        [LIMITS["hip"][0], LIMITS["knee"][0]] * 4, [LIMITS["hip"][1], LIMITS["knee"][1]] * 4, (*shape, 8)
    )
