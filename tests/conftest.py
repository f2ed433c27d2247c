# Imported first: it chooses the OpenGL backend, which MuJoCo reads when it is imported.
import quadruped_env  # noqa: F401  # isort: skip

import functools
import os

import browser
import domains
import live_nodes
import missing_opengl
import mujoco
import pytest
import ros2_peers

from quadruped_env import asset_path
from quadruped_env.envs import rendering
from quadruped_env.simulation import build_model

# Without the fixture `domain_id`, no test joins a DDS domain: a robot may listen there.
os.environ["ROS_DOMAIN_ID"] = "none in tests; take the fixture domain_id"


@pytest.fixture(scope="session")
def model():
    return build_model()


@pytest.fixture(scope="session")
def urdf():
    import yourdfpy

    return yourdfpy.URDF.load(str(asset_path("mini_quadruped.urdf")), load_meshes=False)


@pytest.fixture(scope="session")
def urdf_model():
    """The URDF compiled by MuJoCo, without fusing static bodies, which would merge the base into the world."""
    spec = mujoco.MjSpec.from_file(str(asset_path("mini_quadruped.urdf")))
    spec.compiler.fusestatic = False
    return spec.compile()


@pytest.fixture(scope="session")
def mjcf():
    """The robot's MJCF without the ground."""
    return mujoco.MjModel.from_xml_path(str(asset_path("mini_quadruped.xml")))


@pytest.fixture
def domain_id(monkeypatch):
    """A DDS domain that only this test and no other program uses; processes that it starts join it too."""
    from quadruped_env.live.middleware import dds

    with domains.claimed() as number:
        monkeypatch.setenv("ROS_DOMAIN_ID", str(number))
        yield number
        # Otherwise its sockets would stay open, and the domain taken, as long as this process runs.
        if joined := dds._DOMAINS.pop(number, None):
            joined[1]._delete(joined[1]._ref)


@pytest.fixture
def nodes(domain_id):
    """Factory of nodes on the test's domain; closes them after the test."""
    from quadruped_env.live import Node

    made = []

    def make(name="test"):
        made.append(Node(name))
        return made[-1]

    yield make
    for node in made:
        node.close()


@pytest.fixture
def control(tmp_path):
    """Factory of view controllers; closes them after the test."""
    from quadruped_env.policies import find_controllers
    from quadruped_env.viewer import ViewController

    made = []

    def make(*names, asked=()):
        sources, chosen = find_controllers(asked, runs=tmp_path / "runs")
        made.append(ViewController(sources, names or chosen, tmp_path / "results"))
        return made[-1]

    yield make
    for controller in made:
        controller.close()


@pytest.fixture
def start(domain_id, tmp_path):
    """Function that starts live nodes on the test's domain: `start("sim", "--seed", "1")`."""
    with live_nodes.launcher(tmp_path) as start:
        yield start


@pytest.fixture
def run_node(domain_id):
    """Function that runs a live node in a thread until the test ends, such as `run_node("controller", "trot")`."""
    running = []

    def run(*arguments):
        running.append(live_nodes.InThread(*arguments))
        return running[-1]

    yield run
    for node in running:
        node.interrupt()


@pytest.fixture(scope="session")
def comparison():
    """A small comparison of a random policy with the scripted controllers."""
    from comparisons import TINY, random_policy

    from quadruped_env.evaluation.comparison import compare

    return compare(random_policy("residual"), num_seeds=2, seconds=3.0, commands=TINY)


@pytest.fixture(params=ros2_peers.DISTRIBUTIONS)
def ros2(request, domain_id):
    """A real ROS 2 on the test's domain; skips where it is not installed."""
    return ros2_peers.Ros2(request.param)


# Not session-scoped: while it runs, Playwright's event loop occupies the thread, and no test could run its own.
@pytest.fixture(scope="module")
def chromium():
    """A running Chromium; skips the test if none is installed."""
    with browser.launched() as running:
        yield running


@pytest.fixture
def page(chromium):
    """A new page of it, with its errors and requests in `page.watched`."""
    with browser.opened(chromium) as page:
        yield page


@pytest.fixture
def opengl():
    """Skips the test if OpenGL cannot render here."""
    if failure := rendering.opengl_failure():
        pytest.skip(failure)


@pytest.fixture
def without_opengl(tmp_path):
    """Function that returns a command which runs another one without OpenGL libraries."""
    scratch = tmp_path / "without_opengl"
    scratch.mkdir()
    if obstacle := missing_opengl.obstacle(scratch):
        pytest.skip(f"OpenGL cannot be hidden: {obstacle}")
    return functools.partial(missing_opengl.command, scratch)
