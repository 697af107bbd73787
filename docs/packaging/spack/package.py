# SPDX-License-Identifier: MIT
# A recipe for Spack. The address and the checksum are those of the release that it is for.
from spack.package import MesonPackage, depends_on, extends, license, variant, version


class Mgdt(MesonPackage):
    """Exact 3D Delaunay triangulation of any set of points: a C library with bindings for Fortran,
    C++, Lua, Octave, Python, Ruby and Rust, and a program."""

    homepage = "https://mgdt.example"
    url = "https://mgdt.example/mgdt-1.4.0.tar.gz"

    license("MIT")

    version("1.4.0", sha256="0000000000000000000000000000000000000000000000000000000000000000")

    variant("program", default=True, description="Build the program mgdt")
    variant("mpi", default=False, description="Build libmgdt_mpi, one triangulation on the ranks of MPI")
    variant("python", default=False, description="Install the Python package")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("meson@1.0:", type="build")
    depends_on("pkgconfig", type="build")
    depends_on("cli11", when="+program", type="build")
    depends_on("fmt", when="+program")
    depends_on("zlib-api", when="+program")
    depends_on("mpi", when="+mpi")
    depends_on("python@3.9:", type="build")
    extends("python@3.9:", when="+python")
    depends_on("py-numpy@1.21:", when="+python", type=("build", "run"))

    def meson_args(self):
        def feature(name):
            return "enabled" if self.spec.satisfies("+" + name) else "disabled"

        arguments = [
            "-Dtests=disabled",
            "-Dprogram=" + feature("program"),
            "-Dmpi=" + feature("mpi"),
            "-Dpython=" + str(self.spec.satisfies("+python")).lower(),
        ]
        if self.spec.satisfies("^mpich"):
            arguments.append("-Dmpi_package=mpich")
        return arguments
