// SPDX-License-Identifier: MIT
//! Points in periodic boxes.

use crate::keyed::{Calls, Keyed};
use crate::triangulation::{as_i64, status_text, watched};
use crate::{Error, ErrorKind, Measure, Voronoi};
use mgdt_sys as sys;
use std::fmt;
use std::ops::ControlFlow;
use std::ptr;

/// Arrays of integers of a [`Periodic`] box. In them "none" is [`NONE`](crate::NONE). Arrays of
/// shifts have three numbers for each: how often each vector is added.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
#[repr(i32)]
pub enum PeriodicArray {
    /// For each point the least point with the same images.
    PointMap = sys::MGDT_PERIODIC_ARRAY_POINT_MAP,
    /// The shift of that point's image that is the point.
    PointShifts = sys::MGDT_PERIODIC_ARRAY_POINT_SHIFTS,
    /// Four corners for each class of tetrahedra.
    Tetrahedra = sys::MGDT_PERIODIC_ARRAY_TETRAHEDRA,
    /// The shift of each corner.
    TetrahedronShifts = sys::MGDT_PERIODIC_ARRAY_TETRAHEDRON_SHIFTS,
    /// The four tetrahedra opposite the corners; none where a slab or a wire ends.
    Neighbors = sys::MGDT_PERIODIC_ARRAY_NEIGHBORS,
    /// The shift by which each of these is moved.
    NeighborShifts = sys::MGDT_PERIODIC_ARRAY_NEIGHBOR_SHIFTS,
    /// Offsets of the lists of each point's neighbours.
    VertexNeighborOffsets = sys::MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBOR_OFFSETS,
    /// The points at the other ends of the edges at each vertex.
    VertexNeighbors = sys::MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBORS,
    /// The shift of each of these images.
    VertexNeighborShifts = sys::MGDT_PERIODIC_ARRAY_VERTEX_NEIGHBOR_SHIFTS,
}

/// Statistics of a [`Periodic`] box.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
#[repr(i32)]
pub enum PeriodicStatistic {
    /// Points that were inserted.
    Points = sys::MGDT_PERIODIC_STAT_POINTS,
    /// Memory that the box holds, in bytes.
    MemoryBytes = sys::MGDT_PERIODIC_STAT_MEMORY_BYTES,
    /// The number of vectors.
    Dimensions = sys::MGDT_PERIODIC_STAT_DIMENSIONS,
    /// Points without equal images.
    Vertices = sys::MGDT_PERIODIC_STAT_VERTICES,
    /// Classes of tetrahedra.
    Tetrahedra = sys::MGDT_PERIODIC_STAT_TETRAHEDRA,
    /// Classes of edges.
    Edges = sys::MGDT_PERIODIC_STAT_EDGES,
    /// Images that were triangulated with the points; may be 0 in later versions.
    Images = sys::MGDT_PERIODIC_STAT_IMAGES,
    /// Rounds in which these were found; may be 0 in later versions.
    Rounds = sys::MGDT_PERIODIC_STAT_ROUNDS,
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
        let count = |count| self.statistic(count).unwrap_or(0);
        f.debug_struct("Periodic")
            .field("points", &count(PeriodicStatistic::Points))
            .field("tetrahedra", &count(PeriodicStatistic::Tetrahedra))
            .finish()
    }
}

impl Keyed for Periodic {
    type Handle = sys::mgdt_periodic;
    const CALLS: Calls<sys::mgdt_periodic> = Calls {
        get_error: sys::mgdt_periodic_get_error,
        set_option: Some(sys::mgdt_periodic_set_option),
        set_double_option: None,
        get_stat: sys::mgdt_periodic_get_stat,
        get_size: sys::mgdt_periodic_get_size,
        get_array: sys::mgdt_periodic_get_array,
        get_doubles: Some(sys::mgdt_periodic_get_doubles),
    };

    fn raw(&self) -> *mut sys::mgdt_periodic {
        self.p.as_ptr()
    }
}

impl Periodic {
    /// A box of one to three vectors, without points.
    pub fn new(vectors: &[[f64; 3]]) -> Result<Periodic, Error> {
        let mut out = ptr::null_mut();
        let status = unsafe { sys::mgdt_periodic_create(&mut out) };
        let mut made = match ptr::NonNull::new(out) {
            Some(p) if status == sys::MGDT_OK => Periodic { p },
            _ => return Err(Error::of_status(status, status_text(status))),
        };
        made.set_vectors(vectors)?;
        Ok(made)
    }

    /// Sets the vectors, in place of earlier ones. The points stay.
    pub fn set_vectors(&mut self, vectors: &[[f64; 3]]) -> Result<(), Error> {
        // C refuses the next number too.
        let count = vectors.len().min(4) as i32;
        let status = unsafe {
            sys::mgdt_periodic_set_vectors(self.raw(), count, vectors.as_ptr().cast())
        };
        self.ensure(status)
    }

    /// Sets how many threads a call may use; 0 for all cores.
    pub fn set_threads(&mut self, threads: usize) -> Result<(), Error> {
        self.set_option(sys::MGDT_PERIODIC_OPTION_THREADS, as_i64(threads))
    }

    /// Sets the distance within which points become equal in later builds; 0 for none.
    pub fn set_merge_distance(&mut self, distance: f64) -> Result<(), Error> {
        let status = unsafe { sys::mgdt_periodic_set_merge_distance(self.raw(), distance) };
        self.ensure(status)
    }

    /// Limits the memory that the box may hold, in bytes; None for no limit.
    pub fn set_memory_limit(&mut self, bytes: Option<usize>) -> Result<(), Error> {
        self.set_limit(sys::MGDT_PERIODIC_OPTION_MEMORY_LIMIT, bytes)
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
    pub fn statistic(&self, statistic: PeriodicStatistic) -> Result<usize, Error> {
        Ok(self.stat(statistic as i32)? as usize)
    }

    /// An array of integers.
    pub fn array(&self, array: PeriodicArray) -> Result<Vec<i64>, Error> {
        self.integers(array as i32)
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

    /// The shift of each corner.
    pub fn shifts(&self) -> Result<Vec<[[i64; 3]; 4]>, Error> {
        let numbers = self.array(PeriodicArray::TetrahedronShifts)?;
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
        let mut values = vec![0.0; width * self.statistic(PeriodicStatistic::Points)?];
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
    /// [`FaceShifts`](crate::VoronoiArray::FaceShifts) says which images are beyond its faces.
    pub fn voronoi(&self) -> Result<Voronoi, Error> {
        let mut out = ptr::null_mut();
        self.ensure(unsafe { sys::mgdt_periodic_create_voronoi(self.raw(), &mut out) })?;
        Voronoi::of_raw(out)
    }
}
