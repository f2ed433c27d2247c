"""Programs in a mount namespace in which no OpenGL library is installed."""

import os
import subprocess
import sys
from shutil import which

# An overlay hides the libraries from the linker's default folders, and a cache without them from `ldconfig -p`.
HIDE = """
set -e
mount -t tmpfs tmpfs "$1"
scratch=$1
shift
folders=$(ldconfig -p | sed -nE 's,.* => (.*)/lib(EGL|OSMesa|GL|OpenGL)\\.so.*,\\1,p' | xargs -r readlink -f | sort -u)
for folder in $folders; do
    part=$(mktemp -d -p "$scratch")
    mkdir "$part/up" "$part/work"
    mount -t overlay overlay -o "lowerdir=$folder,upperdir=$part/up,workdir=$part/work" "$folder"
    rm -f "$folder"/lib*GL*.so* "$folder"/libOSMesa*
done
ldconfig -C "$scratch/cache"
mount --bind "$scratch/cache" /etc/ld.so.cache
exec "$@"
"""
DISPLAYS = ("DISPLAY", "WAYLAND_DISPLAY", "MUJOCO_GL", "PYOPENGL_PLATFORM", "MUJOCO_EGL_DEVICE_ID")


def environment(**variables):
    """This process's environment without displays and choices of OpenGL, and with some variables."""
    return {name: value for name, value in os.environ.items() if name not in DISPLAYS} | variables


def command(scratch, *arguments):
    """A command that runs another one without OpenGL libraries; `scratch` is an empty directory."""
    user = () if os.geteuid() == 0 else ("--map-root-user",)
    return ["unshare", "--mount", *user, "sh", "-c", HIDE, "sh", str(scratch), *map(str, arguments)]


def obstacle(scratch):
    """Why OpenGL cannot be hidden here; empty if it can."""
    if not sys.platform.startswith("linux") or which("unshare") is None:
        return "no mount namespaces here"
    tried = subprocess.run(command(scratch, "true"), capture_output=True, text=True, check=False)
    return tried.stderr.strip() if tried.returncode else ""
