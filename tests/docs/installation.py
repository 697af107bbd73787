# SPDX-License-Identifier: MIT
"""An installed mgdt: where its parts are, and how one is made of a Meson build folder."""
import fcntl
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path


class Installation:
    def __init__(self, prefix, lock=None):
        self.prefix = prefix
        self.lock = lock  # held for as long as the prefix is in use
        if not list(prefix.glob("include/mgdt/mgdt.h")):
            sys.exit(f"no mgdt is installed in {prefix}")

    def folders(self, *patterns):
        return [str(p) for pattern in patterns for p in sorted(self.prefix.glob(pattern)) if p.is_dir()]

    def environment(self, source, home):
        """What a reader would have set who installed mgdt there."""
        here = os.environ
        values = {k: v for k, v in here.items()
                  if k not in ("DESTDIR", "CFLAGS", "CXXFLAGS", "FFLAGS", "FCFLAGS", "LDFLAGS", "CPATH",
                               "LIBRARY_PATH", "MAKEFLAGS") and not k.startswith(("MESON_", "MGDT_"))}

        def put(name, found, rest=""):
            values[name] = os.pathsep.join([*found, *([rest] if rest else [])])

        libraries = [str(Path(f).parent) for f in self.folders("lib*/pkgconfig", "lib*/*/pkgconfig")]
        # The Python that runs this also runs the examples.
        put("PATH", [str(self.prefix / "bin"), str(Path(sys.executable).parent)], here.get("PATH", os.defpath))
        put("LD_LIBRARY_PATH", libraries, here.get("LD_LIBRARY_PATH", ""))
        put("PKG_CONFIG_PATH", [str(Path(f) / "pkgconfig") for f in libraries])
        put("CMAKE_PREFIX_PATH", [str(self.prefix)])
        # The package is installed only where Meson is asked to; pip would take it from here.
        packages = self.folders("lib*/python3*/*-packages", "local/lib*/python3*/*-packages")
        put("PYTHONPATH", packages or [str(Path(source) / "bindings" / "python")])
        values.update(MGDT_SOURCE=str(source), HOME=str(home), LC_ALL="C.UTF-8")
        # Open MPI asks root, and those who have fewer processors than ranks, to say that they mean it.
        values.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                      OMPI_MCA_rmaps_base_oversubscribe="1", OMPI_MCA_plm="isolated",
                      OMPI_MCA_btl="self,vader", OMPI_MCA_pml="ob1")
        return values


def options_of(build):
    text = subprocess.run(["meson", "introspect", "--buildoptions", str(build)], check=True,
                          capture_output=True, text=True).stdout
    return {o["name"]: o["value"] for o in json.loads(text)}


def newest(build):
    """When the latest of the files that would be installed was changed."""
    text = subprocess.run(["meson", "introspect", "--installed", str(build)], check=True,
                          capture_output=True, text=True).stdout
    times = [(build / "build.ninja").stat().st_mtime]
    for name in json.loads(text):
        path = Path(name)
        files = path.rglob("*") if path.is_dir() else [path]
        times += [f.stat().st_mtime for f in files if f.exists()]
    return max(times)


def of_build(build, destination):
    """The installation of a build folder, made if it is older than what was built. It may be asked
    for by several processes at once."""
    options = options_of(build)
    if options.get("pkgconfig.relocatable") is not True:
        # Staged, it stands elsewhere than the prefix; build folders made before this was the default.
        sys.exit(f"first: meson configure {build} -Dpkgconfig.relocatable=true")
    prefix = destination / options["prefix"].lstrip("/")
    stamp = destination.with_suffix(".stamp")
    lock = open(destination.with_suffix(".lock"), "w")
    while True:
        fcntl.flock(lock, fcntl.LOCK_SH)
        if stamp.exists() and stamp.stat().st_mtime > newest(build):
            return Installation(prefix, lock)
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not (stamp.exists() and stamp.stat().st_mtime > newest(build)):
            shutil.rmtree(destination, ignore_errors=True)
            run = subprocess.run(["meson", "install", "-C", str(build), "--no-rebuild", "--destdir",
                                  str(destination)], capture_output=True, text=True)
            if run.returncode:
                sys.exit(f"meson install of {build} failed:\n{run.stdout}{run.stderr}")
            stamp.touch()
