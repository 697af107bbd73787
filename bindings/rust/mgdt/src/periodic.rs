// SPDX-License-Identifier: MIT
//! Points in periodic boxes.

use crate::triangulation::{as_i64, error_of, status_text, watched};
use crate::{Error, ErrorKind, Measure, Voronoi};
use mgdt_sys as sys;
use std::fmt;
use std::ops::ControlFlow;
use std::ptr;

/// Arrays of integers of a [`Periodic`] box. In them "none" is [`NONE`](crate::NONE). Arrays of
/// offsets have three numbers for each: how often each vector is added.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
#[repr(i32)]
pub enum PeriodicArray {
    /// For each point the least point with the same images.
    PointMap = sys::MGDT_PERIODIC_ARRAY_POINT_MAP,
    /// The offset of that point's image that is the point.
    PointOffsets = sys::MGDT_PERIODIC_ARRAY_POINT_OFFSETS,
    /// Four corners for each class of tetrahedra.
    Tetrahedra = sys::MGDT_PERIODIC_ARRAY_TETRAHEDRA,
    /// The offset of each corner.
    Offsets = sys::MGDT_PERIODIC_ARRAY_OFFSETS,
    /// The four tetrahedra opposite the corners; none where a slab or a wire ends.
    Neighbors = sys::MGDT_PERIODIC_ARRAY_NEIGHBORS,
    /// The offset by which each of these is moved.
    NeighborOffsets = sys::MGDT_PERIODIC_ARRAY_NEIGHBOR_OFFSETS,
    /// Where the list of each point's neighbours begins, and the end.
    VertexNeighborStarts = sys::MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBOR_STARTS,
    /// The points at the other ends of the edges at each vertex.
    VertexNeighbors = sys::MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBORS,
    /// The offset of each of these images.
    VertexNeighborOffsets = sys::MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBOR_OFFSETS,
}

/// Single numbers of a [`Periodic`] box.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
#[repr(i32)]
pub enum PeriodicCount {
    /// Points that were inserted.
    GivenPoints = sys::MGDT_PERIODIC_GIVEN_POINTS,
    /// Memory that the box holds, in bytes.
    MemoryBytes = sys::MGDT_PERIODIC_MEMORY_BYTES,
    /// The number of vectors.
    Dimensions = sys::MGDT_PERIODIC_DIMENSIONS,
    /// Points without equal images.
    Vertices = sys::MGDT_PERIODIC_VERTICES,
    /// Classes of tetrahedra.
    Tetrahedra = sys::MGDT_PERIODIC_TETRAHEDRA,
    /// Classes of edges.
    Edges = sys::MGDT_PERIODIC_EDGES,
    /// Images that were triangulated with the points.
    Images = sys::MGDT_PERIODIC_IMAGES,
    /// Rounds in which these were found.
    Rounds = sys::MGDT_PERIODIC_ROUNDS,
}

/// Points in a periodic box, a slab or a wire, and the triangulation of the infinite set of their
/// images. Since 1.3.
///
/// ```
/// # fn main() -> Result<(), mgdt::Error> {
/// let mut p = mgdt::Periodic::new(&[[2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 2.0]])?;
/// p.insert(&[[0.0; 3], [1.0; 3]])?;
/// p.build()?;
/// assert_eq!(p.tetrahedra()?.len(), 12);
/// assert_eq!(p.cell_measures(mgdt::Measure::Faces)?, [14.0, 14.0]);
/// # Ok(())
/// # }
/// ```
///
/// `mgdt/mgdt_periodic.h` says what goes in and comes out.
pub struct Periodic {
    p: ptr::NonNull<sys::mgdt_periodic>,
}

// A handle is bound to no thread. What takes &self passes a const pointer, which the library allows
// from many threads at once.
unsafe impl Send for Periodic {}
unsafe impl Sync for Periodic {}

impl Drop for Periodic {
    fn drop(&mut self) {
        unsafe { sys::mgdt_periodic_destroy(self.p.as_ptr()) };
    }
}

impl fmt::Debug for Periodic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let count = |count| self.count(count).unwrap_or(0);
        f.debug_struct("Periodic")
            .field("points", &count(PeriodicCount::GivenPoints))
            .field("tetrahedra", &count(PeriodicCount::Tetrahedra))
            .finish()
    }
}

impl Periodic {
    /// A box of one to three vectors, without points.
    pub fn new(vectors: &[[f64; 3]]) -> Result<Periodic, Error> {
        if vectors.is_empty() || vectors.len() > 3 {
            return Err(Error::new(
                ErrorKind::InvalidArgument,
                format!("there are {} vectors; there must be one to three", vectors.len()),
            ));
        }
        let mut out = ptr::null_mut();
        let status = unsafe {
            sys::mgdt_periodic_create(vectors.len() as i32, vectors.as_ptr().cast(), &mut out)
        };
        match ptr::NonNull::new(out) {
            Some(p) if status == sys::MGDT_OK => Ok(Periodic { p }),
            _ if status == sys::MGDT_ERR_INVALID_ARGUMENT => Err(Error::of_status(
                status,
                "the vectors of the box do not span, or hardly".to_string(),
            )),
            _ => Err(Error::of_status(status, status_text(status))),
        }
    }

    fn raw(&self) -> *mut sys::mgdt_periodic {
        self.p.as_ptr()
    }

    fn ensure(&self, status: sys::mgdt_status) -> Result<(), Error> {
        if status == sys::MGDT_OK {
            return Ok(());
        }
        Err(error_of(status, |capacity, buffer| unsafe {
            sys::mgdt_periodic_get_error(self.raw(), capacity, buffer);
        }))
    }

    fn set_option(&mut self, option: i32, value: i64) -> Result<(), Error> {
        let status = unsafe { sys::mgdt_periodic_set_option(self.raw(), option, value) };
        self.ensure(status)
    }

    /// Sets how many threads a call may use; 0 for all cores.
    pub fn set_threads(&mut self, threads: usize) -> Result<(), Error> {
        self.set_option(sys::MGDT_PERIODIC_THREADS, as_i64(threads))
    }

    /// Sets the distance within which points become equal in later builds; 0 for none.
    pub fn set_merge_distance(&mut self, distance: f64) -> Result<(), Error> {
        let status = unsafe { sys::mgdt_periodic_set_merge_distance(self.raw(), distance) };
        self.ensure(status)
    }

    /// Limits the memory that the box may hold, in bytes; None for no limit.
    pub fn set_memory_limit(&mut self, bytes: Option<usize>) -> Result<(), Error> {
        // No limit is 0 there; a limit of 0 would be none at all.
        let limit = bytes.map_or(0, |bytes| as_i64(bytes.max(1)));
        self.set_option(sys::MGDT_PERIODIC_MEMORY_LIMIT, limit)
    }

    /// Inserts points, anywhere. The triangulation is removed.
    pub fn insert(&mut self, points: &[[f64; 3]]) -> Result<(), Error> {
        let status = unsafe {
            sys::mgdt_periodic_insert_points(
                self.raw(),
                as_i64(points.len()),
                points.as_ptr().cast(),
            )
        };
        self.ensure(status)
    }

    /// Moves all points, as in a time step. The next build starts with the images that the last one
    /// needed.
    pub fn move_all(&mut self, to: &[[f64; 3]]) -> Result<(), Error> {
        let status = unsafe {
            sys::mgdt_periodic_move_points(
                self.raw(),
                as_i64(to.len()),
                ptr::null(),
                to.as_ptr().cast(),
            )
        };
        self.ensure(status)
    }

    /// Moves some points.
    pub fn move_points(&mut self, points: &[usize], to: &[[f64; 3]]) -> Result<(), Error> {
        if points.len() != to.len() {
            return Err(Error::new(
                ErrorKind::InvalidArgument,
                format!("{} points move to {} places", points.len(), to.len()),
            ));
        }
        if points.is_empty() {
            return Ok(());
        }
        let listed: Vec<i64> = points.iter().map(|&k| as_i64(k)).collect();
        let status = unsafe {
            sys::mgdt_periodic_move_points(
                self.raw(),
                as_i64(to.len()),
                listed.as_ptr(),
                to.as_ptr().cast(),
            )
        };
        self.ensure(status)
    }

    /// Removes the points and the triangulation; what else was set stays.
    pub fn clear(&mut self) {
        // It fails for NULL alone.
        unsafe { sys::mgdt_periodic_clear(self.raw()) };
    }

    /// Triangulates the points.
    pub fn build(&mut self) -> Result<(), Error> {
        let status = unsafe { sys::mgdt_periodic_build(self.raw()) };
        self.ensure(status)
    }

    /// The same with a closure that hears of progress, as
    /// [`insert_with_progress`](crate::Triangulation::insert_with_progress) has it.
    pub fn build_with_progress<F>(&mut self, progress: F) -> Result<(), Error>
    where
        F: FnMut(f64) -> ControlFlow<()>,
    {
        let p = self.raw();
        let status = watched(progress, |report, user| unsafe {
            sys::mgdt_periodic_set_progress(p, Some(report), user);
            let status = sys::mgdt_periodic_build(p);
            sys::mgdt_periodic_set_progress(p, None, ptr::null_mut());
            status
        });
        self.ensure(status)
    }

    /// Proves the triangulation, exactly.
    pub fn check(&self) -> Result<(), Error> {
        self.ensure(unsafe { sys::mgdt_periodic_check(self.raw()) })
    }

    /// One number of the box.
    pub fn count(&self, count: PeriodicCount) -> Result<usize, Error> {
        let mut value = 0;
        self.ensure(unsafe { sys::mgdt_periodic_get_stat(self.raw(), count as i32, &mut value) })?;
        Ok(value as usize)
    }

    fn size(&self, key: i32) -> Result<usize, Error> {
        let mut size = 0;
        self.ensure(unsafe { sys::mgdt_periodic_get_size(self.raw(), key, &mut size) })?;
        Ok(size as usize)
    }

    /// An array of integers.
    pub fn array(&self, array: PeriodicArray) -> Result<Vec<i64>, Error> {
        let key = array as i32;
        let mut values = vec![0; self.size(key)?];
        self.ensure(unsafe {
            sys::mgdt_periodic_get_array(self.raw(), key, as_i64(values.len()), values.as_mut_ptr())
        })?;
        Ok(values)
    }

    fn rows(&self, key: i32) -> Result<Vec<[f64; 3]>, Error> {
        let mut values = vec![[0.0; 3]; self.size(key)? / 3];
        self.ensure(unsafe {
            sys::mgdt_periodic_get_doubles(
                self.raw(),
                key,
                as_i64(3 * values.len()),
                values.as_mut_ptr().cast(),
            )
        })?;
        Ok(values)
    }

    /// The points, where they were put, rounded.
    pub fn points(&self) -> Result<Vec<[f64; 3]>, Error> {
        self.rows(sys::MGDT_PERIODIC_ARRAY_POINTS)
    }

    /// The vectors, rounded.
    pub fn vectors(&self) -> Result<Vec<[f64; 3]>, Error> {
        self.rows(sys::MGDT_PERIODIC_ARRAY_VECTORS)
    }

    /// Corners of the tetrahedra: points.
    pub fn tetrahedra(&self) -> Result<Vec<[usize; 4]>, Error> {
        let corners = self.array(PeriodicArray::Tetrahedra)?;
        let row = |v: &[i64]| [v[0] as usize, v[1] as usize, v[2] as usize, v[3] as usize];
        Ok(corners.chunks_exact(4).map(row).collect())
    }

    /// The offset of each corner.
    pub fn offsets(&self) -> Result<Vec<[[i64; 3]; 4]>, Error> {
        let numbers = self.array(PeriodicArray::Offsets)?;
        let corner = |v: &[i64]| [v[0], v[1], v[2]];
        let row = |v: &[i64]| {
            [
                corner(&v[0..]),
                corner(&v[3..]),
                corner(&v[6..]),
                corner(&v[9..]),
            ]
        };
        Ok(numbers.chunks_exact(12).map(row).collect())
    }

    /// A measure of the cell of each point; three numbers for each centroid, from the point.
    pub fn cell_measures(&self, measure: Measure) -> Result<Vec<f64>, Error> {
        let width = if measure == Measure::Centroid { 3 } else { 1 };
        let mut values = vec![0.0; width * self.count(PeriodicCount::GivenPoints)?];
        self.ensure(unsafe {
            sys::mgdt_periodic_get_cell_measures(
                self.raw(),
                measure as i32,
                as_i64(values.len()),
                values.as_mut_ptr(),
            )
        })?;
        Ok(values)
    }

    /// The Voronoi diagram of the points. Each cell is where its point is;
    /// [`FaceImages`](crate::VoronoiArray::FaceImages) says which images are beyond its faces.
    pub fn voronoi(&self) -> Result<Voronoi, Error> {
        let mut out = ptr::null_mut();
        self.ensure(unsafe { sys::mgdt_periodic_create_voronoi(self.raw(), &mut out) })?;
        Voronoi::of_raw(out)
    }
}
