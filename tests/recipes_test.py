# SPDX-License-Identifier: MIT
"""The recipes below docs/packaging, without the servers that they are for: each is read by the
language it is written in, with a stand-in for its package manager, and its commands are run.

  recipes_test.py SOURCE WORK [TEST...]
"""
import ast
import configparser
import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import tomllib
import types
import unittest
from pathlib import Path

import jinja2
import yaml

SOURCE, WORK = (Path(argument).resolve() for argument in sys.argv[1:3])
RECIPES = SOURCE / "docs" / "packaging"
VERSION = re.search(r"version: '(.*)'", (SOURCE / "meson.build").read_text()).group(1)
FIRST = """#include <mgdt/mgdt.h>
int main(void) {
    static const double xyz[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1};
    mgdt_triangulation* t;
    return mgdt_create(&t) != MGDT_OK || mgdt_insert_points(t, 5, xyz) != MGDT_OK || mgdt_tetrahedron_count(t) != 2;
}
"""


def run(*command, folder=WORK, **environment):
    done = subprocess.run([str(word) for word in command], cwd=folder, env={**os.environ, **environment},
                          stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    assert done.returncode == 0, f"{command}\n{done.stdout}"
    return done.stdout


def fresh(name):
    folder = WORK / name
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    return folder


class Recipes(unittest.TestCase):
    def configures(self, name, options):
        """Meson takes these options, for the version that the recipe names."""
        self.assertTrue(options)
        folder = fresh(name) / "build"
        run("meson", "setup", folder, SOURCE, *options)
        return folder

    def test_spack(self):
        text = (RECIPES / "spack" / "package.py").read_text()
        ast.parse(text)
        said = {"variant": [], "version": [], "depends_on": [], "extends": [], "license": []}
        names = {name: lambda *words, _list=calls, **named: _list.append((words, named))
                 for name, calls in said.items()}
        names["MesonPackage"] = object
        package = types.ModuleType("spack.package")
        package.__dict__.update(names)
        sys.modules.update({"spack": types.ModuleType("spack"), "spack.package": package})
        scope = {}
        exec(compile(text, "package.py", "exec"), scope)
        self.assertEqual([words[0] for words, _ in said["version"]], [VERSION])
        for chosen in ({"+program"}, {"+program", "+mpi", "^openmpi"}, {"+mpi", "^mpich"}, {"+python"}):
            self.assertTrue({w[1:] for w in chosen if w[0] == "+"} <= {words[0] for words, _ in said["variant"]})
            recipe = scope["Mgdt"]()
            recipe.spec = types.SimpleNamespace(satisfies=chosen.__contains__)
            self.configures("spack", recipe.meson_args())

    def test_conda(self):
        functions = {"compiler": str, "stdlib": str, "pin_subpackage": lambda name, **_: name}
        text = jinja2.Environment().from_string((RECIPES / "conda" / "meta.yaml").read_text()).render(**functions)
        recipe = yaml.safe_load(text)
        self.assertEqual(recipe["package"], {"name": "mgdt", "version": VERSION})
        folder = fresh("conda")
        run("git", "clone", "--quiet", SOURCE, folder / "source")
        run("/usr/bin/python3", "-m", "venv", "--system-site-packages", folder / "prefix")
        python = folder / "prefix" / "bin" / "python"
        environment = {"PREFIX": str(folder / "prefix"), "PYTHON": str(python), "PIP_NO_INDEX": "1",
                       "PATH": f"{folder / 'prefix' / 'bin'}:{os.environ['PATH']}",
                       # conda's Python finds libraries beside itself.
                       "LD_LIBRARY_PATH": str(folder / "prefix" / "lib")}
        for command in [*recipe["build"]["script"], *recipe["test"]["commands"],
                        *(f"python -c 'import {name}'" for name in recipe["test"]["imports"])]:
            run("sh", "-ec", command, folder=folder / "source", **environment)
        # The package is without a library of its own.
        found = run(python, "-c", "import mgdt; print(mgdt.library_path())", **environment)
        self.assertNotIn("site-packages", found)

    def test_vcpkg(self):
        manifest = json.loads((RECIPES / "vcpkg" / "vcpkg.json").read_text())
        self.assertEqual((manifest["name"], manifest["version"]), ("mgdt", VERSION))
        # The ports that have what the port calls.
        port = (RECIPES / "vcpkg" / "portfile.cmake").read_text()
        owners = {"vcpkg_cmake_config_fixup": "vcpkg-cmake-config", "vcpkg_configure_meson": "vcpkg-tool-meson"}
        self.assertEqual({owner for function, owner in owners.items() if function in port},
                         {d["name"] for d in manifest["dependencies"]})
        folder = fresh("vcpkg")
        (folder / "stand-in.cmake").write_text(f"""
cmake_minimum_required(VERSION 3.13)
set(VERSION {VERSION})
set(CURRENT_PACKAGES_DIR "{folder}/packages")
function(vcpkg_download_distfile out)
    set(${{out}} archive PARENT_SCOPE)
endfunction()
function(vcpkg_extract_source_archive out)
    set(${{out}} "{SOURCE}" PARENT_SCOPE)
endfunction()
function(vcpkg_configure_meson)
    cmake_parse_arguments(given "" "SOURCE_PATH" "OPTIONS" ${{ARGN}})
    execute_process(COMMAND meson setup "{folder}/build" "${{given_SOURCE_PATH}}" --libdir=lib ${{given_OPTIONS}}
        "--prefix=${{CURRENT_PACKAGES_DIR}}" COMMAND_ERROR_IS_FATAL ANY)
endfunction()
function(vcpkg_install_meson)
    execute_process(COMMAND meson install -C "{folder}/build" COMMAND_ERROR_IS_FATAL ANY)
endfunction()
function(vcpkg_fixup_pkgconfig)
endfunction()
function(vcpkg_cmake_config_fixup)
    cmake_parse_arguments(given "" "CONFIG_PATH" "" ${{ARGN}})
    if(NOT EXISTS "${{CURRENT_PACKAGES_DIR}}/${{given_CONFIG_PATH}}/mgdt-config.cmake")
        message(FATAL_ERROR "no ${{given_CONFIG_PATH}}")
    endif()
endfunction()
function(vcpkg_install_copyright)
    cmake_parse_arguments(given "" "" "FILE_LIST" ${{ARGN}})
    if(NOT EXISTS "${{given_FILE_LIST}}")
        message(FATAL_ERROR "no ${{given_FILE_LIST}}")
    endif()
endfunction()
include("{RECIPES}/vcpkg/portfile.cmake")
""")
        run("cmake", "-P", folder / "stand-in.cmake", folder=folder)
        installed = folder / "packages"
        (folder / "first.c").write_text(FIRST)
        run("gcc", "first.c", f"-I{installed}/include", f"-L{installed}/lib", "-lmgdt", "-o", "first", folder=folder)
        run("./first", folder=folder, LD_LIBRARY_PATH=f"{installed}/lib")

    def test_homebrew(self):
        folder = fresh("homebrew")
        (folder / "stand-in.rb").write_text(f"""
require "pathname"
class Formula
  class << self
    %i[desc homepage url sha256 license depends_on uses_from_macos].each {{ |name| define_method(name) {{ |*| }} }}
    def test(&block) = define_method(:test, &block)
  end
  def prefix = Pathname.new("{folder}/prefix")
  def bin = prefix/"bin"
  def lib = prefix/"lib"
  def include = prefix/"include"
  def testpath = Pathname.new("{folder}")
  def std_meson_args = ["--prefix=#{{prefix}}", "--libdir=#{{lib}}", "--buildtype=release", "--wrap-mode=nofallback"]
  def system(*words) = Kernel.system(*words.map(&:to_s)) || raise("failed: #{{words.join(' ')}}")
end
def ENV.cc = "gcc"
load "{RECIPES}/homebrew/mgdt.rb"
formula = Mgdt.new
Dir.chdir("{folder}/source") {{ formula.install }}
Dir.chdir("{folder}") {{ formula.test }}
""")
        self.assertIn(f"mgdt-{VERSION}.tar.gz", (RECIPES / "homebrew" / "mgdt.rb").read_text())
        run("git", "clone", "--quiet", SOURCE, folder / "source")
        run("ruby", "-w", "stand-in.rb", folder=folder, LD_LIBRARY_PATH=f"{folder}/prefix/lib")

    def test_meson_wrap(self):
        """With the archive where Meson keeps what it has fetched."""
        folder = fresh("wrap")
        run("git", "archive", f"--prefix=mgdt-{VERSION}/", "-o", folder / "archive.tar.gz", "HEAD", folder=SOURCE)
        wrap = configparser.ConfigParser(interpolation=None)
        wrap.read(RECIPES / "meson" / "mgdt.wrap")
        cache = folder / "subprojects" / "packagecache"
        cache.mkdir(parents=True)
        archive = cache / wrap["wrap-file"]["source_filename"]
        shutil.move(folder / "archive.tar.gz", archive)
        wrap["wrap-file"]["source_hash"] = hashlib.sha256(archive.read_bytes()).hexdigest()
        with open(folder / "subprojects" / "mgdt.wrap", "w") as out:
            wrap.write(out)
        (folder / "meson.build").write_text("""project('first', 'c')
mgdt = dependency('mgdt', default_options: ['tests=disabled', 'program=disabled', 'mpi=disabled'])
test('first', executable('first', 'first.c', dependencies: mgdt))
""")
        (folder / "first.c").write_text(FIRST)
        run("meson", "setup", "build", "--wrap-mode=forcefallback", folder=folder)
        run("meson", "test", "-C", "build", folder=folder)

    def test_fpm(self):
        """What fpm does: all sources of the folder that are no programs, in the order of their modules, in
        one archive, and the library that the manifest names."""
        folder = fresh("fpm")
        here = SOURCE / "bindings" / "fortran"
        manifest = tomllib.loads((here / "fpm.toml").read_text())
        self.assertEqual((manifest["name"], manifest["version"]), ("mgdt", VERSION))
        sources = {}
        for path in sorted((here / manifest["library"]["source-dir"]).rglob("*.f90")):
            text = path.read_text().lower()
            if not re.search(r"^\s*program\s", text, re.MULTILINE):
                sources[path] = (set(re.findall(r"^\s*(?:sub)?module\s+(?!procedure)(\w+)\s*$", text, re.MULTILINE)),
                                 set(re.findall(r"^\s*use\s+(mgdt\w*)", text, re.MULTILINE)) |
                                 set(re.findall(r"^\s*submodule\s*\(\s*(\w+)", text, re.MULTILINE)))
        self.assertIn(here / "mgdt.f90", sources)
        done = set()
        while sources:
            ready = [path for path, (_, used) in sources.items() if used <= done | sources[path][0]]
            self.assertTrue(ready, f"modules that no source has: {sources}")
            for path in ready:
                run("gfortran", "-c", path, folder=folder)
                done |= sources.pop(path)[0]
        run("sh", "-c", "ar rc libmodules.a *.o", folder=folder)
        (folder / "first.f90").write_text("""program first
    use mgdt
    implicit none
    type(mgdt_triangulation) :: t
    integer :: status
    call t%create(stat=status)
    if (status /= mgdt_ok) error stop 1
end program first
""")
        build = folder / "build"
        run("meson", "setup", build, SOURCE, "-Dtests=disabled", "-Dprogram=disabled", "-Dmpi=disabled")
        run("ninja", "-C", build)
        run("gfortran", "first.f90", "-o", "first", "-L.", "-lmodules", f"-L{build}/src", f"-l{manifest['build']['link']}",
            folder=folder)
        run("./first", folder=folder, LD_LIBRARY_PATH=f"{build}/src")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
