// SPDX-License-Identifier: MIT
//! Voronoi diagrams.

use crate::triangulation::{as_i64, error_of};
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
    FaceOffsets = sys::MGDT_VORONOI_FACE_OFFSETS,
    /// The corners of each face, counter-clockwise about its normal: vertices, and rays, which are
    /// negative: ray k is -1 - k.
    FaceCorners = sys::MGDT_VORONOI_FACE_CORNERS,
    /// The two points of each face; plane k of the region is -1 - k.
    FaceSides = sys::MGDT_VORONOI_FACE_SIDES,
    /// Of a periodic box, how often each vector is added to the second point of each face.
    FaceImages = sys::MGDT_VORONOI_FACE_IMAGES,
    /// The vertex where each ray begins.
    RayVertices = sys::MGDT_VORONOI_RAY_VERTICES,
    /// Offsets of the cells' lists of faces, for each point that was inserted.
    CellOffsets = sys::MGDT_VORONOI_CELL_OFFSETS,
    /// The faces of each cell.
    CellFaces = sys::MGDT_VORONOI_CELL_FACES,
    /// For each point 1 if it has a bounded cell, otherwise 0.
    CellBounded = sys::MGDT_VORONOI_CELL_BOUNDED,
    /// For each face of each cell what is on its other side: a point; plane k of the region is -1 - k.
    CellNeighbors = sys::MGDT_VORONOI_CELL_NEIGHBORS,
    /// Of a periodic box, how often each vector is added to each of these points.
    CellNeighborImages = sys::MGDT_VORONOI_CELL_NEIGHBOR_IMAGES,
}

/// Arrays of numbers of a [`Voronoi`] diagram.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
#[repr(i32)]
pub enum VoronoiNumbers {
    /// Coordinates of the vertices, three for each.
    Vertices = sys::MGDT_VORONOI_VERTICES,
    /// Unit vectors of the rays, three numbers for each.
    RayDirections = sys::MGDT_VORONOI_RAY_DIRECTIONS,
    /// Areas of the faces.
    FaceAreas = sys::MGDT_VORONOI_FACE_AREAS,
    /// Unit normals of the faces, from the first side to the second one, three numbers for each.
    FaceNormals = sys::MGDT_VORONOI_FACE_NORMALS,
    /// Centroids of the faces, three numbers for each.
    FaceCentroids = sys::MGDT_VORONOI_FACE_CENTROIDS,
    /// Volumes of the cells.
    CellVolumes = sys::MGDT_VORONOI_CELL_VOLUMES,
    /// Centroids of the cells, three numbers for each.
    CellCentroids = sys::MGDT_VORONOI_CELL_CENTROIDS,
    /// The area of each face of each cell.
    CellFaceAreas = sys::MGDT_VORONOI_CELL_FACE_AREAS,
    /// The distance of each cell's point from the other side of each face.
    CellNeighborDistances = sys::MGDT_VORONOI_CELL_NEIGHBOR_DISTANCES,
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
        let size = |key| self.size(key).unwrap_or(0);
        f.debug_struct("Voronoi")
            .field("vertices", &(size(sys::MGDT_VORONOI_VERTICES) / 3))
            .field("faces", &size(sys::MGDT_VORONOI_FACE_AREAS))
            .finish()
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

    fn ensure(&self, status: sys::mgdt_status) -> Result<(), Error> {
        if status == sys::MGDT_OK {
            return Ok(());
        }
        Err(error_of(status, |capacity, buffer| unsafe {
            sys::mgdt_voronoi_get_error(self.v.as_ptr(), capacity, buffer);
        }))
    }

    fn size(&self, key: i32) -> Result<usize, Error> {
        let mut size = 0;
        self.ensure(unsafe { sys::mgdt_voronoi_get_size(self.v.as_ptr(), key, &mut size) })?;
        Ok(size as usize)
    }

    /// An array of integers.
    pub fn array(&self, array: VoronoiArray) -> Result<Vec<i64>, Error> {
        let mut values = vec![0; self.size(array as i32)?];
        self.ensure(unsafe {
            sys::mgdt_voronoi_get_array(
                self.v.as_ptr(),
                array as i32,
                as_i64(values.len()),
                values.as_mut_ptr(),
            )
        })?;
        Ok(values)
    }

    /// An array of numbers.
    pub fn numbers(&self, array: VoronoiNumbers) -> Result<Vec<f64>, Error> {
        let mut values = vec![0.0; self.size(array as i32)?];
        self.ensure(unsafe {
            sys::mgdt_voronoi_get_doubles(
                self.v.as_ptr(),
                array as i32,
                as_i64(values.len()),
                values.as_mut_ptr(),
            )
        })?;
        Ok(values)
    }

    /// Positions of the vertices.
    pub fn vertices(&self) -> Result<Vec<[f64; 3]>, Error> {
        let numbers = self.numbers(VoronoiNumbers::Vertices)?;
        Ok(numbers.chunks(3).map(|x| [x[0], x[1], x[2]]).collect())
    }

    /// Leaves out the faces with less area than `area`, and those with less than `share` of the
    /// area of each of their cells.
    pub fn drop_small_faces(&mut self, area: f64, share: f64) -> Result<(), Error> {
        self.ensure(unsafe { sys::mgdt_voronoi_drop_small_faces(self.v.as_ptr(), area, share) })
    }
}
