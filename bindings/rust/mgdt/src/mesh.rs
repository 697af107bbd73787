// SPDX-License-Identifier: MIT
//! Meshes of tetrahedra.

use crate::keyed::{Calls, Keyed};
use crate::domain::ensure_markers;
use crate::triangulation::{as_i64, status_text, watched};
use crate::{Error, ErrorKind, TetrahedronMeasure};
use mgdt_sys as sys;
use std::any::Any;
use std::ffi::c_void;
use std::fmt;
use std::ops::ControlFlow;
use std::panic::{catch_unwind, resume_unwind, AssertUnwindSafe};
use std::ptr;
use std::slice;

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
    /// Why each tetrahedron is below the goal of the last improvement, a [`Reason`] as a number. Since 1.4.
    Reasons = sys::MGDT_MESH_ARRAY_REASONS,
    /// 18 rows, before and after the improvement: how many dihedral angles are from 0 to 10 degrees, 10 to 20
    /// and so on. Since 1.4.
    AngleHistogram = sys::MGDT_MESH_ARRAY_ANGLE_HISTOGRAM,
    /// Six rows, before and after: how many tetrahedra have an angle below 5, 10, 15, 20, 25 and 30 degrees.
    /// Since 1.4.
    TetrahedraBelow = sys::MGDT_MESH_ARRAY_TETRAHEDRA_BELOW,
    /// Why the last refinement has not divided each tetrahedron, a [`Refusal`] as a number. Since 1.4.
    Refusals = sys::MGDT_MESH_ARRAY_REFUSALS,
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
    /// Three rows, before and after the improvement: the least and the largest dihedral angle, in degrees,
    /// and the mean shape. Since 1.4.
    Shapes = sys::MGDT_MESH_ARRAY_SHAPES,
    /// For each point the size of edges that the last refinement has wanted there, or 0. Since 1.4.
    Sizes = sys::MGDT_MESH_ARRAY_SIZES,
}

/// What an improvement may do to faces and edges that the mesh lists. Since 1.4.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
#[repr(i32)]
pub enum Boundary {
    /// They stay as they are.
    Fixed = sys::MGDT_BOUNDARY_FIXED,
    /// The surface stays, but its points move within facets and along straight edges.
    Slide = sys::MGDT_BOUNDARY_SLIDE,
}

/// What an improvement may do to the points that were set. Since 1.4.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
#[repr(i32)]
pub enum GivenPoints {
    /// They stay where they are.
    Keep = sys::MGDT_POINTS_KEEP,
    /// They may move.
    Move = sys::MGDT_POINTS_MOVE,
    /// They may move, and may become points of no tetrahedron.
    Remove = sys::MGDT_POINTS_REMOVE,
}

/// Why a tetrahedron is below the goal of an improvement. Since 1.4.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
#[repr(i32)]
pub enum Reason {
    /// It reaches the goal.
    None = sys::MGDT_REASON_NONE,
    /// Two of its faces are parts of facets with a smaller angle between them.
    InputAngle = sys::MGDT_REASON_INPUT_ANGLE,
    /// It is at a corner of a face of a facet that has a smaller angle itself.
    ThinFace = sys::MGDT_REASON_THIN_FACE,
    /// None of its corners may move.
    FixedCorners = sys::MGDT_REASON_FIXED_CORNERS,
    /// Anything else.
    Other = sys::MGDT_REASON_OTHER,
}

/// What [`Mesh::set_sizes`] sets sizes of. Since 1.4.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
#[repr(i32)]
pub enum SizesOf {
    /// Each point of the mesh.
    Points = sys::MGDT_SIZES_OF_POINTS,
    /// Each tetrahedron.
    Tetrahedra = sys::MGDT_SIZES_OF_TETRAHEDRA,
    /// Each region.
    Regions = sys::MGDT_SIZES_OF_REGIONS,
}

/// Why a refinement has not divided a tetrahedron. Since 1.4.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
#[repr(i32)]
pub enum Refusal {
    /// It is within the sizes and bounds.
    None = sys::MGDT_REFUSAL_NONE,
    /// A face of a facet is between it and the point that would divide it.
    Hidden = sys::MGDT_REFUSAL_HIDDEN,
    /// That point is too near to another one.
    NearPoint = sys::MGDT_REFUSAL_NEAR_POINT,
    /// That point is near a facet, and would leave as many tetrahedra beyond the bounds.
    NearFacet = sys::MGDT_REFUSAL_NEAR_FACET,
    /// Around that point is no place for tetrahedra with a positive volume.
    NoCavity = sys::MGDT_REFUSAL_NO_CAVITY,
    /// The most points were inserted.
    MostPoints = sys::MGDT_REFUSAL_MOST_POINTS,
}

/// The shapes of all tetrahedra of a [`Mesh`]. Since 1.4.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct ShapeSummary {
    /// The least dihedral angle, in degrees.
    pub least_angle: f64,
    /// The largest dihedral angle, in degrees.
    pub largest_angle: f64,
    /// The mean of [`TetrahedronMeasure::VolumeLength`].
    pub mean_shape: f64,
    /// Dihedral angles from 0 to 10 degrees, 10 to 20 and so on.
    pub angles: [i64; 18],
    /// Tetrahedra with an angle below 5, 10, 15, 20, 25 and 30 degrees.
    pub below: [i64; 6],
}

fn outside(nearest: bool) -> i32 {
    if nearest {
        sys::MGDT_OUTSIDE_BOUNDARY
    } else {
        sys::MGDT_OUTSIDE_NONE
    }
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
    /// Tetrahedra that the last improvement has left below the goal. Since 1.4.
    BelowGoal = sys::MGDT_MESH_STAT_BELOW_GOAL,
    /// Its passes over tetrahedra below the goal. Since 1.4.
    Passes = sys::MGDT_MESH_STAT_PASSES,
    /// Points that were set and that it has moved. Since 1.4.
    MovedPoints = sys::MGDT_MESH_STAT_MOVED_POINTS,
    /// Points that were set and have lost all of their tetrahedra. Since 1.4.
    RemovedPoints = sys::MGDT_MESH_STAT_REMOVED_POINTS,
    /// Points that the last refinement has inserted. Since 1.4.
    InsertedPoints = sys::MGDT_MESH_STAT_INSERTED_POINTS,
    /// Tetrahedra that it has left beyond the sizes and bounds. Since 1.4.
    Refused = sys::MGDT_MESH_STAT_REFUSED,
}

/// A mesh of tetrahedra, which [`Domain::build`](crate::Domain::build) makes and which outlives the
/// domain, or which [`build`](Mesh::build) makes of tetrahedra that were set. Since 1.3.
///
/// ```
/// # fn main() -> Result<(), mgdt::Error> {
/// let mut m = mgdt::Mesh::new()?;
/// m.set_points(&[[0., 0., 0.], [4., 0., 0.], [0., 4., 0.], [0., 0., 4.], [0.2, 0.3, 0.2]])?;
/// m.set_tetrahedra(&[[0, 1, 2, 4], [0, 1, 3, 4], [0, 2, 3, 4], [1, 2, 3, 4]], None)?;
/// m.build()?;
/// m.improve()?;
/// let shapes = m.doubles(mgdt::MeshDoubles::Shapes)?;
/// assert!(shapes[0] < 5. && shapes[1] > 25.);
/// # Ok(())
/// # }
/// ```
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
        set_double_option: Some(sys::mgdt_mesh_set_double_option),
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
    /// Makes a mesh without tetrahedra. Since 1.4.
    pub fn new() -> Result<Mesh, Error> {
        let mut out = ptr::null_mut();
        match unsafe { sys::mgdt_mesh_create(&mut out) } {
            sys::MGDT_OK => Mesh::of_raw(out),
            status => Err(Error::of_status(status, status_text(status))),
        }
    }

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

    /// The goal of [`improve`](Mesh::improve) for the dihedral angles, in degrees up to 70; 25 at first. Since 1.4.
    pub fn set_goal(&mut self, degrees: u32) -> Result<(), Error> {
        self.set_option(sys::MGDT_MESH_OPTION_GOAL, i64::from(degrees))
    }

    /// What [`improve`](Mesh::improve) may do to faces and edges; at first they are fixed. Since 1.4.
    pub fn set_boundary(&mut self, boundary: Boundary) -> Result<(), Error> {
        self.set_option(sys::MGDT_MESH_OPTION_BOUNDARY, boundary as i64)
    }

    /// What [`improve`](Mesh::improve) may do to the points that were set. Since 1.4.
    pub fn set_given_points(&mut self, points: GivenPoints) -> Result<(), Error> {
        self.set_option(sys::MGDT_MESH_OPTION_POINTS, points as i64)
    }

    /// Passes that move all points for the mean of the shapes, such as 3; 0 at first. Since 1.4.
    pub fn set_mean_passes(&mut self, passes: u32) -> Result<(), Error> {
        self.set_option(sys::MGDT_MESH_OPTION_MEAN_PASSES, i64::from(passes))
    }

    /// The most passes over tetrahedra below the goal; 100 at first. Since 1.4.
    pub fn set_most_passes(&mut self, passes: u32) -> Result<(), Error> {
        self.set_option(sys::MGDT_MESH_OPTION_MOST_PASSES, i64::from(passes))
    }

    /// The size of edges that [`refine`](Mesh::refine) wants everywhere; 0 (at first) for none. Since 1.4.
    pub fn set_size(&mut self, size: f64) -> Result<(), Error> {
        self.set_double_option(sys::MGDT_MESH_OPTION_SIZE, size)
    }

    /// How fast sizes may grow with the distance; 0.3 at first. Since 1.4.
    pub fn set_gradation(&mut self, gradation: f64) -> Result<(), Error> {
        self.set_double_option(sys::MGDT_MESH_OPTION_GRADATION, gradation)
    }

    /// The most that a circumradius should be, in shortest edges: 1.4 at first, 0 for no bound. Since 1.4.
    pub fn set_radius_edge(&mut self, ratio: f64) -> Result<(), Error> {
        self.set_double_option(sys::MGDT_MESH_OPTION_RADIUS_EDGE, ratio)
    }

    /// The most volume that a tetrahedron should have; 0 (at first) for no bound. Since 1.4.
    pub fn set_volume(&mut self, volume: f64) -> Result<(), Error> {
        self.set_double_option(sys::MGDT_MESH_OPTION_VOLUME, volume)
    }

    /// Whether edges of the surface say how long those at their ends should be. Since 1.4.
    pub fn set_sizes_of_surface(&mut self, of_surface: bool) -> Result<(), Error> {
        self.set_option(sys::MGDT_MESH_OPTION_SIZES_OF_SURFACE, i64::from(of_surface))
    }

    /// The most points that one refinement inserts; 0 (at first) for no limit. Since 1.4.
    pub fn set_most_points(&mut self, points: u32) -> Result<(), Error> {
        self.set_option(sys::MGDT_MESH_OPTION_MOST_POINTS, i64::from(points))
    }

    /// Sets sizes of edges for the next [`refine`](Mesh::refine): one for each point, tetrahedron or region, 0 for
    /// none. An empty slice removes them. Since 1.4.
    pub fn set_sizes(&mut self, of: SizesOf, sizes: &[f64]) -> Result<(), Error> {
        self.ensure(unsafe {
            sys::mgdt_mesh_set_sizes(self.raw(), of as i32, as_i64(sizes.len()), sizes.as_ptr())
        })
    }

    /// Sets sizes of edges at points in space, which need not be points of the mesh: linear between
    /// them. Without points there are no such sizes. Since 1.4.
    pub fn set_size_field(&mut self, points: &[[f64; 3]], sizes: &[f64]) -> Result<(), Error> {
        if sizes.len() != points.len() {
            return Err(Error::new(ErrorKind::InvalidArgument, "there is not one size for each point"));
        }
        self.ensure(unsafe {
            sys::mgdt_mesh_set_size_field(
                self.raw(),
                as_i64(points.len()),
                points.as_ptr().cast(),
                sizes.as_ptr(),
            )
        })
    }

    /// Sets the points. Tetrahedra, faces, edges and fixed points that were set before are removed. Since 1.4.
    pub fn set_points(&mut self, points: &[[f64; 3]]) -> Result<(), Error> {
        self.ensure(unsafe {
            sys::mgdt_mesh_set_points(self.raw(), as_i64(points.len()), points.as_ptr().cast())
        })
    }

    /// Sets the tetrahedra. Without markers all are 0; those with one marker form a region. Since 1.4.
    pub fn set_tetrahedra(&mut self, corners: &[[usize; 4]], markers: Option<&[i32]>) -> Result<(), Error> {
        self.set_items(sys::mgdt_mesh_set_tetrahedra, corners, markers)
    }

    /// Sets faces that the mesh keeps. Since 1.4.
    pub fn set_faces(&mut self, corners: &[[usize; 3]], markers: Option<&[i32]>) -> Result<(), Error> {
        self.set_items(sys::mgdt_mesh_set_faces, corners, markers)
    }

    /// Sets edges that the mesh keeps. Since 1.4.
    pub fn set_edges(&mut self, ends: &[[usize; 2]], markers: Option<&[i32]>) -> Result<(), Error> {
        self.set_items(sys::mgdt_mesh_set_edges, ends, markers)
    }

    /// Sets the points that [`improve`](Mesh::improve) leaves where they are. Since 1.4.
    pub fn set_fixed_points(&mut self, points: &[usize]) -> Result<(), Error> {
        let listed: Vec<i64> = points.iter().map(|&k| as_i64(k)).collect();
        self.ensure(unsafe {
            sys::mgdt_mesh_set_fixed_points(self.raw(), as_i64(listed.len()), listed.as_ptr())
        })
    }

    fn set_items<const N: usize>(
        &mut self,
        set: unsafe extern "C" fn(*mut sys::mgdt_mesh, i64, *const i64, *const i32) -> sys::mgdt_status,
        corners: &[[usize; N]],
        markers: Option<&[i32]>,
    ) -> Result<(), Error> {
        let of_items = ensure_markers(markers, corners.len())?;
        let listed: Vec<i64> = corners.iter().flatten().map(|&k| as_i64(k)).collect();
        self.ensure(unsafe { set(self.raw(), as_i64(corners.len()), listed.as_ptr(), of_items) })
    }

    /// Makes the mesh of what was set, in place of the one that there was. Since 1.4.
    pub fn build(&mut self) -> Result<(), Error> {
        self.ensure(unsafe { sys::mgdt_mesh_build(self.raw()) })
    }

    /// Inserts points until the tetrahedra have the wanted sizes and shapes. Since 1.4.
    ///
    /// ```
    /// # fn main() -> Result<(), mgdt::Error> {
    /// let mut m = mgdt::Mesh::new()?;
    /// m.set_points(&[[0., 0., 0.], [4., 0., 0.], [0., 4., 0.], [0., 0., 4.], [1., 1., 1.]])?;
    /// m.set_tetrahedra(&[[0, 1, 2, 4], [0, 1, 3, 4], [0, 2, 3, 4], [1, 2, 3, 4]], None)?;
    /// m.build()?;
    /// m.set_size(0.5)?;
    /// m.refine()?;
    /// assert!(m.statistic(mgdt::MeshStatistic::Tetrahedra) > 4);
    /// # Ok(())
    /// # }
    /// ```
    pub fn refine(&mut self) -> Result<(), Error> {
        self.ensure(unsafe { sys::mgdt_mesh_refine(self.raw()) })
    }

    /// The same with a closure that hears of progress, as
    /// [`insert_with_progress`](crate::Triangulation::insert_with_progress) has it. A mesh whose refinement is
    /// stopped stays as it was. Since 1.4.
    pub fn refine_with_progress<F>(&mut self, progress: F) -> Result<(), Error>
    where
        F: FnMut(f64) -> ControlFlow<()>,
    {
        self.change_with_progress(progress, sys::mgdt_mesh_refine)
    }

    /// The same with a closure that gives the size of edges at a place, 0 for none. A panic of it goes
    /// on here. Since 1.4.
    ///
    /// ```
    /// # fn main() -> Result<(), mgdt::Error> {
    /// let mut m = mgdt::Mesh::new()?;
    /// m.set_points(&[[0., 0., 0.], [4., 0., 0.], [0., 4., 0.], [0., 0., 4.], [1., 1., 1.]])?;
    /// m.set_tetrahedra(&[[0, 1, 2, 4], [0, 1, 3, 4], [0, 2, 3, 4], [1, 2, 3, 4]], None)?;
    /// m.build()?;
    /// m.refine_with_size_function(|place| 0.2 + 0.2 * place[2])?;
    /// assert!(m.statistic(mgdt::MeshStatistic::Tetrahedra) > 4);
    /// # Ok(())
    /// # }
    /// ```
    pub fn refine_with_size_function<F>(&mut self, size: F) -> Result<(), Error>
    where
        F: FnMut(&[f64; 3]) -> f64,
    {
        let mut sizes = Sizes { size, panic: None };
        let user: *mut Sizes<F> = &mut sizes;
        let m = self.raw();
        let status = unsafe {
            sys::mgdt_mesh_set_size_function(m, Some(find_sizes::<F>), user.cast());
            let status = sys::mgdt_mesh_refine(m);
            sys::mgdt_mesh_set_size_function(m, None, ptr::null_mut());
            status
        };
        if let Some(panic) = sizes.panic.take() {
            resume_unwind(panic);
        }
        self.ensure(status)
    }

    /// Improves the tetrahedra until all dihedral angles reach the goal, or nothing helps. Since 1.4.
    pub fn improve(&mut self) -> Result<(), Error> {
        self.ensure(unsafe { sys::mgdt_mesh_improve(self.raw()) })
    }

    /// The same with a closure that hears of progress, as
    /// [`insert_with_progress`](crate::Triangulation::insert_with_progress) has it. A mesh whose improvement is
    /// stopped is better, but not as good as it would be. Since 1.4.
    pub fn improve_with_progress<F>(&mut self, progress: F) -> Result<(), Error>
    where
        F: FnMut(f64) -> ControlFlow<()>,
    {
        self.change_with_progress(progress, sys::mgdt_mesh_improve)
    }

    fn change_with_progress<F>(
        &mut self,
        progress: F,
        change: unsafe extern "C" fn(*mut sys::mgdt_mesh) -> sys::mgdt_status,
    ) -> Result<(), Error>
    where
        F: FnMut(f64) -> ControlFlow<()>,
    {
        let m = self.raw();
        let status = watched(progress, |report, user| unsafe {
            sys::mgdt_mesh_set_progress(m, Some(report), user);
            let status = change(m);
            sys::mgdt_mesh_set_progress(m, None, ptr::null_mut());
            status
        });
        self.ensure(status)
    }

    /// Proves the mesh by itself, exactly; [`Domain::check`](crate::Domain::check) compares it with
    /// what was set.
    pub fn check(&self) -> Result<(), Error> {
        self.ensure(unsafe { sys::mgdt_mesh_check(self.raw()) })
    }

    /// The tetrahedra that contain places, exactly, and the barycentric coordinates there; None outside. With
    /// `nearest`, the nearest place of the boundary stands for a place outside. Since 1.4.
    pub fn locate_points(&self, places: &[[f64; 3]], nearest: bool) -> Result<Vec<Option<(usize, [f64; 4])>>, Error> {
        let mut found = vec![0_i64; places.len()];
        let mut weights = vec![[0.0; 4]; places.len()];
        self.ensure(unsafe {
            sys::mgdt_mesh_locate_points(
                self.raw(),
                outside(nearest),
                as_i64(places.len()),
                places.as_ptr().cast(),
                found.as_mut_ptr(),
                weights.as_mut_ptr().cast(),
            )
        })?;
        let located = |(t, w): (i64, [f64; 4])| usize::try_from(t).ok().map(|t| (t, w));
        Ok(found.into_iter().zip(weights).map(located).collect())
    }

    /// Values at places, `fields` numbers each: linear in each tetrahedron between those at the points; NaN outside,
    /// or with `nearest` the values of the nearest place of the boundary. Since 1.4.
    pub fn interpolate(&self, values: &[f64], fields: usize, places: &[[f64; 3]], nearest: bool) -> Result<Vec<f64>, Error> {
        let needed = fields * self.statistic(MeshStatistic::Points);
        if values.len() != needed {
            let message = format!("there are {} values; there must be {}", values.len(), needed);
            return Err(Error::new(ErrorKind::InvalidArgument, message));
        }
        let mut out = vec![0.0; fields * places.len()];
        self.ensure(unsafe {
            sys::mgdt_mesh_interpolate(
                self.raw(),
                outside(nearest),
                as_i64(fields),
                values.as_ptr(),
                as_i64(places.len()),
                places.as_ptr().cast(),
                out.as_mut_ptr(),
            )
        })?;
        Ok(out)
    }

    /// The shapes of all tetrahedra in a few numbers. Since 1.4.
    pub fn shape_summary(&self) -> Result<ShapeSummary, Error> {
        let mut shapes = [0.0; 3];
        let mut summary = ShapeSummary::default();
        self.ensure(unsafe {
            sys::mgdt_mesh_get_shape_summary(
                self.raw(),
                shapes.as_mut_ptr(),
                summary.angles.as_mut_ptr(),
                summary.below.as_mut_ptr(),
            )
        })?;
        [summary.least_angle, summary.largest_angle, summary.mean_shape] = shapes;
        Ok(summary)
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

    /// Whether each triangle of the domain's facets is one face, and Steiner points are inside
    /// only. Since 1.4.
    pub fn keeps_boundary(&self) -> bool {
        self.stat(sys::MGDT_MESH_STAT_KEEPS_BOUNDARY) == Ok(1)
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

struct Sizes<F> {
    size: F,
    panic: Option<Box<dyn Any + Send>>,
}

/// What the library calls. A panic must not pass through it.
unsafe extern "C" fn find_sizes<F>(n: i64, xyz: *const f64, sizes: *mut f64, user: *mut c_void) -> i32
where
    F: FnMut(&[f64; 3]) -> f64,
{
    let given = &mut *user.cast::<Sizes<F>>();
    let count = usize::try_from(n).unwrap_or(0);
    let places = slice::from_raw_parts(xyz.cast::<[f64; 3]>(), count);
    let to = slice::from_raw_parts_mut(sizes, count);
    let call = AssertUnwindSafe(|| {
        for (place, size) in places.iter().zip(to) {
            *size = (given.size)(place);
        }
    });
    match catch_unwind(call) {
        Ok(()) => 0,
        Err(panic) => {
            given.panic = Some(panic);
            1
        }
    }
}
