"""docs/scaling.md: its commands exist, and its manifest is one that Kubernetes takes."""

import re
import shlex

import yaml
from paths import ROOT

from quadruped_env.cli.main import make_parser

PAGE = (ROOT / "docs" / "scaling.md").read_text()


def test_commands_of_the_page_are_parsed():
    parser = make_parser(only="sweep")
    commands = re.findall(r"mini-quadruped (sweep --[^`#\n]*)", PAGE)
    assert len(commands) >= 8
    for command in commands:
        parser.parse_args(shlex.split(command.replace("<name>", "NAME")))


def test_manifest_is_a_job_of_workers_that_share_the_volume_and_start_again():
    (text,) = re.findall(r"```yaml\n(.*?)```", PAGE, re.DOTALL)
    job = yaml.safe_load(text)
    assert (job["apiVersion"], job["kind"]) == ("batch/v1", "Job")
    assert job["spec"]["parallelism"] > 1
    assert "completions" not in job["spec"], "with them, each success would start another pod"
    pod = job["spec"]["template"]["spec"]
    assert pod["restartPolicy"] == "OnFailure"
    (container,) = pod["containers"]
    make_parser(only="sweep").parse_args(container["command"][1:])
    (mount,) = container["volumeMounts"]
    assert container["command"][-1].startswith(mount["mountPath"])
    assert [mount["name"]] == [volume["name"] for volume in pod["volumes"]]
    assert len(text.splitlines()) <= 22
