// SPDX-License-Identifier: MIT
//! Voronoi diagrams.

use crate::keyed::{Calls, Keyed};
use crate::triangulation::as_i64;
use crate::{Error, ErrorKind, Triangulation};
use mgdt_sys as sys;
use std::fmt;
use std::ptr;

/// Arrays of integers of a [`Voronoi`] diagram. An array of offsets has one element more than there
/// are lists: list k is from offsets\[k\] to before offsets\[k + 1\].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
#[repr(i32)]
pub enum VoronoiArray {
    /// Offsets of the faces' lists of corners.
    FaceOffsets = sys::MGDT_VORONOI_ARRAY_FACE_OFFSETS,
    /// The corners of each face, counter-clockwise about its normal: vertices, and rays, which are
    /// negative: ray k is -1 - k.
    FaceCorners = sys::MGDT_VORONOI_ARRAY_FACE_CORNERS,
    /// The two points of each face; plane k of the region is -1 - k.
    FaceSides = sys::MGDT_VORONOI_ARRAY_FACE_SIDES,
    /// Of a periodic box, how often each vector is added to the second point of each face.
    FaceShifts = sys::MGDT_VORONOI_ARRAY_FACE_SHIFTS,
    /// The vertex where each ray begins.
    RayVertices = sys::MGDT_VORONOI_ARRAY_RAY_VERTICES,
    /// Offsets of the cells' lists of faces, for each point that was inserted.
    CellOffsets = sys::MGDT_VORONOI_ARRAY_CELL_OFFSETS,
    /// The faces of each cell.
    CellFaces = sys::MGDT_VORONOI_ARRAY_CELL_FACES,
    /// For each point 1 if it has a bounded cell, otherwise 0.
    CellBounded = sys::MGDT_VORONOI_ARRAY_CELL_BOUNDED,
    /// For each face of each cell what is on its other side: a point; plane k of the region is -1 - k.
    CellNeighbors = sys::MGDT_VORONOI_ARRAY_CELL_NEIGHBORS,
    /// Of a periodic box, how often each vector is added to each of these points.
    CellNeighborShifts = sys::MGDT_VORONOI_ARRAY_CELL_NEIGHBOR_SHIFTS,
}

/// Arrays of doubles of a [`Voronoi`] diagram.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
#[repr(i32)]
pub enum VoronoiDoubles {
    /// Coordinates of the vertices, three for each.
    Vertices = sys::MGDT_VORONOI_ARRAY_VERTICES,
    /// Unit vectors of the rays, three numbers for each.
    RayDirections = sys::MGDT_VORONOI_ARRAY_RAY_DIRECTIONS,
    /// Areas of the faces.
    FaceAreas = sys::MGDT_VORONOI_ARRAY_FACE_AREAS,
    /// Unit normals of the faces, from the first side to the second one, three numbers for each.
    FaceNormals = sys::MGDT_VORONOI_ARRAY_FACE_NORMALS,
    /// Centroids of the faces, three numbers for each.
    FaceCentroids = sys::MGDT_VORONOI_ARRAY_FACE_CENTROIDS,
    /// Volumes of the cells.
    CellVolumes = sys::MGDT_VORONOI_ARRAY_CELL_VOLUMES,
    /// Centroids of the cells, three numbers for each.
    CellCentroids = sys::MGDT_VORONOI_ARRAY_CELL_CENTROIDS,
    /// The area of each face of each cell.
    CellFaceAreas = sys::MGDT_VORONOI_ARRAY_CELL_FACE_AREAS,
    /// The distance of each cell's point from the other side of each face.
    CellNeighborDistances = sys::MGDT_VORONOI_ARRAY_CELL_NEIGHBOR_DISTANCES,
}

/// Statistics of a [`Voronoi`] diagram.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
#[repr(i32)]
pub enum VoronoiStatistic {
    /// Vertices.
    Vertices = sys::MGDT_VORONOI_STAT_VERTICES,
    /// Rays.
    Rays = sys::MGDT_VORONOI_STAT_RAYS,
    /// Faces, without those that were dropped.
    Faces = sys::MGDT_VORONOI_STAT_FACES,
    /// Points that were inserted: the arrays of cells have a row for each.
    Points = sys::MGDT_VORONOI_STAT_POINTS,
    /// Memory that the diagram holds, in bytes.
    MemoryBytes = sys::MGDT_VORONOI_STAT_MEMORY_BYTES,
}

/// The Voronoi diagram of the points of a triangulation or of a periodic box, which it outlives; made
/// by [`Triangulation::voronoi`] or [`Periodic::voronoi`](crate::Periodic::voronoi). Since 1.3.
pub struct Voronoi {
    v: ptr::NonNull<sys::mgdt_voronoi>,
}

// A handle is bound to no thread. What takes &self passes a const pointer, which the library allows
// from many threads at once.
unsafe impl Send for Voronoi {}
unsafe impl Sync for Voronoi {}

impl Drop for Voronoi {
    fn drop(&mut self) {
        unsafe { sys::mgdt_voronoi_destroy(self.v.as_ptr()) };
    }
}

impl fmt::Debug for Voronoi {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Voronoi")
            .field("vertices", &self.statistic(VoronoiStatistic::Vertices))
            .field("faces", &self.statistic(VoronoiStatistic::Faces))
            .finish()
    }
}

impl Keyed for Voronoi {
    type Handle = sys::mgdt_voronoi;
    const CALLS: Calls<sys::mgdt_voronoi> = Calls {
        get_error: sys::mgdt_voronoi_get_error,
        set_option: None,
        set_double_option: None,
        get_stat: sys::mgdt_voronoi_get_stat,
        get_size: sys::mgdt_voronoi_get_size,
        get_array: sys::mgdt_voronoi_get_array,
        get_doubles: Some(sys::mgdt_voronoi_get_doubles),
    };

    fn raw(&self) -> *mut sys::mgdt_voronoi {
        self.v.as_ptr()
    }
}

impl Triangulation {
    /// The Voronoi diagram of the points. Cells are clipped to planes a b c d, where
    /// a x + b y + c z <= d, or not clipped if there are none. Since 1.3.
    pub fn voronoi(&self, planes: &[[f64; 4]]) -> Result<Voronoi, Error> {
        let mut out = ptr::null_mut();
        self.ensure(unsafe {
            sys::mgdt_voronoi_create(
                self.raw(),
                as_i64(planes.len()),
                planes.as_ptr().cast(),
                &mut out,
            )
        })?;
        Voronoi::of_raw(out)
    }
}

impl Voronoi {
    /// Takes ownership of a handle.
    pub(crate) fn of_raw(out: *mut sys::mgdt_voronoi) -> Result<Voronoi, Error> {
        match ptr::NonNull::new(out) {
            Some(v) => Ok(Voronoi { v }),
            None => Err(Error::new(ErrorKind::Internal, "there is no diagram")),
        }
    }

    /// One number of the diagram.
    pub fn statistic(&self, statistic: VoronoiStatistic) -> usize {
        // It fails for unknown keys alone.
        self.stat(statistic as i32).unwrap_or(0) as usize
    }

    /// An array of integers.
    pub fn array(&self, array: VoronoiArray) -> Result<Vec<i64>, Error> {
        self.integers(array as i32)
    }

    /// An array of doubles.
    pub fn doubles(&self, array: VoronoiDoubles) -> Result<Vec<f64>, Error> {
        self.real_numbers(array as i32)
    }

    /// Positions of the vertices.
    pub fn vertices(&self) -> Result<Vec<[f64; 3]>, Error> {
        self.rows(sys::MGDT_VORONOI_ARRAY_VERTICES)
    }

    /// Leaves out the faces with less area than `least_area`, and those with less than
    /// `least_share` of the area of each of their cells.
    pub fn drop_small_faces(&mut self, least_area: f64, least_share: f64) -> Result<(), Error> {
        self.ensure(unsafe { sys::mgdt_voronoi_drop_small_faces(self.raw(), least_area, least_share) })
    }
}
