// SPDX-License-Identifier: MIT
//! Meshes of what closed surfaces enclose.

use crate::triangulation::{as_i64, error_of, status_text, watched};
use crate::{Error, ErrorKind};
use mgdt_sys as sys;
use std::fmt;
use std::ops::ControlFlow;
use std::ptr;

/// Arrays of integers of a [`Domain`]. In them "none" is [`NONE`](crate::NONE).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
#[repr(i32)]
pub enum DomainArray {
    /// The ends of each edge that one facet alone has, and this facet.
    OpenEdges = sys::MGDT_DOMAIN_ARRAY_OPEN_EDGES,
    /// Four corners for each tetrahedron.
    Tetrahedra = sys::MGDT_DOMAIN_ARRAY_TETRAHEDRA,
    /// The four tetrahedra opposite the corners of each; none where the domain ends.
    Neighbors = sys::MGDT_DOMAIN_ARRAY_NEIGHBORS,
    /// The region of each tetrahedron.
    Regions = sys::MGDT_DOMAIN_ARRAY_REGIONS,
    /// The marker of each region.
    RegionMarkers = sys::MGDT_DOMAIN_ARRAY_REGION_MARKERS,
    /// Three corners for each face of the mesh that is a part of a facet.
    Faces = sys::MGDT_DOMAIN_ARRAY_FACES,
    /// The two tetrahedra at each face, or none.
    FaceTetrahedra = sys::MGDT_DOMAIN_ARRAY_FACE_TETRAHEDRA,
    /// The facet that each face is a part of.
    FaceFacets = sys::MGDT_DOMAIN_ARRAY_FACE_FACETS,
    /// The marker of this facet.
    FaceMarkers = sys::MGDT_DOMAIN_ARRAY_FACE_MARKERS,
    /// Two ends for each edge of the mesh that is a part of a segment or of an edge of facets.
    Segments = sys::MGDT_DOMAIN_ARRAY_SEGMENTS,
    /// The segment that was set, and that each of these is a part of, or none.
    SegmentSources = sys::MGDT_DOMAIN_ARRAY_SEGMENT_SOURCES,
    /// The marker of this segment, or 0.
    SegmentMarkers = sys::MGDT_DOMAIN_ARRAY_SEGMENT_MARKERS,
    /// The two ends of the edge that each Steiner point divides.
    SteinerEdges = sys::MGDT_DOMAIN_ARRAY_STEINER_EDGES,
}

/// Arrays of numbers of a [`Domain`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
#[repr(i32)]
pub enum DomainNumbers {
    /// Three coordinates of each point: those that were set, then the Steiner points.
    Points = sys::MGDT_DOMAIN_ARRAY_POINTS,
    /// For each Steiner point the t for which it is a + t (b - a).
    SteinerParameters = sys::MGDT_DOMAIN_ARRAY_STEINER_PARAMETERS,
}

/// Single numbers of a [`Domain`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
#[repr(i32)]
pub enum DomainCount {
    /// Memory that the domain holds, in bytes.
    MemoryBytes = sys::MGDT_DOMAIN_MEMORY_BYTES,
    /// Points that the build has added.
    SteinerPoints = sys::MGDT_DOMAIN_STEINER_POINTS,
    /// Tetrahedra of the mesh.
    Tetrahedra = sys::MGDT_DOMAIN_TETRAHEDRA,
    /// Regions of the mesh.
    Regions = sys::MGDT_DOMAIN_REGIONS,
    /// Faces of the mesh that are parts of facets.
    Faces = sys::MGDT_DOMAIN_FACES,
    /// Coordinates are rounded to multiples of 2^-bits of the largest one.
    GridBits = sys::MGDT_DOMAIN_GRID_BITS,
    /// Edges that one facet alone has.
    OpenEdges = sys::MGDT_DOMAIN_OPEN_EDGES,
    /// Points that were set and are neither a corner of a tetrahedron nor equal to one.
    UnusedPoints = sys::MGDT_DOMAIN_UNUSED_POINTS,
    /// Faces at which there is no tetrahedron: their facets bound nothing and are outside.
    UnusedFaces = sys::MGDT_DOMAIN_UNUSED_FACES,
    /// Places of regions in no region of the mesh.
    UnusedRegions = sys::MGDT_DOMAIN_UNUSED_REGIONS,
    /// Holes in nothing that the facets enclose.
    UnusedHoles = sys::MGDT_DOMAIN_UNUSED_HOLES,
    /// Facets, where those in one plane are joined.
    PlanarFacets = sys::MGDT_DOMAIN_PLANAR_FACETS,
    /// Of these, those that the Delaunay triangulation of all points lacks.
    MissingFacets = sys::MGDT_DOMAIN_MISSING_FACETS,
    /// Parts of it that were filled anew.
    Cavities = sys::MGDT_DOMAIN_CAVITIES,
    /// The most tetrahedra in one of them.
    LargestCavity = sys::MGDT_DOMAIN_LARGEST_CAVITY,
}

/// What crosses or touches where it must not.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum DomainPart {
    /// A facet, by its number.
    Facet(usize),
    /// A segment.
    Segment(usize),
    /// A point that is a corner of no facet and of no segment.
    Point(usize),
}

/// A domain, what closed surfaces enclose, and the mesh that fills it. Since 1.3.
///
/// ```
/// # fn main() -> Result<(), mgdt::Error> {
/// let mut d = mgdt::Domain::new()?;
/// d.set_points(&[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])?;
/// d.set_facets(&[[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]], None)?;
/// d.build()?;
/// assert_eq!(d.tetrahedra()?.len(), 1);
/// # Ok(())
/// # }
/// ```
///
/// `mgdt/mgdt_domain.h` says what goes in and comes out.
pub struct Domain {
    d: ptr::NonNull<sys::mgdt_domain>,
}

// A handle is bound to no thread. What takes &self passes a const pointer, which the library allows
// from many threads at once.
unsafe impl Send for Domain {}
unsafe impl Sync for Domain {}

impl Drop for Domain {
    fn drop(&mut self) {
        unsafe { sys::mgdt_domain_destroy(self.d.as_ptr()) };
    }
}

impl fmt::Debug for Domain {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Domain")
            .field("tetrahedra", &self.count(DomainCount::Tetrahedra))
            .field("regions", &self.count(DomainCount::Regions))
            .finish()
    }
}

fn ensure_markers(markers: Option<&[i32]>, n: usize) -> Result<*const i32, Error> {
    match markers {
        None => Ok(ptr::null()),
        Some(markers) if markers.len() == n => Ok(markers.as_ptr()),
        Some(markers) => Err(Error::new(
            ErrorKind::InvalidArgument,
            format!("there are {} markers; there must be {}", markers.len(), n),
        )),
    }
}

impl Domain {
    /// A domain without points.
    pub fn new() -> Result<Domain, Error> {
        let mut out = ptr::null_mut();
        let status = unsafe { sys::mgdt_domain_create(&mut out) };
        match ptr::NonNull::new(out) {
            Some(d) if status == sys::MGDT_OK => Ok(Domain { d }),
            _ => Err(Error::of_status(status, status_text(status))),
        }
    }

    fn raw(&self) -> *mut sys::mgdt_domain {
        self.d.as_ptr()
    }

    fn ensure(&self, status: sys::mgdt_status) -> Result<(), Error> {
        if status == sys::MGDT_OK {
            return Ok(());
        }
        Err(error_of(status, |capacity, buffer| unsafe {
            sys::mgdt_domain_get_error(self.raw(), capacity, buffer);
        }))
    }

    fn set_option(&mut self, option: i32, value: i64) -> Result<(), Error> {
        let status = unsafe { sys::mgdt_domain_set_option(self.raw(), option, value) };
        self.ensure(status)
    }

    /// Sets how many threads a call may use; 0 for all cores.
    pub fn set_threads(&mut self, threads: usize) -> Result<(), Error> {
        self.set_option(sys::MGDT_DOMAIN_THREADS, as_i64(threads))
    }

    /// Limits the memory that the domain may hold, in bytes; None for no limit.
    pub fn set_memory_limit(&mut self, bytes: Option<usize>) -> Result<(), Error> {
        // No limit is 0 there; a limit of 0 would be none at all.
        let limit = bytes.map_or(0, |bytes| as_i64(bytes.max(1)));
        self.set_option(sys::MGDT_DOMAIN_MEMORY_LIMIT, limit)
    }

    /// Whether points are rounded always, so that facets are covered exactly by what is returned.
    pub fn set_rounded(&mut self, on: bool) -> Result<(), Error> {
        self.set_option(sys::MGDT_DOMAIN_ROUND_POINTS, i64::from(on))
    }

    /// Whether a build refuses a mesh that leaves out points, facets, regions or holes.
    pub fn set_strict(&mut self, on: bool) -> Result<(), Error> {
        self.set_option(sys::MGDT_DOMAIN_STRICT, i64::from(on))
    }

    /// Sets the points. Facets and segments that were set before are removed.
    pub fn set_points(&mut self, points: &[[f64; 3]]) -> Result<(), Error> {
        let status = unsafe {
            sys::mgdt_domain_set_points(self.raw(), as_i64(points.len()), points.as_ptr().cast())
        };
        self.ensure(status)
    }

    /// Sets the facets: lists of corners, `[usize; 3]` or `Vec<usize>`. Without markers all are 0.
    pub fn set_facets<F: AsRef<[usize]>>(
        &mut self,
        facets: &[F],
        markers: Option<&[i32]>,
    ) -> Result<(), Error> {
        let of_facets = ensure_markers(markers, facets.len())?;
        let mut offsets = vec![0_i64];
        let mut corners = Vec::new();
        for facet in facets {
            corners.extend(facet.as_ref().iter().map(|&k| as_i64(k)));
            offsets.push(as_i64(corners.len()));
        }
        let status = unsafe {
            sys::mgdt_domain_set_facets(
                self.raw(),
                as_i64(facets.len()),
                offsets.as_ptr(),
                corners.as_ptr(),
                of_facets,
            )
        };
        self.ensure(status)
    }

    /// Sets segments, edges that the mesh has to have besides those of facets.
    pub fn set_segments(
        &mut self,
        ends: &[[usize; 2]],
        markers: Option<&[i32]>,
    ) -> Result<(), Error> {
        let of_segments = ensure_markers(markers, ends.len())?;
        let listed: Vec<i64> = ends.iter().flatten().map(|&k| as_i64(k)).collect();
        let status = unsafe {
            sys::mgdt_domain_set_segments(
                self.raw(),
                as_i64(ends.len()),
                listed.as_ptr(),
                of_segments,
            )
        };
        self.ensure(status)
    }

    /// Gives the region around a place a marker.
    pub fn add_region(&mut self, place: [f64; 3], marker: i32) -> Result<(), Error> {
        let status = unsafe { sys::mgdt_domain_add_region(self.raw(), place.as_ptr(), marker) };
        self.ensure(status)
    }

    /// Leaves what facets enclose around a place empty.
    pub fn add_hole(&mut self, place: [f64; 3]) -> Result<(), Error> {
        let status = unsafe { sys::mgdt_domain_add_hole(self.raw(), place.as_ptr()) };
        self.ensure(status)
    }

    /// Removes points, facets, segments, regions, holes and the mesh; what else was set stays.
    pub fn clear(&mut self) {
        // It fails for NULL alone.
        unsafe { sys::mgdt_domain_clear(self.raw()) };
    }

    /// All pairs of facets, segments and points that do not meet in common corners and edges,
    /// exactly. What is bad by itself is paired with itself.
    pub fn validate(&mut self) -> Result<Vec<(DomainPart, DomainPart)>, Error> {
        let status = unsafe { sys::mgdt_domain_validate(self.raw()) };
        if status != sys::MGDT_ERR_INVALID_BOUNDARY {
            self.ensure(status)?;
        }
        self.offending_pairs()
    }

    /// The pairs that [`validate`](Domain::validate) or [`build`](Domain::build) has found last.
    pub fn offending_pairs(&self) -> Result<Vec<(DomainPart, DomainPart)>, Error> {
        let listed = self.integers(sys::MGDT_DOMAIN_ARRAY_OFFENDING_PAIRS)?;
        let part = |kind: i64, k: i64| match kind as i32 {
            sys::MGDT_DOMAIN_KIND_FACET => DomainPart::Facet(k as usize),
            sys::MGDT_DOMAIN_KIND_SEGMENT => DomainPart::Segment(k as usize),
            _ => DomainPart::Point(k as usize),
        };
        let pair = |p: &[i64]| (part(p[0], p[1]), part(p[2], p[3]));
        Ok(listed.chunks_exact(4).map(pair).collect())
    }

    /// Makes the mesh. [`ErrorKind::InvalidBoundary`] if facets, segments or points cross or touch
    /// where they must not; [`offending_pairs`](Domain::offending_pairs) gives them then.
    /// [`ErrorKind::OpenBoundary`] if the facets enclose nothing.
    pub fn build(&mut self) -> Result<(), Error> {
        let status = unsafe { sys::mgdt_domain_build(self.raw()) };
        self.ensure(status)
    }

    /// The same with a closure that hears of progress, as
    /// [`insert_with_progress`](crate::Triangulation::insert_with_progress) has it.
    pub fn build_with_progress<F>(&mut self, progress: F) -> Result<(), Error>
    where
        F: FnMut(f64) -> ControlFlow<()>,
    {
        let d = self.raw();
        let status = watched(progress, |report, user| unsafe {
            sys::mgdt_domain_set_progress(d, Some(report), user);
            let status = sys::mgdt_domain_build(d);
            sys::mgdt_domain_set_progress(d, None, ptr::null_mut());
            status
        });
        self.ensure(status)
    }

    /// Proves the mesh against what was set, exactly.
    pub fn check(&self) -> Result<(), Error> {
        self.ensure(unsafe { sys::mgdt_domain_check(self.raw()) })
    }

    /// One number of the domain.
    pub fn count(&self, count: DomainCount) -> usize {
        self.stat(count as i32) as usize
    }

    /// Whether the points that are returned are rounded.
    pub fn is_rounded(&self) -> bool {
        self.stat(sys::MGDT_DOMAIN_IS_ROUNDED) == 1
    }

    fn stat(&self, key: i32) -> i64 {
        let mut value = 0;
        // It fails for NULL and for unknown keys alone.
        unsafe { sys::mgdt_domain_get_stat(self.raw(), key, &mut value) };
        value
    }

    fn size(&self, key: i32) -> Result<usize, Error> {
        let mut size = 0;
        self.ensure(unsafe { sys::mgdt_domain_get_size(self.raw(), key, &mut size) })?;
        Ok(size as usize)
    }

    fn integers(&self, key: i32) -> Result<Vec<i64>, Error> {
        let mut values = vec![0; self.size(key)?];
        self.ensure(unsafe {
            sys::mgdt_domain_get_array(self.raw(), key, as_i64(values.len()), values.as_mut_ptr())
        })?;
        Ok(values)
    }

    /// An array of integers.
    pub fn array(&self, array: DomainArray) -> Result<Vec<i64>, Error> {
        self.integers(array as i32)
    }

    /// An array of numbers.
    pub fn numbers(&self, array: DomainNumbers) -> Result<Vec<f64>, Error> {
        let mut values = vec![0.0; self.size(array as i32)?];
        self.ensure(unsafe {
            sys::mgdt_domain_get_doubles(
                self.raw(),
                array as i32,
                as_i64(values.len()),
                values.as_mut_ptr(),
            )
        })?;
        Ok(values)
    }

    /// Positions of the points: those that were set, then the Steiner points.
    pub fn points(&self) -> Result<Vec<[f64; 3]>, Error> {
        let numbers = self.numbers(DomainNumbers::Points)?;
        Ok(numbers
            .chunks_exact(3)
            .map(|x| [x[0], x[1], x[2]])
            .collect())
    }

    /// Corners of the tetrahedra.
    pub fn tetrahedra(&self) -> Result<Vec<[usize; 4]>, Error> {
        let corners = self.array(DomainArray::Tetrahedra)?;
        let row = |v: &[i64]| [v[0] as usize, v[1] as usize, v[2] as usize, v[3] as usize];
        Ok(corners.chunks_exact(4).map(row).collect())
    }

    /// Corners of the faces that are parts of facets.
    pub fn faces(&self) -> Result<Vec<[usize; 3]>, Error> {
        let corners = self.array(DomainArray::Faces)?;
        let row = |v: &[i64]| [v[0] as usize, v[1] as usize, v[2] as usize];
        Ok(corners.chunks_exact(3).map(row).collect())
    }
}
