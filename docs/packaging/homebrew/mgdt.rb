# SPDX-License-Identifier: MIT
# A formula for Homebrew. The address and the checksum are those of the release that it is for.
class Mgdt < Formula
  desc "Exact 3D Delaunay triangulation of any set of points"
  homepage "https://mgdt.example"
  url "https://mgdt.example/mgdt-1.4.0.tar.gz"
  sha256 "0000000000000000000000000000000000000000000000000000000000000000"
  license "MIT"

  depends_on "cli11" => :build
  depends_on "meson" => :build
  depends_on "ninja" => :build
  depends_on "pkgconf" => :build
  depends_on "fmt"

  uses_from_macos "zlib"

  def install
    options = %w[-Dtests=disabled -Dprogram=enabled -Dmpi=disabled]
    system "meson", "setup", "build", *options, *std_meson_args
    system "meson", "compile", "-C", "build"
    system "meson", "install", "-C", "build"
  end

  test do
    (testpath/"first.c").write <<~C
      #include <mgdt/mgdt.h>
      int main(void) {
        static const double xyz[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1};
        mgdt_triangulation* t;
        return mgdt_create(&t) != MGDT_OK || mgdt_insert_points(t, 5, xyz) != MGDT_OK || mgdt_tetrahedron_count(t) != 2;
      }
    C
    system ENV.cc, "first.c", "-I#{include}", "-L#{lib}", "-lmgdt", "-o", "first"
    system "./first"
    system bin/"mgdt", "generate", "uniform", "100", "-o", "points.npy"
    system bin/"mgdt", "triangulate", "points.npy", "-o", "mesh.vtu", "--check", "3"
  end
end
