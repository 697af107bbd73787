// SPDX-License-Identifier: MIT
//! Meshes of tetrahedra.

use crate::keyed::{Calls, Keyed};
use crate::triangulation::as_i64;
use crate::{Error, ErrorKind, TetrahedronMeasure};
use mgdt_sys as sys;
use std::fmt;
use std::ptr;

/// Arrays of integers of a [`Mesh`]. In them "none" is [`NONE`](crate::NONE).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
#[repr(i32)]
pub enum MeshArray {
    /// The point of the domain that each point is, of equal ones the first; none for Steiner points.
    PointOrigins = sys::MGDT_MESH_ARRAY_POINT_ORIGINS,
    /// Four corners for each tetrahedron.
    Tetrahedra = sys::MGDT_MESH_ARRAY_TETRAHEDRA,
    /// The four tetrahedra opposite the corners of each; none where the domain ends.
    Neighbors = sys::MGDT_MESH_ARRAY_NEIGHBORS,
    /// The region of each tetrahedron.
    TetrahedronRegions = sys::MGDT_MESH_ARRAY_TETRAHEDRON_REGIONS,
    /// The marker of each region.
    RegionMarkers = sys::MGDT_MESH_ARRAY_REGION_MARKERS,
    /// Three corners for each face of the mesh that is a part of a facet.
    Faces = sys::MGDT_MESH_ARRAY_FACES,
    /// The two tetrahedra at each face, or none.
    FaceTetrahedra = sys::MGDT_MESH_ARRAY_FACE_TETRAHEDRA,
    /// The facet that each face is a part of.
    FaceFacets = sys::MGDT_MESH_ARRAY_FACE_FACETS,
    /// The marker of this facet.
    FaceMarkers = sys::MGDT_MESH_ARRAY_FACE_MARKERS,
    /// Two ends for each edge of the mesh that is a part of a segment or of an edge of facets.
    Edges = sys::MGDT_MESH_ARRAY_EDGES,
    /// The segment that was set, and that each of these is a part of, or none.
    EdgeSegments = sys::MGDT_MESH_ARRAY_EDGE_SEGMENTS,
    /// The marker of this segment, or 0.
    EdgeMarkers = sys::MGDT_MESH_ARRAY_EDGE_MARKERS,
    /// The two ends of the edge that each Steiner point divides.
    SteinerEdges = sys::MGDT_MESH_ARRAY_STEINER_EDGES,
}

/// Arrays of doubles of a [`Mesh`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
#[repr(i32)]
pub enum MeshDoubles {
    /// Three coordinates of each point: those that were set, then the Steiner points.
    Points = sys::MGDT_MESH_ARRAY_POINTS,
    /// For each Steiner point the t for which it is a + t (b - a).
    SteinerParameters = sys::MGDT_MESH_ARRAY_STEINER_PARAMETERS,
}

/// Statistics of a [`Mesh`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
#[repr(i32)]
pub enum MeshStatistic {
    /// Points, Steiner points included.
    Points = sys::MGDT_MESH_STAT_POINTS,
    /// Points that the library has added.
    SteinerPoints = sys::MGDT_MESH_STAT_STEINER_POINTS,
    /// Tetrahedra.
    Tetrahedra = sys::MGDT_MESH_STAT_TETRAHEDRA,
    /// Regions.
    Regions = sys::MGDT_MESH_STAT_REGIONS,
    /// Faces that are parts of facets.
    Faces = sys::MGDT_MESH_STAT_FACES,
    /// Edges that are parts of segments or of edges of facets.
    Edges = sys::MGDT_MESH_STAT_EDGES,
    /// Memory that the mesh holds, in bytes.
    MemoryBytes = sys::MGDT_MESH_STAT_MEMORY_BYTES,
    /// Coordinates are rounded to multiples of 2^-bits of the largest one.
    GridBits = sys::MGDT_MESH_STAT_GRID_BITS,
    /// Points that were set and are neither a corner of a tetrahedron nor equal to one.
    UnusedPoints = sys::MGDT_MESH_STAT_UNUSED_POINTS,
    /// Faces at which there is no tetrahedron: their facets bound nothing and are outside.
    UnusedFaces = sys::MGDT_MESH_STAT_UNUSED_FACES,
    /// Places of regions in no region of the mesh.
    UnusedRegions = sys::MGDT_MESH_STAT_UNUSED_REGIONS,
    /// Holes in nothing that the facets enclose.
    UnusedHoles = sys::MGDT_MESH_STAT_UNUSED_HOLES,
    /// Facets, where those in one plane are joined.
    PlanarFacets = sys::MGDT_MESH_STAT_PLANAR_FACETS,
    /// Of these, those that the Delaunay triangulation of all points lacks.
    MissingFacets = sys::MGDT_MESH_STAT_MISSING_FACETS,
    /// Parts of it that were filled anew.
    Cavities = sys::MGDT_MESH_STAT_CAVITIES,
    /// The most tetrahedra in one of them.
    LargestCavity = sys::MGDT_MESH_STAT_LARGEST_CAVITY,
}

/// A mesh of tetrahedra, which [`Domain::build`](crate::Domain::build) makes and which outlives the
/// domain. Since 1.3.
///
/// `mgdt/mgdt_mesh.h` says what its arrays have.
pub struct Mesh {
    m: ptr::NonNull<sys::mgdt_mesh>,
}

// A handle is bound to no thread. What takes &self passes a const pointer, which the library allows
// from many threads at once.
unsafe impl Send for Mesh {}
unsafe impl Sync for Mesh {}

impl Drop for Mesh {
    fn drop(&mut self) {
        unsafe { sys::mgdt_mesh_destroy(self.m.as_ptr()) };
    }
}

impl fmt::Debug for Mesh {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Mesh")
            .field("tetrahedra", &self.statistic(MeshStatistic::Tetrahedra))
            .field("regions", &self.statistic(MeshStatistic::Regions))
            .finish()
    }
}

impl Keyed for Mesh {
    type Handle = sys::mgdt_mesh;
    const CALLS: Calls<sys::mgdt_mesh> = Calls {
        get_error: sys::mgdt_mesh_get_error,
        set_option: Some(sys::mgdt_mesh_set_option),
        get_stat: sys::mgdt_mesh_get_stat,
        get_size: sys::mgdt_mesh_get_size,
        get_array: sys::mgdt_mesh_get_array,
        get_doubles: Some(sys::mgdt_mesh_get_doubles),
    };

    fn raw(&self) -> *mut sys::mgdt_mesh {
        self.m.as_ptr()
    }
}

impl Mesh {
    /// Takes ownership of a handle.
    pub(crate) fn of_raw(out: *mut sys::mgdt_mesh) -> Result<Mesh, Error> {
        match ptr::NonNull::new(out) {
            Some(m) => Ok(Mesh { m }),
            None => Err(Error::new(ErrorKind::Internal, "there is no mesh")),
        }
    }

    /// Sets how many threads a call may use; 0 for all cores.
    pub fn set_threads(&mut self, threads: usize) -> Result<(), Error> {
        self.set_option(sys::MGDT_MESH_OPTION_THREADS, as_i64(threads))
    }

    /// Limits the memory that the mesh may hold, in bytes; None for no limit.
    pub fn set_memory_limit(&mut self, bytes: Option<usize>) -> Result<(), Error> {
        self.set_limit(sys::MGDT_MESH_OPTION_MEMORY_LIMIT, bytes)
    }

    /// Proves the mesh by itself, exactly; [`Domain::check`](crate::Domain::check) compares it with
    /// what was set.
    pub fn check(&self) -> Result<(), Error> {
        self.ensure(unsafe { sys::mgdt_mesh_check(self.raw()) })
    }

    /// One number of the mesh.
    pub fn statistic(&self, statistic: MeshStatistic) -> usize {
        // It fails for unknown keys alone.
        self.stat(statistic as i32).unwrap_or(0) as usize
    }

    /// Whether the points that are returned are rounded.
    pub fn is_rounded(&self) -> bool {
        self.stat(sys::MGDT_MESH_STAT_IS_ROUNDED) == Ok(1)
    }

    /// An array of integers.
    pub fn array(&self, array: MeshArray) -> Result<Vec<i64>, Error> {
        self.integers(array as i32)
    }

    /// An array of doubles.
    pub fn doubles(&self, array: MeshDoubles) -> Result<Vec<f64>, Error> {
        self.real_numbers(array as i32)
    }

    /// Positions of the points: those that were set, then the Steiner points.
    pub fn points(&self) -> Result<Vec<[f64; 3]>, Error> {
        self.rows(sys::MGDT_MESH_ARRAY_POINTS)
    }

    /// Corners of the tetrahedra.
    pub fn tetrahedra(&self) -> Result<Vec<[usize; 4]>, Error> {
        let corners = self.array(MeshArray::Tetrahedra)?;
        let row = |v: &[i64]| [v[0] as usize, v[1] as usize, v[2] as usize, v[3] as usize];
        Ok(corners.chunks_exact(4).map(row).collect())
    }

    /// Corners of the faces that are parts of facets.
    pub fn faces(&self) -> Result<Vec<[usize; 3]>, Error> {
        let corners = self.array(MeshArray::Faces)?;
        let row = |v: &[i64]| [v[0] as usize, v[1] as usize, v[2] as usize];
        Ok(corners.chunks_exact(3).map(row).collect())
    }

    /// A measure of each tetrahedron.
    pub fn tetrahedron_measures(&self, measure: TetrahedronMeasure) -> Result<Vec<f64>, Error> {
        let mut values = vec![0.0; self.statistic(MeshStatistic::Tetrahedra)];
        let room = as_i64(values.len());
        self.ensure(unsafe {
            sys::mgdt_mesh_get_tetrahedron_measures(
                self.raw(),
                measure as i32,
                room,
                values.as_mut_ptr(),
            )
        })?;
        Ok(values)
    }
}
