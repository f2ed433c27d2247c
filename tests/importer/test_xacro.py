"""Xacro files: expanded by the library, without running code, reading the environment, or files outside the folders."""

import subprocess
import sys
from pathlib import Path

import pytest
from urdf_robots import MASS, THIGH, imported, robot

from quadruped_env.errors import MissingExtraError, QuadrupedError
from quadruped_env.importer import import_robot, xacro_file, xacro_process
from quadruped_env.importer.arithmetic import check_arithmetic
from quadruped_env.importer.files import Folders

pytest.importorskip("xacro")
NAMESPACE = ' xmlns:xacro="http://www.ros.org/wiki/xacro"'


def xacro(text, extra=""):
    """A URDF as a xacro file with something at its beginning."""
    return text.replace('<robot name="made">', f'<robot name="made"{NAMESPACE}>{extra}', 1)


def test_properties_macros_includes_and_packages_are_expanded(tmp_path):
    package = tmp_path / "dog"
    (package / "urdf").mkdir(parents=True)
    (package / "a").mkdir()
    (package / "a" / "package.xml").write_text("<package><name>other</name></package>")
    (package / "package.xml").write_text("<package><name> dog_description </name></package>")
    (package / "numbers.yaml").write_text("leg: {thigh: 0.2}\n")
    (package / "urdf" / "part.xacro").write_text(
        f'<robot{NAMESPACE}><xacro:property name="numbers" value="${{load_yaml(\'../numbers.yaml\')}}"/>'
        '<xacro:macro name="camera" params="mass:=0.5"><link name="camera"><inertial><mass value="${mass * 2**1}"/>'
        '<inertia ixx="0.1" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial></link>'
        '<joint name="c" type="fixed"><parent link="base"/><child link="camera"/></joint></xacro:macro></robot>'
    )
    include = '<xacro:include filename="$(find dog_description)/urdf/part.xacro"/><xacro:camera mass="${0.25 + 0.25}"/>'
    thigh = "${-numbers['leg']['thigh'] * cos(radians(0)) if True else 1}"
    text = xacro(robot(), include).replace(f'xyz="0 0 {-THIGH}"', f'xyz="0 0 {thigh}"')
    read = imported(text, package / "urdf", "dog.urdf.xacro")
    assert read.mass == pytest.approx(MASS + 1.0)
    assert read.stance.thigh == pytest.approx(THIGH)


@pytest.mark.parametrize(
    "text",
    [
        "().__class__",
        "[c for c in [1]]",
        "(lambda: 1)()",
        "'{0.real}'.format(1)",
        "f'{x}'",
        "python.vars()",
        "type(1)",
        "open('/etc/passwd')",
        "9**9**9",
        "9**99",
        "'a' * 10",
        "factorial(9)",
        "(1).bit_length()",
        "dict(a=1)",
        "x[0](1)",
        "1 +",
        "x := 1",
    ],
)
def test_expression_that_is_more_than_arithmetic_is_refused(text):
    with pytest.raises(QuadrupedError, match=r"is more than arithmetic, so it is not evaluated|is no expression"):
        check_arithmetic(text)


@pytest.mark.parametrize(
    "text",
    [
        "-a * (b + 2.0) / 3 - x['y'][0]",
        "pi / 2 if reflect == -1 else 0",
        "prefix + '_hip'",
        "math.sin(radians(3))",
        "name.startswith('l')",
        "a**2",
        "xacro.load_yaml('a.yaml')",
        "props.leg.length",
    ],
)
def test_arithmetic_of_real_files_is_allowed(text):
    check_arithmetic(text)


def expansion_error(text, folder):
    """The message with which a xacro file is refused, in this process, which is faster."""
    path = folder / "dog.xacro"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(Exception) as caught:  # noqa: PT011  whatever the library raises
        xacro_process.expand(path, Folders((), path))
    return xacro_process.line(caught.value)


@pytest.mark.parametrize(
    ("begin", "message"),
    [
        ("${open('/etc/passwd')}", "is more than arithmetic"),
        ("${undefined_name}", "'undefined_name' is not defined"),
        ("$(eval 1 + 1)", "$(eval ...) runs code"),
        ("$(env HOME)", "$(env ...) runs code or reads the environment"),
        ("$(find nowhere)", "the package 'nowhere' is not found: no folder has that name, or a package.xml with it"),
        ("${load_yaml('/etc/passwd')}", "is outside the folders"),
        ("${xacro.load_yaml('/etc/passwd')}", "is outside the folders"),
    ],
)
def test_code_environment_and_unknown_packages_are_refused(tmp_path, begin, message):
    text = xacro(robot(2), f'<link name="x"><inertial><mass value="{begin}"/></inertial></link>')
    assert message in expansion_error(text, tmp_path)


def test_default_of_an_environment_variable_is_taken_without_reading_it(tmp_path, monkeypatch):
    monkeypatch.setenv("BASE_MASS", "9")
    text = xacro(robot(2)).replace('value="4.0"', 'value="$(optenv BASE_MASS 4.0)"')
    assert imported(text, tmp_path, "dog.xacro").bodies[0].mass == 4.0


@pytest.mark.parametrize(
    ("extra", "message"),
    [
        ('<xacro:include filename="../secret.xacro"/>', "is outside the folders"),
        ('<xacro:include filename="/etc/passwd"/>', "is outside the folders"),
        ('<xacro:include filename="bomb.xacro"/>', "declares the entity 'a'"),
        ('<xacro:macro name="m"><xacro:m/></xacro:macro><xacro:m/>', "recursion"),
        ("<xacro:unknown/>", "unknown macro name: xacro:unknown"),
    ],
)
def test_include_or_macro_that_is_hostile_is_refused(tmp_path, extra, message):
    inner = tmp_path / "inner"
    inner.mkdir()
    (tmp_path / "secret.xacro").write_text(f"<robot{NAMESPACE}/>")
    (inner / "bomb.xacro").write_text('<!DOCTYPE r [<!ENTITY a "aaaa">]><robot/>')
    assert message in expansion_error(xacro(robot(2), extra), inner)


def test_error_of_the_process_names_the_file_on_one_line(tmp_path):
    with pytest.raises(QuadrupedError, match=r"dog\.xacro: xacro: \$\(eval \.\.\.\) runs code [^\n]*$"):
        imported(xacro(robot(2), '<link name="$(eval 1)"/>'), tmp_path, "dog.xacro")


def test_macros_that_grow_without_an_end_are_stopped(tmp_path, monkeypatch):
    monkeypatch.setattr(xacro_file, "_SECONDS", 2.0)
    macros = "".join(f'<xacro:macro name="m{i}">{f"<xacro:m{i - 1}/>" * 30}</xacro:macro>' for i in range(1, 9))
    text = xacro(robot(2), f'<xacro:macro name="m0"><link/></xacro:macro>{macros}<xacro:m8/>')
    with pytest.raises(QuadrupedError, match="look for macros"):
        imported(text, tmp_path, "dog.xacro")


def test_missing_library_is_named_with_its_extra(tmp_path, monkeypatch):
    monkeypatch.setattr(xacro_file.importlib.util, "find_spec", lambda _: None)
    with pytest.raises(MissingExtraError, match=r"reading xacro files needs the 'xacro' extra"):
        imported(xacro(robot(2), '<xacro:property name="x" value="1"/>'), tmp_path, "dog.xacro")


def test_urdf_that_the_library_has_written_does_not_need_it(tmp_path, monkeypatch):
    monkeypatch.setattr(xacro_file, "expanded", None)
    assert imported(xacro(robot(2), "<!-- of ${prefix} -->"), tmp_path).name == "made"


def test_library_alone_would_run_code():
    """The reason for the check: nested code escapes the library's own."""
    escape = "(lambda: ().__class__.__name__)()"
    code = f"import xacro; print(xacro.safe_eval({escape!r}, {{}}))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert done.stdout.strip() == "tuple"


def test_public_xacro_of_solo_is_read():
    from paths import ROBOTS

    path = ROBOTS / "solo8_xacro" / "solo8.urdf.xacro"
    if not path.is_file():
        pytest.skip("the xacro of Solo8 is not here")
    read = import_robot(Path(path))
    assert [leg.names for leg in read.anatomy.legs] == [(f"{c}_HFE", f"{c}_KFE") for c in ("FL", "FR", "HL", "HR")]
    assert read.stance.thigh == pytest.approx(0.16)
