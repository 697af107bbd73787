// SPDX-License-Identifier: MIT
//! What a triangulation gives: its parts, and answers about places.

use crate::triangulation::as_i64;
use crate::{Error, ErrorKind, Measure, Method, Outside, TetrahedronMeasure, Triangulation};
use mgdt_sys as sys;

type Get<I> = unsafe extern "C" fn(*const sys::mgdt_triangulation, i64, *mut I) -> sys::mgdt_status;
type Graph = unsafe extern "C" fn(
    *const sys::mgdt_triangulation,
    i64,
    *mut i64,
    *mut i64,
) -> sys::mgdt_status;
type ListExport = unsafe extern "C" fn(
    *const sys::mgdt_triangulation,
    i64,
    *mut i64,
    i64,
    *mut i64,
) -> sys::mgdt_status;
type Locate<I> = unsafe extern "C" fn(
    *const sys::mgdt_triangulation,
    i64,
    *const f64,
    *mut I,
    *mut f64,
) -> sys::mgdt_status;
type Nearest<I> = unsafe extern "C" fn(
    *const sys::mgdt_triangulation,
    i64,
    *const f64,
    *mut I,
) -> sys::mgdt_status;

mod sealed {
    pub trait Sealed {}
    impl Sealed for i32 {}
    impl Sealed for i64 {}
}

/// The integers that the library writes: i32 and i64. A number that does not fit i32 is an error,
/// [`ErrorKind::IndexRange`].
pub trait Int: sealed::Sealed + Copy {
    #[doc(hidden)]
    const TETRAHEDRA: Get<Self>;
    #[doc(hidden)]
    const NEIGHBORS: Get<Self>;
    #[doc(hidden)]
    const HULL_FACETS: Get<Self>;
    #[doc(hidden)]
    const EDGES: Get<Self>;
    #[doc(hidden)]
    const POINT_MAP: Get<Self>;
    #[doc(hidden)]
    const LOCATE: Locate<Self>;
    #[doc(hidden)]
    const NEAREST: Nearest<Self>;
}

impl Int for i32 {
    const TETRAHEDRA: Get<i32> = sys::mgdt_get_tetrahedra_i32;
    const NEIGHBORS: Get<i32> = sys::mgdt_get_neighbors_i32;
    const HULL_FACETS: Get<i32> = sys::mgdt_get_hull_facets_i32;
    const EDGES: Get<i32> = sys::mgdt_get_edges_i32;
    const POINT_MAP: Get<i32> = sys::mgdt_get_point_map_i32;
    const LOCATE: Locate<i32> = sys::mgdt_locate_points_i32;
    const NEAREST: Nearest<i32> = sys::mgdt_nearest_vertices_i32;
}

impl Int for i64 {
    const TETRAHEDRA: Get<i64> = sys::mgdt_get_tetrahedra;
    const NEIGHBORS: Get<i64> = sys::mgdt_get_neighbors;
    const HULL_FACETS: Get<i64> = sys::mgdt_get_hull_facets;
    const EDGES: Get<i64> = sys::mgdt_get_edges;
    const POINT_MAP: Get<i64> = sys::mgdt_get_point_map;
    const LOCATE: Locate<i64> = sys::mgdt_locate_points;
    const NEAREST: Nearest<i64> = sys::mgdt_nearest_vertices;
}

/// Where a point is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Location {
    /// The tetrahedron that contains it.
    pub tetrahedron: usize,
    /// Barycentric coordinates in the order of the tetrahedron's vertices; they add up to 1 within
    /// rounding.
    pub weights: [f64; 4],
}

/// For each point a list: of the tetrahedra around it, or of its neighbours.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PointLists {
    offsets: Vec<usize>,
    list: Vec<usize>,
}

/// What [`Triangulation::vertex_tetrahedra`] gives.
pub type VertexTetrahedra = PointLists;

/// The circumsphere of a tetrahedron.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Circumsphere {
    /// The double nearest to each coordinate of the centre.
    pub center: [f64; 3],
    /// The double nearest to the square of the radius.
    pub squared_radius: f64,
}

impl PointLists {
    /// Those of a point, ascending; none for one that is no vertex. Panics if there is no such
    /// point.
    pub fn of(&self, point: usize) -> &[usize] {
        &self.list[self.offsets[point]..self.offsets[point + 1]]
    }

    /// Where each point's part of the list starts, and its end: one more than there are points.
    pub fn offsets(&self) -> &[usize] {
        &self.offsets
    }

    /// The lists of all points, one after the other.
    pub fn list(&self) -> &[usize] {
        &self.list
    }
}

fn ensure_room(room: usize, needed: usize) -> Result<(), Error> {
    if room >= needed {
        return Ok(());
    }
    Err(Error::new(
        ErrorKind::BufferTooSmall,
        format!("there is room for {} results; {} are needed", room, needed),
    ))
}

fn some(number: i64) -> Option<usize> {
    usize::try_from(number).ok()
}

impl Triangulation {
    fn rows<const W: usize>(&self, count: usize, get: Get<i64>) -> Result<Vec<[i64; W]>, Error> {
        let mut rows = vec![[0_i64; W]; count];
        self.ensure(unsafe {
            get(
                self.raw(),
                as_i64(W * count),
                rows.as_mut_ptr().cast::<i64>(),
            )
        })?;
        Ok(rows)
    }

    fn numbers<const W: usize>(
        &self,
        count: usize,
        get: Get<i64>,
    ) -> Result<Vec<[usize; W]>, Error> {
        let rows = self.rows::<W>(count, get)?;
        Ok(rows
            .into_iter()
            .map(|row| row.map(|k| k as usize))
            .collect())
    }

    fn rows_into<I: Int, const W: usize>(
        &self,
        out: &mut [[I; W]],
        get: Get<I>,
    ) -> Result<(), Error> {
        self.ensure(unsafe {
            get(
                self.raw(),
                as_i64(W * out.len()),
                out.as_mut_ptr().cast::<I>(),
            )
        })
    }

    /// Vertices of each tetrahedron, positively oriented: (v1 - v0) x (v2 - v0) . (v3 - v0) > 0.
    pub fn tetrahedra(&self) -> Result<Vec<[usize; 4]>, Error> {
        self.numbers(self.tetrahedron_count(), i64::TETRAHEDRA)
    }

    /// The same into a slice with room for [`tetrahedron_count`](Triangulation::tetrahedron_count)
    /// rows or more, without a copy.
    pub fn tetrahedra_into<I: Int>(&self, out: &mut [[I; 4]]) -> Result<(), Error> {
        self.rows_into(out, I::TETRAHEDRA)
    }

    /// Neighbours of each tetrahedron: number i shares the facet opposite vertex i; None on the
    /// hull.
    pub fn neighbors(&self) -> Result<Vec<[Option<usize>; 4]>, Error> {
        let rows = self.rows::<4>(self.tetrahedron_count(), i64::NEIGHBORS)?;
        Ok(rows.into_iter().map(|row| row.map(some)).collect())
    }

    /// The same into a slice, with [`NONE`](crate::NONE) on the hull.
    pub fn neighbors_into<I: Int>(&self, out: &mut [[I; 4]]) -> Result<(), Error> {
        self.rows_into(out, I::NEIGHBORS)
    }

    /// Triangles of the convex hull, counter-clockwise seen from outside.
    pub fn hull_facets(&self) -> Result<Vec<[usize; 3]>, Error> {
        self.numbers(self.hull_facet_count(), i64::HULL_FACETS)
    }

    /// The same into a slice.
    pub fn hull_facets_into<I: Int>(&self, out: &mut [[I; 3]]) -> Result<(), Error> {
        self.rows_into(out, I::HULL_FACETS)
    }

    /// Edges, the lesser number first.
    pub fn edges(&self) -> Result<Vec<[usize; 2]>, Error> {
        self.numbers(self.edge_count(), i64::EDGES)
    }

    /// The same into a slice.
    pub fn edges_into<I: Int>(&self, out: &mut [[I; 2]]) -> Result<(), Error> {
        self.rows_into(out, I::EDGES)
    }

    /// The edges that are the diameter of a sphere with no vertex inside: the Gabriel graph.
    pub fn gabriel_edges(&self) -> Result<Vec<[usize; 2]>, Error> {
        self.graph(self.edge_count(), sys::mgdt_get_gabriel_edges)
    }

    /// The edges of the Euclidean minimum spanning tree.
    pub fn spanning_tree(&self) -> Result<Vec<[usize; 2]>, Error> {
        self.graph(self.vertex_count(), sys::mgdt_get_spanning_tree)
    }

    fn graph(&self, most: usize, get: Graph) -> Result<Vec<[usize; 2]>, Error> {
        let mut edges = vec![[0_i64; 2]; most];
        let mut count = 0;
        self.ensure(unsafe {
            get(
                self.raw(),
                as_i64(2 * most),
                edges.as_mut_ptr().cast(),
                &mut count,
            )
        })?;
        edges.truncate(count as usize);
        Ok(edges.into_iter().map(|e| e.map(|k| k as usize)).collect())
    }

    /// For each point ever given the one that stands for it as a vertex: itself, or the first one
    /// at the same place; None if it is not in.
    pub fn point_map(&self) -> Result<Vec<Option<usize>>, Error> {
        let rows = self.rows::<1>(self.point_count(), i64::POINT_MAP)?;
        Ok(rows.into_iter().map(|[k]| some(k)).collect())
    }

    /// The same into a slice, with [`NONE`](crate::NONE) for what is not in.
    pub fn point_map_into<I: Int>(&self, out: &mut [I]) -> Result<(), Error> {
        self.ensure(unsafe { I::POINT_MAP(self.raw(), as_i64(out.len()), out.as_mut_ptr()) })
    }

    /// The tetrahedra around each vertex.
    pub fn vertex_tetrahedra(&self) -> Result<PointLists, Error> {
        let length = unsafe { sys::mgdt_vertex_tetrahedra_count(self.raw()) };
        self.lists(length, sys::mgdt_get_vertex_tetrahedra)
    }

    /// The neighbours of each vertex: those that edges join it to.
    pub fn vertex_neighbors(&self) -> Result<PointLists, Error> {
        let length = unsafe { sys::mgdt_vertex_neighbors_count(self.raw()) };
        self.lists(length, sys::mgdt_get_vertex_neighbors)
    }

    fn lists(&self, length: i64, get: ListExport) -> Result<PointLists, Error> {
        let mut offsets = vec![0_i64; self.point_count() + 1];
        let mut list = vec![0_i64; length as usize];
        self.ensure(unsafe {
            get(
                self.raw(),
                as_i64(offsets.len()),
                offsets.as_mut_ptr(),
                length,
                list.as_mut_ptr(),
            )
        })?;
        Ok(PointLists {
            offsets: offsets.into_iter().map(|k| k as usize).collect(),
            list: list.into_iter().map(|k| k as usize).collect(),
        })
    }

    /// The circumsphere of each tetrahedron.
    pub fn circumspheres(&self) -> Result<Vec<Circumsphere>, Error> {
        let n = self.tetrahedron_count();
        let mut centers = vec![[0.0; 3]; n];
        let mut squares = vec![0.0; n];
        self.ensure(unsafe {
            sys::mgdt_get_circumcenters(
                self.raw(),
                as_i64(n),
                centers.as_mut_ptr().cast(),
                squares.as_mut_ptr(),
            )
        })?;
        let pairs = centers.into_iter().zip(squares);
        Ok(pairs
            .map(|(center, squared_radius)| Circumsphere {
                center,
                squared_radius,
            })
            .collect())
    }

    /// Alphas, squares of radii, of the tetrahedra (dimension 3), of the facets opposite their
    /// vertices (2), four a tetrahedron, of the edges (1), or of the points (0).
    pub fn alphas(&self, dimension: i32) -> Result<Vec<f64>, Error> {
        let count = match dimension {
            0 => self.point_count(),
            1 => self.edge_count(),
            2 => 4 * self.tetrahedron_count(),
            _ => self.tetrahedron_count(),
        };
        let mut x = vec![0.0; count];
        self.ensure(unsafe {
            sys::mgdt_get_alphas(self.raw(), dimension, as_i64(count), x.as_mut_ptr())
        })?;
        Ok(x)
    }

    /// The surface of an alpha shape, counter-clockwise seen from outside.
    pub fn alpha_surface(&self, alpha2: f64) -> Result<Vec<[usize; 3]>, Error> {
        // Enough for one surface or some; the count says what others need.
        let mut facets = vec![[0_i64; 3]; 2 * self.vertex_count() + 4];
        loop {
            let mut count = 0;
            let status = unsafe {
                sys::mgdt_get_alpha_surface(
                    self.raw(),
                    alpha2,
                    as_i64(3 * facets.len()),
                    facets.as_mut_ptr().cast(),
                    &mut count,
                )
            };
            let is_short = status == sys::MGDT_ERR_BUFFER_TOO_SMALL;
            if !is_short {
                self.ensure(status)?;
            }
            facets.resize(count as usize, [0; 3]);
            if !is_short {
                return Ok(facets.into_iter().map(|f| f.map(|k| k as usize)).collect());
            }
        }
    }

    /// The least alpha with all vertices in one solid.
    pub fn solid_alpha(&self) -> Result<f64, Error> {
        let mut alpha2 = 0.0;
        self.ensure(unsafe { sys::mgdt_get_solid_alpha(self.raw(), &mut alpha2) })?;
        Ok(alpha2)
    }

    /// A measure of each tetrahedron. Since 1.3.
    pub fn tetrahedron_measures(&self, measure: TetrahedronMeasure) -> Result<Vec<f64>, Error> {
        let mut x = vec![0.0; self.tetrahedron_count()];
        self.ensure(unsafe {
            sys::mgdt_get_tetrahedron_measures(
                self.raw(),
                measure as i32,
                as_i64(x.len()),
                x.as_mut_ptr(),
            )
        })?;
        Ok(x)
    }

    /// A measure of each point's Voronoi cell: one number, or the three of a centroid, a point.
    /// Cells are clipped to planes a b c d, where a x + b y + c z <= d; without any, those of hull
    /// vertices are infinite.
    pub fn cell_measures(&self, measure: Measure, planes: &[[f64; 4]]) -> Result<Vec<f64>, Error> {
        let width = if measure == Measure::Centroid { 3 } else { 1 };
        let mut x = vec![0.0; width * self.point_count()];
        self.ensure(unsafe {
            sys::mgdt_get_cell_measures(
                self.raw(),
                measure as i32,
                as_i64(planes.len()),
                planes.as_ptr().cast(),
                as_i64(x.len()),
                x.as_mut_ptr(),
            )
        })?;
        Ok(x)
    }

    fn ensure_values(&self, fields: usize, values: &[f64]) -> Result<(), Error> {
        ensure_room(values.len(), fields * self.point_count())
    }

    /// Values at places from values at the points, `fields` numbers for each, those of a point one
    /// behind the other. NaN where there is no value. Since 1.2.
    pub fn interpolate(
        &self,
        method: Method,
        outside: Outside,
        fields: usize,
        values: &[f64],
        places: &[[f64; 3]],
    ) -> Result<Vec<f64>, Error> {
        self.ensure_values(fields, values)?;
        let mut out = vec![0.0; fields * places.len()];
        self.ensure(unsafe {
            sys::mgdt_interpolate(
                self.raw(),
                method as i32,
                outside as i32,
                as_i64(fields),
                values.as_ptr(),
                as_i64(places.len()),
                places.as_ptr().cast(),
                out.as_mut_ptr(),
            )
        })?;
        Ok(out)
    }

    /// The same as weights, for any fields: pairs of a point and its weight for each place. Since 1.2.
    pub fn interpolation_weights(
        &self,
        method: Method,
        outside: Outside,
        places: &[[f64; 3]],
    ) -> Result<Vec<Vec<(usize, f64)>>, Error> {
        let mut offsets = vec![0_i64; places.len() + 1];
        // Enough for most; the last offset says what others need.
        let mut room = 24 * places.len() + 8;
        loop {
            let mut points = vec![0_i64; room];
            let mut weights = vec![0.0; room];
            let status = unsafe {
                sys::mgdt_get_interpolation_weights(
                    self.raw(),
                    method as i32,
                    outside as i32,
                    as_i64(places.len()),
                    places.as_ptr().cast(),
                    as_i64(offsets.len()),
                    offsets.as_mut_ptr(),
                    as_i64(room),
                    points.as_mut_ptr(),
                    weights.as_mut_ptr(),
                )
            };
            if status == sys::MGDT_ERR_BUFFER_TOO_SMALL {
                room = offsets[places.len()] as usize;
                continue;
            }
            self.ensure(status)?;
            let row = |ends: &[i64]| {
                (ends[0] as usize..ends[1] as usize)
                    .map(|k| (points[k] as usize, weights[k]))
                    .collect()
            };
            return Ok(offsets.windows(2).map(row).collect());
        }
    }

    /// Gradients of values at the points, one for each field of each. Since 1.2.
    pub fn gradients(&self, fields: usize, values: &[f64]) -> Result<Vec<[f64; 3]>, Error> {
        self.ensure_values(fields, values)?;
        let mut out = vec![[0.0; 3]; fields * self.point_count()];
        self.ensure(unsafe {
            sys::mgdt_get_gradients(
                self.raw(),
                as_i64(fields),
                values.as_ptr(),
                out.as_mut_ptr().cast(),
            )
        })?;
        Ok(out)
    }

    /// The tetrahedron that contains a point, its boundary included; None outside the hull.
    pub fn locate(&self, point: [f64; 3]) -> Result<Option<usize>, Error> {
        let mut found = crate::NONE;
        self.ensure(unsafe { sys::mgdt_locate(self.raw(), point.as_ptr(), &mut found) })?;
        Ok(some(found))
    }

    /// The same for many points, much faster than one by one, with weights for interpolation.
    pub fn locate_points(&self, points: &[[f64; 3]]) -> Result<Vec<Option<Location>>, Error> {
        let mut found = vec![crate::NONE; points.len()];
        let mut weights = vec![[0.0; 4]; points.len()];
        self.locate_points_into(points, &mut found, Some(&mut weights))?;
        Ok(found
            .into_iter()
            .zip(weights)
            .map(|(k, weights)| {
                some(k).map(|tetrahedron| Location {
                    tetrahedron,
                    weights,
                })
            })
            .collect())
    }

    /// The same into slices of the points' length or more, with [`NONE`](crate::NONE) and zeros
    /// outside.
    pub fn locate_points_into<I: Int>(
        &self,
        points: &[[f64; 3]],
        tetrahedra: &mut [I],
        weights: Option<&mut [[f64; 4]]>,
    ) -> Result<(), Error> {
        let room = weights
            .as_ref()
            .map_or(usize::MAX, |w| w.len())
            .min(tetrahedra.len());
        ensure_room(room, points.len())?;
        let weights = weights.map_or(std::ptr::null_mut(), |w| w.as_mut_ptr().cast::<f64>());
        self.ensure(unsafe {
            I::LOCATE(
                self.raw(),
                as_i64(points.len()),
                points.as_ptr().cast::<f64>(),
                tetrahedra.as_mut_ptr(),
                weights,
            )
        })
    }

    /// The tetrahedra that the segment from a to b passes through, in order, and the parameters
    /// between them: tetrahedron k is entered at a + parameters\[k\] (b - a) and left at
    /// a + parameters\[k + 1\] (b - a). Since 1.3.
    pub fn traverse_segment(
        &self,
        a: [f64; 3],
        b: [f64; 3],
    ) -> Result<(Vec<usize>, Vec<f64>), Error> {
        // Enough for most segments; the count says what others need.
        let mut count = 128;
        loop {
            let room = count;
            let mut found = vec![0_i64; room as usize];
            let mut parameters = vec![0.0; room as usize + 1];
            let status = unsafe {
                sys::mgdt_traverse_segment(
                    self.raw(),
                    a.as_ptr(),
                    b.as_ptr(),
                    room,
                    found.as_mut_ptr(),
                    parameters.as_mut_ptr(),
                    &mut count,
                )
            };
            if status == sys::MGDT_ERR_BUFFER_TOO_SMALL {
                continue;
            }
            self.ensure(status)?;
            found.truncate(count as usize);
            parameters.truncate(if count == 0 { 0 } else { count as usize + 1 });
            return Ok((found.into_iter().map(|k| k as usize).collect(), parameters));
        }
    }

    /// The vertex nearest to a point, exactly; of several as near, the lowest number. None if the
    /// triangulation is empty.
    pub fn nearest_vertex(&self, point: [f64; 3]) -> Result<Option<usize>, Error> {
        let mut found = crate::NONE;
        self.ensure(unsafe { sys::mgdt_nearest_vertex(self.raw(), point.as_ptr(), &mut found) })?;
        Ok(some(found))
    }

    /// The same for many points, much faster than one by one. Since 1.2.
    pub fn nearest_vertices(&self, points: &[[f64; 3]]) -> Result<Vec<Option<usize>>, Error> {
        let mut found = vec![crate::NONE; points.len()];
        self.nearest_vertices_into(points, &mut found)?;
        Ok(found.into_iter().map(some).collect())
    }

    /// The same into a slice of the points' length or more, with [`NONE`](crate::NONE) where there
    /// are no vertices. Since 1.2.
    pub fn nearest_vertices_into<I: Int>(
        &self,
        points: &[[f64; 3]],
        vertices: &mut [I],
    ) -> Result<(), Error> {
        ensure_room(vertices.len(), points.len())?;
        self.ensure(unsafe {
            I::NEAREST(
                self.raw(),
                as_i64(points.len()),
                points.as_ptr().cast::<f64>(),
                vertices.as_mut_ptr(),
            )
        })
    }
}
