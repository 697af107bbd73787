// SPDX-License-Identifier: MIT
//! Domains: what closed surfaces enclose.

use crate::keyed::{Calls, Keyed};
use crate::triangulation::{as_i64, status_text, watched};
use crate::{Error, ErrorKind, Mesh};
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
    /// The first corner of each facet in [`FacetCorners`](DomainArray::FacetCorners), and the end. Since 1.4.
    FacetOffsets = sys::MGDT_DOMAIN_ARRAY_FACET_OFFSETS,
    /// The corners of facets. Since 1.4.
    FacetCorners = sys::MGDT_DOMAIN_ARRAY_FACET_CORNERS,
    /// The marker of each facet. Since 1.4.
    FacetMarkers = sys::MGDT_DOMAIN_ARRAY_FACET_MARKERS,
    /// For each facet the one that was set that it is, or is a part of. Since 1.4.
    FacetOrigins = sys::MGDT_DOMAIN_ARRAY_FACET_ORIGINS,
    /// Pairs of a facet that is covered and the one that stays in its place. Since 1.4.
    CoveredFacets = sys::MGDT_DOMAIN_ARRAY_COVERED_FACETS,
    /// Two points for each segment. Since 1.4.
    Segments = sys::MGDT_DOMAIN_ARRAY_SEGMENTS,
    /// The marker of each segment. Since 1.4.
    SegmentMarkers = sys::MGDT_DOMAIN_ARRAY_SEGMENT_MARKERS,
    /// For each segment the one that was set that it is, or is a part of. Since 1.4.
    SegmentOrigins = sys::MGDT_DOMAIN_ARRAY_SEGMENT_ORIGINS,
}

/// Statistics of a [`Domain`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
#[repr(i32)]
pub enum DomainStatistic {
    /// Points that were set.
    Points = sys::MGDT_DOMAIN_STAT_POINTS,
    /// Facets that were set.
    Facets = sys::MGDT_DOMAIN_STAT_FACETS,
    /// Segments that were set.
    Segments = sys::MGDT_DOMAIN_STAT_SEGMENTS,
    /// Places of regions that were set.
    Regions = sys::MGDT_DOMAIN_STAT_REGIONS,
    /// Places of holes that were set.
    Holes = sys::MGDT_DOMAIN_STAT_HOLES,
    /// Memory that the domain holds, in bytes.
    MemoryBytes = sys::MGDT_DOMAIN_STAT_MEMORY_BYTES,
    /// Pairs that the last call has found.
    OffendingPairs = sys::MGDT_DOMAIN_STAT_OFFENDING_PAIRS,
    /// Edges that one facet alone has.
    OpenEdges = sys::MGDT_DOMAIN_STAT_OPEN_EDGES,
    /// Points that the last [`Domain::clean`] has moved to others. Since 1.4.
    MovedPoints = sys::MGDT_DOMAIN_STAT_MOVED_POINTS,
    /// Corners that it has left out. Since 1.4.
    RepeatedCorners = sys::MGDT_DOMAIN_STAT_REPEATED_CORNERS,
    /// Facets of which it has left nothing. Since 1.4.
    CollapsedFacets = sys::MGDT_DOMAIN_STAT_COLLAPSED_FACETS,
    /// Pairs in [`DomainArray::CoveredFacets`]. Since 1.4.
    CoveredFacets = sys::MGDT_DOMAIN_STAT_COVERED_FACETS,
    /// Pairs of an edge and a point that it has divided it at. Since 1.4.
    PointsInEdges = sys::MGDT_DOMAIN_STAT_POINTS_IN_EDGES,
    /// Pairs of a triangle and a point inside that it has divided it at. Since 1.4.
    PointsInFacets = sys::MGDT_DOMAIN_STAT_POINTS_IN_FACETS,
    /// Edges and segments that it has put into facets. Since 1.4.
    EdgesInFacets = sys::MGDT_DOMAIN_STAT_EDGES_IN_FACETS,
    /// Edges between triangles in one plane that it has exchanged. Since 1.4.
    ExchangedEdges = sys::MGDT_DOMAIN_STAT_EXCHANGED_EDGES,
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

/// A domain, which closed surfaces enclose, to be filled with a [`Mesh`]. Since 1.3.
///
/// ```
/// # fn main() -> Result<(), mgdt::Error> {
/// let mut d = mgdt::Domain::new()?;
/// d.set_points(&[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])?;
/// d.set_facets(&[[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]], None)?;
/// let mesh = d.build()?;
/// assert_eq!(mesh.tetrahedra()?.len(), 1);
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
            .field("points", &self.statistic(DomainStatistic::Points))
            .field("facets", &self.statistic(DomainStatistic::Facets))
            .finish()
    }
}

pub(crate) fn ensure_markers(markers: Option<&[i32]>, n: usize) -> Result<*const i32, Error> {
    match markers {
        None => Ok(ptr::null()),
        Some(markers) if markers.len() == n => Ok(markers.as_ptr()),
        Some(markers) => Err(Error::new(
            ErrorKind::InvalidArgument,
            format!("there are {} markers; there must be {}", markers.len(), n),
        )),
    }
}

impl Keyed for Domain {
    type Handle = sys::mgdt_domain;
    const CALLS: Calls<sys::mgdt_domain> = Calls {
        get_error: sys::mgdt_domain_get_error,
        set_option: Some(sys::mgdt_domain_set_option),
        set_double_option: Some(sys::mgdt_domain_set_double_option),
        get_stat: sys::mgdt_domain_get_stat,
        get_size: sys::mgdt_domain_get_size,
        get_array: sys::mgdt_domain_get_array,
        get_doubles: Some(sys::mgdt_domain_get_doubles),
    };

    fn raw(&self) -> *mut sys::mgdt_domain {
        self.d.as_ptr()
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

    /// Sets how many threads a call may use; 0 for all cores.
    pub fn set_threads(&mut self, threads: usize) -> Result<(), Error> {
        self.set_option(sys::MGDT_DOMAIN_OPTION_THREADS, as_i64(threads))
    }

    /// Limits the memory that the domain may hold, in bytes; None for no limit.
    pub fn set_memory_limit(&mut self, bytes: Option<usize>) -> Result<(), Error> {
        self.set_limit(sys::MGDT_DOMAIN_OPTION_MEMORY_LIMIT, bytes)
    }

    /// Whether points are rounded always, so that facets are covered exactly by what is returned.
    pub fn set_rounded(&mut self, on: bool) -> Result<(), Error> {
        self.set_option(sys::MGDT_DOMAIN_OPTION_ROUND_POINTS, i64::from(on))
    }

    /// Whether a build refuses a mesh that leaves out points, facets, regions or holes.
    pub fn set_strict(&mut self, on: bool) -> Result<(), Error> {
        self.set_option(sys::MGDT_DOMAIN_OPTION_STRICT, i64::from(on))
    }

    /// Whether each triangle of a facet is one face and each segment one edge, with Steiner points
    /// inside of the domain only.
    pub fn set_keep_boundary(&mut self, on: bool) -> Result<(), Error> {
        self.set_option(sys::MGDT_DOMAIN_OPTION_KEEP_BOUNDARY, i64::from(on))
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

    /// Gives the regions around places their markers, in place of those before.
    pub fn set_regions(&mut self, places: &[[f64; 3]], markers: &[i32]) -> Result<(), Error> {
        let of_regions = ensure_markers(Some(markers), places.len())?;
        let status = unsafe {
            sys::mgdt_domain_set_regions(
                self.raw(),
                as_i64(places.len()),
                places.as_ptr().cast(),
                of_regions,
            )
        };
        self.ensure(status)
    }

    /// Leaves what facets enclose around places empty, in place of the holes before.
    pub fn set_holes(&mut self, places: &[[f64; 3]]) -> Result<(), Error> {
        let status = unsafe {
            sys::mgdt_domain_set_holes(self.raw(), as_i64(places.len()), places.as_ptr().cast())
        };
        self.ensure(status)
    }

    /// Removes points, facets, segments, regions and holes; what else was set stays.
    pub fn clear(&mut self) {
        // It fails for NULL alone.
        unsafe { sys::mgdt_domain_clear(self.raw()) };
    }

    /// Mends what needs no new points: repeated corners, collapsed and equal facets, points in edges
    /// and in facets, and edges in facets. `weld` is the distance within which places are one, and
    /// `flatness` that within which facets of one marker are in one plane, as shares of the diagonal
    /// of the points' box. Since 1.4.
    pub fn clean(&mut self, weld: f64, flatness: f64) -> Result<(), Error> {
        self.set_double_option(sys::MGDT_DOMAIN_OPTION_WELD, weld)?;
        self.set_double_option(sys::MGDT_DOMAIN_OPTION_FLATNESS, flatness)?;
        let status = unsafe { sys::mgdt_domain_clean(self.raw()) };
        self.ensure(status)
    }

    /// The points, with the coordinates of others where [`clean`](Domain::clean) has welded them.
    /// Since 1.4.
    pub fn points(&self) -> Result<Vec<[f64; 3]>, Error> {
        self.rows(sys::MGDT_DOMAIN_ARRAY_POINTS)
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

    /// Makes a mesh. [`ErrorKind::InvalidBoundary`] if facets, segments or points cross or touch
    /// where they must not; [`offending_pairs`](Domain::offending_pairs) gives them then.
    /// [`ErrorKind::OpenBoundary`] if the facets enclose nothing.
    pub fn build(&mut self) -> Result<Mesh, Error> {
        let mut out = ptr::null_mut();
        let status = unsafe { sys::mgdt_domain_build(self.raw(), &mut out) };
        self.ensure(status)?;
        Mesh::of_raw(out)
    }

    /// The same with a closure that hears of progress, as
    /// [`insert_with_progress`](crate::Triangulation::insert_with_progress) has it.
    pub fn build_with_progress<F>(&mut self, progress: F) -> Result<Mesh, Error>
    where
        F: FnMut(f64) -> ControlFlow<()>,
    {
        let d = self.raw();
        let mut out = ptr::null_mut();
        let status = watched(progress, |report, user| unsafe {
            sys::mgdt_domain_set_progress(d, Some(report), user);
            let status = sys::mgdt_domain_build(d, &mut out);
            sys::mgdt_domain_set_progress(d, None, ptr::null_mut());
            status
        });
        self.ensure(status)?;
        Mesh::of_raw(out)
    }

    /// Compares a mesh with what was set, exactly; [`Mesh::check`] proves the rest of it.
    pub fn check(&self, mesh: &Mesh) -> Result<(), Error> {
        self.ensure(unsafe { sys::mgdt_domain_check(self.raw(), mesh.raw()) })
    }

    /// One number of the domain.
    pub fn statistic(&self, statistic: DomainStatistic) -> usize {
        // It fails for unknown keys alone.
        self.stat(statistic as i32).unwrap_or(0) as usize
    }

    /// An array of integers.
    pub fn array(&self, array: DomainArray) -> Result<Vec<i64>, Error> {
        self.integers(array as i32)
    }
}
