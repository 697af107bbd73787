// SPDX-License-Identifier: MIT
//! The crate against what the C interface wrote: tests/languages/reference.c, into the folder that
//! MGDT_REFERENCE names.

use mgdt::{Canceller, Check, Order, Parameter, Statistic, Triangulation, NONE};
use std::path::PathBuf;

fn bytes(name: &str) -> Vec<[u8; 8]> {
    let folder = std::env::var_os("MGDT_REFERENCE").expect("MGDT_REFERENCE is not set");
    let path = PathBuf::from(folder).join(name);
    let all = std::fs::read(&path).unwrap_or_else(|e| panic!("{}: {}", path.display(), e));
    all.chunks_exact(8).map(|c| c.try_into().unwrap()).collect()
}

fn integers(name: &str) -> Vec<i64> {
    bytes(name).into_iter().map(i64::from_ne_bytes).collect()
}

fn doubles(name: &str) -> Vec<f64> {
    bytes(name).into_iter().map(f64::from_ne_bytes).collect()
}

fn rows<const W: usize>(name: &str) -> Vec<[i64; W]> {
    integers(name)
        .chunks_exact(W)
        .map(|c| c.try_into().unwrap())
        .collect()
}

fn places(name: &str) -> Vec<[f64; 3]> {
    doubles(name)
        .chunks_exact(3)
        .map(|c| c.try_into().unwrap())
        .collect()
}

fn triangulation() -> Triangulation {
    let mut t = Triangulation::new().unwrap();
    t.set_canonical_output(true);
    t.insert(&places("points")).unwrap();
    t
}

fn plain<const W: usize>(rows: Vec<[usize; W]>) -> Vec<[i64; W]> {
    rows.into_iter().map(|row| row.map(|k| k as i64)).collect()
}

fn indices<const W: usize>(name: &str) -> Vec<[usize; W]> {
    let row = |row: [i64; W]| row.map(|k| k as usize);
    rows::<W>(name).into_iter().map(row).collect()
}

fn number(k: Option<usize>) -> i64 {
    k.map_or(NONE, |k| k as i64)
}

/// The diagrams, clipped to a cube and not, are those of the C interface.
fn diagrams(t: &mgdt::Triangulation, cube: &[[f64; 4]]) {
    use mgdt::{VoronoiArray as Array, VoronoiDoubles as Numbers};
    for (prefix, planes) in [("cut", cube), ("whole", &[][..])] {
        let v = t.voronoi(planes).unwrap();
        let name = |name: &str| format!("{}_{}", prefix, name);
        for (key, of) in [
            (Array::FaceOffsets, "face_offsets"),
            (Array::FaceCorners, "face_corners"),
            (Array::FaceSides, "face_sides"),
            (Array::FaceShifts, "face_shifts"),
            (Array::RayVertices, "ray_vertices"),
            (Array::CellOffsets, "cell_offsets"),
            (Array::CellFaces, "cell_faces"),
            (Array::CellBounded, "cell_bounded"),
            (Array::CellNeighbors, "cell_neighbors"),
            (Array::CellNeighborShifts, "cell_neighbor_shifts"),
        ] {
            assert_eq!(v.array(key).unwrap(), integers(&name(of)), "{}", of);
        }
        for (key, of) in [
            (Numbers::Vertices, "vertices"),
            (Numbers::RayDirections, "ray_directions"),
            (Numbers::FaceAreas, "face_areas"),
            (Numbers::FaceNormals, "face_normals"),
            (Numbers::FaceCentroids, "face_centroids"),
            (Numbers::CellVolumes, "cell_volumes"),
            (Numbers::CellCentroids, "cell_centroids"),
            (Numbers::CellFaceAreas, "cell_face_areas"),
            (Numbers::CellNeighborDistances, "cell_neighbor_distances"),
        ] {
            assert_eq!(v.doubles(key).unwrap(), doubles(&name(of)), "{}", of);
        }
        let flat: Vec<f64> = v.vertices().unwrap().into_iter().flatten().collect();
        assert_eq!(flat, doubles(&name("vertices")));
    }
    let mut v = t.voronoi(cube).unwrap();
    let faces = v.doubles(Numbers::FaceAreas).unwrap().len();
    assert!(format!("{:?}", v).contains(&format!("faces: {}", faces)));
    v.drop_small_faces(0.01, 0.0).unwrap();
    let fewer = v.doubles(Numbers::FaceAreas).unwrap();
    assert!(fewer.len() < faces && fewer.iter().all(|&x| x >= 0.01));
    let error = v.drop_small_faces(-1.0, 0.0).unwrap_err();
    assert_eq!(error.kind(), mgdt::ErrorKind::InvalidArgument);
    assert!(error.message().contains("-1"));
    let error = t.voronoi(&cube[..5]).unwrap_err();
    assert_eq!(error.kind(), mgdt::ErrorKind::InvalidArgument);
    assert!(error.message().contains("no end"));
    fn crosses_threads<T: Send + Sync>(_: &T) {}
    crosses_threads(&v);
}

fn given_domain() -> mgdt::Domain {
    let mut d = mgdt::Domain::new().unwrap();
    let offsets = integers("domain_given_offsets");
    let corners = integers("domain_given_corners");
    let markers: Vec<_> = integers("domain_given_markers")
        .into_iter()
        .map(|k| k as i32)
        .collect();
    let facets: Vec<Vec<usize>> = offsets
        .windows(2)
        .map(|w| &corners[w[0] as usize..w[1] as usize])
        .map(|list| list.iter().map(|&k| k as usize).collect())
        .collect();
    d.set_rounded(true).unwrap();
    d.set_points(&places("domain_given_points")).unwrap();
    d.set_facets(&facets, Some(&markers)).unwrap();
    d.set_segments(&[[0, 1], [8, 9]], Some(&[5, 6])).unwrap();
    d.set_holes(&[[1.0, 1.0, 3.0]]).unwrap();
    d.set_regions(&[[0.0, 0.0, 9.5]], &[7]).unwrap();
    d
}

#[test]
fn a_domain() {
    use mgdt::{DomainStatistic, MeshArray as Array, MeshDoubles as Doubles, MeshStatistic as Statistic};
    let mut d = given_domain();
    assert!(d.validate().unwrap().is_empty());
    let mut heard = 0.0;
    let m = d
        .build_with_progress(|fraction| {
            heard += fraction;
            std::ops::ControlFlow::Continue(())
        })
        .unwrap();
    assert!(heard > 0.0);
    m.check().unwrap();
    d.check(&m).unwrap();
    for (array, name) in [
        (Array::PointOrigins, "point_origins"),
        (Array::Tetrahedra, "tetrahedra"),
        (Array::Neighbors, "neighbors"),
        (Array::TetrahedronRegions, "tetrahedron_regions"),
        (Array::RegionMarkers, "region_markers"),
        (Array::Faces, "faces"),
        (Array::FaceTetrahedra, "face_tetrahedra"),
        (Array::FaceFacets, "face_facets"),
        (Array::FaceMarkers, "face_markers"),
        (Array::Edges, "edges"),
        (Array::EdgeSegments, "edge_segments"),
        (Array::EdgeMarkers, "edge_markers"),
        (Array::SteinerEdges, "steiner_edges"),
    ] {
        let expected = integers(&format!("domain_{}", name));
        assert_eq!(m.array(array).unwrap(), expected, "{}", name);
    }
    assert_eq!(m.points().unwrap(), places("domain_points"));
    assert_eq!(
        m.doubles(Doubles::SteinerParameters).unwrap(),
        doubles("domain_steiner_parameters")
    );
    assert_eq!(
        plain(m.tetrahedra().unwrap()),
        rows::<4>("domain_tetrahedra")
    );
    assert_eq!(plain(m.faces().unwrap()), rows::<3>("domain_faces"));
    assert_eq!(
        m.tetrahedron_measures(mgdt::TetrahedronMeasure::Volume).unwrap(),
        doubles("domain_volumes")
    );
    assert!(m.is_rounded());
    assert_eq!(m.statistic(Statistic::Regions), 2);
    assert_eq!(
        18 + m.statistic(Statistic::SteinerPoints),
        m.points().unwrap().len()
    );
    assert!(m.statistic(Statistic::MemoryBytes) > 1000);
    assert!(d.statistic(DomainStatistic::MemoryBytes) > 1000);
    assert!(format!("{:?}", m).contains("regions: 2"));
    assert!(format!("{:?}", d).contains("points: 18"));
    fn crosses_threads<T: Send + Sync>(_: &T) {}
    crosses_threads(&d);
    crosses_threads(&m);
    d.set_threads(2).unwrap();
    d.set_memory_limit(Some(1)).unwrap();
    assert_eq!(d.build().unwrap_err().kind(), mgdt::ErrorKind::OutOfMemory);
    d.set_memory_limit(None).unwrap();
    let m = d.build().unwrap();
    // A facet in the hole bounds nothing.
    assert!(m.statistic(Statistic::UnusedFaces) > 0);
    assert_eq!(m.statistic(Statistic::UnusedHoles), 0);
    d.set_keep_boundary(true).unwrap();
    let kept = d.build().unwrap();
    assert!(kept.keeps_boundary());
    d.set_keep_boundary(false).unwrap();
    d.clean(0.0, 1e-9).unwrap();
    assert_eq!(d.statistic(mgdt::DomainStatistic::PointsInEdges), 0);
    assert_eq!(
        d.array(mgdt::DomainArray::FacetOrigins).unwrap().len(),
        d.statistic(mgdt::DomainStatistic::Facets)
    );
    assert_eq!(
        d.points().unwrap().len(),
        d.statistic(mgdt::DomainStatistic::Points)
    );
    assert!(d.clean(1.0, 0.0).is_err());
    d.set_strict(true).unwrap();
    assert_eq!(
        d.build().unwrap_err().kind(),
        mgdt::ErrorKind::OpenBoundary
    );
    d.clear();
    assert_eq!(
        d.build().unwrap_err().kind(),
        mgdt::ErrorKind::OpenBoundary
    );
    // The mesh outlives what it was made from.
    drop(d);
    m.check().unwrap();
}

#[test]
fn a_mesh() {
    use std::ops::ControlFlow;
    let markers: Vec<_> = integers("block_given_markers").iter().map(|&k| k as i32).collect();
    let faces = indices::<3>("block_given_faces");
    let mut m = mgdt::Mesh::new().unwrap();
    m.set_threads(2).unwrap();
    m.set_points(&places("block_given_points")).unwrap();
    m.set_tetrahedra(&indices("block_given_tetrahedra"), Some(&markers)).unwrap();
    m.set_faces(&faces, Some(&[9])).unwrap();
    m.set_edges(&[[0, 1]], None).unwrap();
    m.set_edges(&[], None).unwrap();
    let fixed: Vec<_> = integers("block_given_fixed").iter().map(|&k| k as usize).collect();
    m.set_fixed_points(&fixed).unwrap();
    m.build().unwrap();
    m.check().unwrap();
    assert_eq!(format!("{:?}", m), "Mesh { tetrahedra: 384, regions: 2 }");
    m.set_goal(30).unwrap();
    m.set_boundary(mgdt::Boundary::Slide).unwrap();
    m.set_given_points(mgdt::GivenPoints::Move).unwrap();
    m.set_mean_passes(0).unwrap();
    m.set_most_passes(100).unwrap();
    let mut heard = 0;
    m.improve_with_progress(|_| {
        heard += 1;
        ControlFlow::Continue(())
    })
    .unwrap();
    assert!(heard > 0);
    m.check().unwrap();
    assert_eq!(m.statistic(mgdt::MeshStatistic::BelowGoal), 0);
    assert!(m.statistic(mgdt::MeshStatistic::Passes) > 0);
    assert!(m.statistic(mgdt::MeshStatistic::MovedPoints) > 0);
    assert_eq!(m.statistic(mgdt::MeshStatistic::RemovedPoints), 0);
    assert_eq!(plain(m.tetrahedra().unwrap()), rows::<4>("block_tetrahedra"));
    assert_eq!(m.points().unwrap(), places("block_points"));
    assert_eq!(m.doubles(mgdt::MeshDoubles::Shapes).unwrap(), doubles("block_shapes"));
    for (array, name) in [
        (mgdt::MeshArray::Reasons, "reasons"),
        (mgdt::MeshArray::AngleHistogram, "angle_histogram"),
        (mgdt::MeshArray::TetrahedraBelow, "tetrahedra_below"),
    ] {
        assert_eq!(m.array(array).unwrap(), integers(&format!("block_{}", name)));
    }
    assert_eq!(mgdt::Reason::None as i64, m.array(mgdt::MeshArray::Reasons).unwrap()[0]);
    for (nearest, name) in [(false, "inside"), (true, "nearest")] {
        let at = places("places");
        let found = m.locate_points(&at, nearest).unwrap();
        let tetrahedra: Vec<_> = found.iter().map(|f| f.map_or(-1, |(t, _)| t as i64)).collect();
        assert_eq!(tetrahedra, integers(&format!("places_{}_tetrahedra", name)));
        let weights: Vec<_> = found.iter().flat_map(|f| f.map_or([0.0; 4], |(_, w)| w)).collect();
        assert_eq!(weights, doubles(&format!("places_{}_weights", name)));
        let values = m.interpolate(&doubles("block_points"), 3, &at, nearest).unwrap();
        let expected = doubles(&format!("places_{}_values", name));
        let is_same = |(a, b): (&f64, &f64)| a == b || (a.is_nan() && b.is_nan());
        assert!(values.iter().zip(&expected).all(is_same));
    }
    assert!(m.interpolate(&[1.0], 1, &[], false).is_err());
    let summary = m.shape_summary().unwrap();
    assert_eq!([summary.least_angle, summary.largest_angle, summary.mean_shape].to_vec(), doubles("summary_shapes"));
    assert_eq!(summary.angles.to_vec(), integers("summary_angles"));
    assert_eq!(summary.below.to_vec(), integers("summary_below"));
    m.improve().unwrap();
    assert_eq!(m.points().unwrap(), places("block_points"));
    m.set_goal(40).unwrap();
    let stopped = m.improve_with_progress(|_| ControlFlow::Break(())).unwrap_err();
    assert_eq!(stopped.kind(), mgdt::ErrorKind::Cancelled);
    m.check().unwrap();

    let mut bad = mgdt::Mesh::new().unwrap();
    assert!(bad.build().unwrap_err().to_string().contains("no tetrahedra"));
    assert!(bad.set_goal(71).unwrap_err().to_string().contains("71"));
    bad.set_points(&[[0.; 3]; 4]).unwrap();
    assert!(bad.set_tetrahedra(&[[0, 1, 2, 4]], None).is_err());
    assert!(bad.set_tetrahedra(&[[0, 1, 2, 3]], Some(&[1, 2])).is_err());
    bad.set_tetrahedra(&[[0, 1, 2, 3]], None).unwrap();
    assert!(bad.build().unwrap_err().to_string().contains("tetrahedron 0 is flat"));
}

#[test]
fn a_refinement() {
    use std::ops::ControlFlow;
    let markers: Vec<_> = integers("block_given_markers").iter().map(|&k| k as i32).collect();
    let mut m = mgdt::Mesh::new().unwrap();
    m.set_points(&places("block_given_points")).unwrap();
    m.set_tetrahedra(&indices("block_given_tetrahedra"), Some(&markers)).unwrap();
    m.set_faces(&indices::<3>("block_given_faces"), Some(&[9])).unwrap();
    m.build().unwrap();
    m.set_size(0.75).unwrap();
    m.set_gradation(0.5).unwrap();
    m.set_radius_edge(1.5).unwrap();
    m.set_volume(0.125).unwrap();
    m.set_sizes_of_surface(true).unwrap();
    m.set_most_points(2000).unwrap();
    m.set_sizes(mgdt::SizesOf::Regions, &[0.45, 0.0]).unwrap();
    let mut of_points = vec![0.0; 125];
    of_points[0] = 0.3;
    m.set_sizes(mgdt::SizesOf::Points, &of_points).unwrap();
    let mut of_tetrahedra = vec![0.0; 384];
    of_tetrahedra[383] = 0.25;
    m.set_sizes(mgdt::SizesOf::Tetrahedra, &of_tetrahedra).unwrap();
    let field = [[0., 0., 0.], [8., 0., 0.], [0., 8., 0.], [0., 0., 8.]];
    m.set_size_field(&field, &[0.5, 0.75, 0.75, 1.0]).unwrap();
    assert!(m.set_size_field(&field, &[0.5]).is_err());
    m.refine_with_size_function(|place| 0.375 + 0.125 * place[2]).unwrap();
    m.check().unwrap();
    assert_eq!(plain(m.tetrahedra().unwrap()), rows::<4>("refined_tetrahedra"));
    assert_eq!(m.points().unwrap(), places("refined_points"));
    assert_eq!(m.array(mgdt::MeshArray::Refusals).unwrap(), integers("refined_refusals"));
    assert_eq!(m.doubles(mgdt::MeshDoubles::Sizes).unwrap(), doubles("refined_sizes"));
    let refusals = integers("refined_refusals");
    let refused = refusals.iter().filter(|&&r| r != mgdt::Refusal::None as i64).count();
    assert_eq!(m.statistic(mgdt::MeshStatistic::Refused), refused);
    assert_eq!(m.statistic(mgdt::MeshStatistic::InsertedPoints) + 125, m.statistic(mgdt::MeshStatistic::Points));
    m.set_size(0.2).unwrap();
    let stopped = m.refine_with_progress(|_| ControlFlow::Break(())).unwrap_err();
    assert_eq!(stopped.kind(), mgdt::ErrorKind::Cancelled);
    assert_eq!(m.points().unwrap(), places("refined_points"));
    assert!(m.refine_with_size_function(|_| -1.0).is_err());
    let mut heard = 0;
    m.refine_with_progress(|_| {
        heard += 1;
        ControlFlow::Continue(())
    })
    .unwrap();
    assert!(heard > 0);
    m.check().unwrap();
    assert!(m.set_size(-1.0).is_err());
    assert!(m.set_sizes(mgdt::SizesOf::Regions, &[1.0]).is_err());
}

#[test]
fn what_a_domain_refuses() {
    use mgdt::{DomainPart::Facet, ErrorKind};
    let mut d = given_domain();
    let error = d
        .build_with_progress(|_| std::ops::ControlFlow::Break(()))
        .unwrap_err();
    assert_eq!(error.kind(), ErrorKind::Cancelled);
    let panicked = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| {
        d.build_with_progress(|_| panic!("no more"))
    }));
    assert!(panicked.is_err());
    d.build().unwrap();
    let error = d.set_facets(&[[0, 1, 18]], None).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::InvalidArgument);
    assert!(error.message().contains("18"));
    let error = d.set_facets(&[[0, 1, 2]], Some(&[1, 2])).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::InvalidArgument);
    let error = d.set_points(&[[f64::NAN; 3]]).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::NotFinite);
    let crossing = [
        [0.0, 0.0, 0.0],
        [4.0, 0.0, 0.0],
        [0.0, 4.0, 0.0],
        [1.0, 1.0, -1.0],
        [1.0, 1.0, 2.0],
        [5.0, 1.0, 1.0],
    ];
    d.set_points(&crossing).unwrap();
    d.set_facets(&[[0, 1, 2], [3, 4, 5]], None).unwrap();
    let error = d.build().unwrap_err();
    assert_eq!(error.kind(), ErrorKind::InvalidBoundary);
    assert_eq!(d.offending_pairs().unwrap(), [(Facet(0), Facet(1))]);
    assert_eq!(d.validate().unwrap(), [(Facet(0), Facet(1))]);
    let error = d.set_regions(&[[0.0; 3]], &[1, 2]).unwrap_err();
    assert_eq!(error.kind(), ErrorKind::InvalidArgument);
}

#[test]
fn every_export() {
    let t = triangulation();
    assert_eq!(plain(t.tetrahedra().unwrap()), rows::<4>("tetrahedra"));
    assert_eq!(plain(t.hull_facets().unwrap()), rows::<3>("hull_facets"));
    assert_eq!(plain(t.edges().unwrap()), rows::<2>("edges"));
    let neighbors: Vec<_> = t
        .neighbors()
        .unwrap()
        .into_iter()
        .map(|n| n.map(number))
        .collect();
    assert_eq!(neighbors, rows::<4>("neighbors"));
    let map: Vec<_> = t.point_map().unwrap().into_iter().map(number).collect();
    assert_eq!(map, integers("point_map"));

    let around = t.vertex_tetrahedra().unwrap();
    let offsets: Vec<_> = around.offsets().iter().map(|&k| k as i64).collect();
    let list: Vec<_> = around.list().iter().map(|&k| k as i64).collect();
    assert_eq!(offsets, integers("offsets"));
    assert_eq!(list, integers("list"));
    let neighbors = t.vertex_neighbors().unwrap();
    let offsets: Vec<_> = neighbors.offsets().iter().map(|&k| k as i64).collect();
    let list: Vec<_> = neighbors.list().iter().map(|&k| k as i64).collect();
    assert_eq!(offsets, integers("neighbor_offsets"));
    assert_eq!(list, integers("neighbor_list"));
    let signed = |edges: Vec<[usize; 2]>| -> Vec<[i64; 2]> {
        edges.into_iter().map(|e| e.map(|k| k as i64)).collect()
    };
    assert_eq!(
        signed(t.gabriel_edges().unwrap()),
        rows::<2>("gabriel_edges")
    );
    assert_eq!(
        signed(t.spanning_tree().unwrap()),
        rows::<2>("spanning_tree")
    );
    let spheres = t.circumspheres().unwrap();
    let centers: Vec<_> = spheres.iter().flat_map(|s| s.center).collect();
    let squares: Vec<_> = spheres.iter().map(|s| s.squared_radius).collect();
    assert_eq!(centers, doubles("centers"));
    assert_eq!(squares, doubles("squares"));
    assert_eq!(t.alphas(2).unwrap(), doubles("facet_alphas"));
    assert_eq!(t.alphas(1).unwrap(), doubles("edge_alphas"));
    let surface: Vec<[i64; 3]> = t
        .alpha_surface(0.01)
        .unwrap()
        .iter()
        .map(|f| f.map(|k| k as i64))
        .collect();
    assert_eq!(surface, rows::<3>("alpha_surface"));
    assert_eq!(vec![t.solid_alpha().unwrap()], doubles("solid_alpha"));
    let side = |k: usize, sign: f64| {
        let mut plane = [0.0, 0.0, 0.0, if sign > 0.0 { 2.0 } else { 1.0 }];
        plane[k] = sign;
        plane
    };
    let cube: Vec<_> = (0..3).flat_map(|k| [side(k, 1.0), side(k, -1.0)]).collect();
    let measures = |of, planes: &[[f64; 4]]| t.cell_measures(of, planes).unwrap();
    assert_eq!(measures(mgdt::Measure::Volume, &cube), doubles("volumes"));
    assert_eq!(
        measures(mgdt::Measure::Centroid, &cube),
        doubles("centroids")
    );
    assert_eq!(measures(mgdt::Measure::Faces, &[]), doubles("faces"));
    let shapes = |measure| t.tetrahedron_measures(measure).unwrap();
    assert_eq!(
        shapes(mgdt::TetrahedronMeasure::RadiusRatio),
        doubles("radius_ratios")
    );
    assert_eq!(
        shapes(mgdt::TetrahedronMeasure::LargestDihedralAngle),
        doubles("largest_angles")
    );
    diagrams(&t, &cube);
    let places: Vec<[f64; 3]> = doubles("queries")
        .chunks(3)
        .map(|p| [p[0], p[1], p[2]])
        .collect();
    let values = doubles("values");
    let (c1, sibson) = (mgdt::Method::SibsonC1, mgdt::Method::Sibson);
    let outside = mgdt::Outside::Linear;
    let between = t.interpolate(c1, outside, 2, &values, &places).unwrap();
    assert_eq!(between, doubles("interpolated"));
    assert_eq!(
        t.gradients(2, &values).unwrap().concat(),
        doubles("gradients")
    );
    let rows_of_weights = t
        .interpolation_weights(sibson, mgdt::Outside::None, &places)
        .unwrap();
    let weights: Vec<f64> = rows_of_weights.iter().flatten().map(|w| w.1).collect();
    assert_eq!(weights, doubles("row_weights"));
    assert_eq!(rows_of_weights.len(), places.len());
    assert!(t
        .interpolate(c1, outside, 2, &values[1..], &places)
        .is_err());
    let tetrahedra = t.tetrahedra().unwrap();
    for point in [0, 7, 999, 1009] {
        let expected: Vec<_> = (0..tetrahedra.len())
            .filter(|&k| tetrahedra[k].contains(&point))
            .collect();
        assert_eq!(around.of(point), expected);
    }
    assert!(around.of(1009).is_empty(), "a repeated point is no vertex");
}

#[test]
fn every_export_into_slices() {
    fn check<I: mgdt::Int + Default + Into<i64>>(t: &Triangulation) {
        fn wide<I: Into<i64>, const W: usize>(rows: Vec<[I; W]>) -> Vec<[i64; W]> {
            rows.into_iter().map(|row| row.map(Into::into)).collect()
        }
        let mut four = vec![[I::default(); 4]; t.tetrahedron_count()];
        t.tetrahedra_into(&mut four).unwrap();
        assert_eq!(wide(four.clone()), rows::<4>("tetrahedra"));
        t.neighbors_into(&mut four).unwrap();
        assert_eq!(wide(four), rows::<4>("neighbors"));
        let mut three = vec![[I::default(); 3]; t.hull_facet_count()];
        t.hull_facets_into(&mut three).unwrap();
        assert_eq!(wide(three), rows::<3>("hull_facets"));
        let mut two = vec![[I::default(); 2]; t.edge_count()];
        t.edges_into(&mut two).unwrap();
        assert_eq!(wide(two), rows::<2>("edges"));
        let mut one = vec![I::default(); t.point_count()];
        t.point_map_into(&mut one).unwrap();
        assert_eq!(
            one.into_iter().map(Into::into).collect::<Vec<i64>>(),
            integers("point_map")
        );
    }
    let t = triangulation();
    check::<i32>(&t);
    check::<i64>(&t);
    let mut short = vec![[0_i64; 4]; t.tetrahedron_count() - 1];
    let e = t.tetrahedra_into(&mut short).unwrap_err();
    assert_eq!(e.kind(), mgdt::ErrorKind::BufferTooSmall);
    assert!(
        short.iter().all(|row| *row == [0; 4]),
        "what is too small is not touched"
    );
    // More room than needed is fine, and stays as it was.
    let mut long = vec![[77_i32; 4]; t.tetrahedron_count() + 1];
    t.tetrahedra_into(&mut long).unwrap();
    assert_eq!(long.last(), Some(&[77; 4]));
}

#[test]
fn counts_and_figures() {
    let t = triangulation();
    let (v, e, n) = (
        t.vertex_count() as i64,
        t.edge_count() as i64,
        t.tetrahedron_count() as i64,
    );
    let h = t.hull_facet_count() as i64;
    assert_eq!(v - e + (4 * n + h) / 2 - n, 1, "Euler's formula for a ball");
    assert_eq!(
        (t.point_count(), t.vertex_count(), t.dimension()),
        (1010, 1000, Some(3))
    );
    assert_eq!(t.statistic(Statistic::PointsInserted), 1000.0);
    assert_eq!(t.statistic(Statistic::Duplicates), 10.0);
    for statistic in Statistic::ALL {
        assert!(t.statistic(statistic).is_finite() && !statistic.name().is_empty());
    }
    assert_eq!(Statistic::PeakMemoryBytes.to_string(), "peak memory bytes");
    for level in [Check::Combinatorial, Check::Geometric, Check::Canonical] {
        t.check(level).unwrap();
    }
    assert!(format!("{:?}", t).contains("1010"));
}

#[test]
fn the_same_tetrahedra_however_the_points_are_given() {
    let points = places("points");
    let expected = rows::<4>("tetrahedra");
    let column = |axis: usize| points.iter().map(|p| p[axis]).collect::<Vec<_>>();
    let flat: Vec<f64> = points.iter().flatten().copied().collect();
    for order in Order::ALL {
        let mut t = Triangulation::new().unwrap();
        t.set_canonical_output(true);
        t.set_order(order).unwrap();
        t.set_seed(u64::MAX);
        t.set_threads(0).unwrap();
        t.reserve(points.len()).unwrap();
        match order {
            Order::Input => t
                .insert_columns(&column(0), &column(1), &column(2))
                .unwrap(),
            Order::Brio => t
                .insert_strided(points.len(), &flat, &flat[1..], &flat[2..], 3)
                .unwrap(),
            Order::MultiGrid => {
                t.set_parameter(Parameter::PointsPerCell, 3.0).unwrap();
                t.set_parameter(Parameter::Threshold, 20.0).unwrap();
                t.insert(&points).unwrap();
            }
            _ => points.chunks(300).for_each(|some| t.insert(some).unwrap()),
        }
        assert_eq!(plain(t.tetrahedra().unwrap()), expected, "{}", order);
        t.set_isa(Some("baseline")).unwrap();
        assert_eq!(t.isa(), "baseline");
    }
}

#[test]
fn location_and_nearest_vertices() {
    let t = triangulation();
    let points = places("points");
    let queries = places("queries");
    let located = integers("located");
    let weights: Vec<f64> = bytes("weights")
        .into_iter()
        .map(f64::from_ne_bytes)
        .collect();
    let found = t.locate_points(&queries).unwrap();
    let outside = found.iter().filter(|l| l.is_none()).count();
    assert!(outside > 10 && outside < queries.len() - 10);
    let ends = places("segment");
    let (way, parameters) = t.traverse_segment(ends[0], ends[1]).unwrap();
    assert!(way.iter().map(|&k| k as i64).eq(integers("way")));
    assert_eq!(parameters, doubles("way_parameters"));
    assert_eq!(
        t.traverse_segment([5.0; 3], [6.0; 3]).unwrap(),
        (vec![], vec![])
    );
    let tetrahedra = t.tetrahedra().unwrap();
    for (k, location) in found.iter().enumerate() {
        assert_eq!(number(location.map(|l| l.tetrahedron)), located[k]);
        assert_eq!(
            t.locate(queries[k]).unwrap(),
            location.map(|l| l.tetrahedron)
        );
        if let Some(l) = location {
            assert_eq!(l.weights[..], weights[4 * k..4 * k + 4]);
            // The weights give the place back.
            for axis in 0..3 {
                let vertices = tetrahedra[l.tetrahedron];
                let x: f64 = (0..4)
                    .map(|i| l.weights[i] * points[vertices[i]][axis])
                    .sum();
                assert!((x - queries[k][axis]).abs() < 1e-12);
            }
        }
        // Brute force is the truth.
        let distance = |p: &[f64; 3]| (0..3).map(|i| (p[i] - queries[k][i]).powi(2)).sum::<f64>();
        let best = (0..1000).min_by(|&a, &b| {
            distance(&points[a])
                .partial_cmp(&distance(&points[b]))
                .unwrap()
        });
        assert_eq!(t.nearest_vertex(queries[k]).unwrap(), best);
        assert_eq!(number(best), integers("nearest")[k]);
    }
    let mut plain = vec![0_i32; queries.len()];
    t.locate_points_into(&queries, &mut plain, None).unwrap();
    assert!(plain.iter().zip(&located).all(|(&a, &b)| i64::from(a) == b));
    let e = t
        .locate_points_into(&queries, &mut plain[1..], None)
        .unwrap_err();
    assert_eq!(e.kind(), mgdt::ErrorKind::BufferTooSmall);
    let mut few = [[0.0; 4]; 3];
    assert!(t
        .locate_points_into(&queries, &mut plain, Some(&mut few))
        .is_err());
}

#[test]
fn queries_from_many_threads_at_once() {
    fn may_be_shared<T: Send + Sync>() {}
    may_be_shared::<Triangulation>();
    may_be_shared::<Canceller>();
    may_be_shared::<mgdt::Error>();

    let t = triangulation();
    let queries = places("queries");
    let expected = t.locate_points(&queries).unwrap();
    std::thread::scope(|scope| {
        for _ in 0..4 {
            scope.spawn(|| {
                for _ in 0..20 {
                    assert_eq!(t.locate_points(&queries).unwrap(), expected);
                    assert_eq!(plain(t.tetrahedra().unwrap()), rows::<4>("tetrahedra"));
                    t.check(Check::Geometric).unwrap();
                }
            });
        }
    });
    // It may go to another thread, and end there.
    std::thread::spawn(move || drop(t)).join().unwrap();
}

#[test]
fn a_periodic_box() {
    use mgdt::{ErrorKind, Measure, Periodic, PeriodicArray as Array, PeriodicStatistic as Count};
    let vectors = [[4.0, 0.0, 0.0], [1.5, 3.0, 0.0], [-0.75, 0.5, 2.5]];
    let points = places("periodic_given_points");
    let mut p = Periodic::new(&vectors).unwrap();
    p.insert(&points).unwrap();
    let mut heard = 0.0;
    p.build_with_progress(|fraction| {
        heard += fraction;
        std::ops::ControlFlow::Continue(())
    })
    .unwrap();
    assert!(heard > 0.0);
    for again in [false, true] {
        if again {
            p.move_all(&points).unwrap();
            p.move_points(&[3, 1], &[points[3], points[1]]).unwrap();
            p.move_points(&[], &[]).unwrap();
            p.build().unwrap();
        }
        p.check().unwrap();
        for (array, name) in [
            (Array::PointMap, "point_map"),
            (Array::PointShifts, "point_shifts"),
            (Array::Tetrahedra, "tetrahedra"),
            (Array::TetrahedronShifts, "tetrahedron_shifts"),
            (Array::Neighbors, "neighbors"),
            (Array::NeighborShifts, "neighbor_shifts"),
            (Array::VertexNeighborOffsets, "vertex_neighbor_offsets"),
            (Array::VertexNeighbors, "vertex_neighbors"),
            (Array::VertexNeighborShifts, "vertex_neighbor_shifts"),
        ] {
            let expected = integers(&format!("periodic_{}", name));
            assert_eq!(p.array(array).unwrap(), expected, "{}", name);
        }
        for (measure, name) in [
            (Measure::Volume, "volume"),
            (Measure::Area, "area"),
            (Measure::Faces, "faces"),
            (Measure::Centroid, "centroid"),
        ] {
            let expected = doubles(&format!("periodic_{}", name));
            assert_eq!(p.cell_measures(measure).unwrap(), expected, "{}", name);
        }
    }
    assert_eq!(p.points().unwrap(), places("periodic_points"));
    assert_eq!(p.vectors().unwrap(), vectors);
    assert_eq!(plain(p.tetrahedra().unwrap()), rows::<4>("periodic_tetrahedra"));
    let shifts = p.shifts().unwrap();
    let flat: Vec<i64> = shifts.iter().flatten().flatten().copied().collect();
    assert_eq!(flat, integers("periodic_tetrahedron_shifts"));
    let cells = p.voronoi().unwrap();
    assert_eq!(
        cells.array(mgdt::VoronoiArray::FaceShifts).unwrap(),
        integers("periodic_cells_face_shifts")
    );
    assert_eq!(cells.vertices().unwrap(), places("periodic_cells_vertices"));
    let count = |count| p.statistic(count).unwrap();
    assert_eq!(count(Count::Vertices), 38);
    assert_eq!(count(Count::Edges), 38 + count(Count::Tetrahedra));
    assert!(format!("{:?}", p).contains("points: 40"));
    fn crosses_threads<T: Send + Sync>(_: &T) {}
    crosses_threads(&p);

    let kind = |result: Result<Periodic, mgdt::Error>| result.unwrap_err().kind();
    assert_eq!(kind(Periodic::new(&[])), ErrorKind::InvalidArgument);
    assert_eq!(kind(Periodic::new(&[[0.0; 3]])), ErrorKind::InvalidArgument);
    assert_eq!(kind(Periodic::new(&[[f64::NAN; 3]])), ErrorKind::NotFinite);
    let refused = |result: Result<(), mgdt::Error>| result.unwrap_err().kind();
    assert_eq!(refused(p.move_all(&points[1..])), ErrorKind::InvalidArgument);
    assert_eq!(refused(p.move_points(&[1], &[])), ErrorKind::InvalidArgument);
    let stopped = p.build_with_progress(|_| std::ops::ControlFlow::Break(()));
    assert_eq!(refused(stopped), ErrorKind::Cancelled);
    assert_eq!(refused(p.set_vectors(&[])), ErrorKind::InvalidArgument);
    p.set_vectors(&vectors[..2]).unwrap();
    assert_eq!(p.statistic(Count::Dimensions).unwrap(), 2);
    p.set_vectors(&vectors).unwrap();
    p.set_threads(2).unwrap();
    p.set_memory_limit(Some(1)).unwrap();
    assert_eq!(refused(p.build()), ErrorKind::OutOfMemory);
    p.set_memory_limit(None).unwrap();
    assert_eq!(refused(p.set_merge_distance(-1.0)), ErrorKind::InvalidArgument);
    p.set_merge_distance(1e9).unwrap();
    assert_eq!(refused(p.build()), ErrorKind::InvalidArgument);
    p.set_merge_distance(0.0).unwrap();
    p.insert(&[[1e30, 0.0, 0.0]]).unwrap();
    assert_eq!(refused(p.build()), ErrorKind::InvalidArgument);
    p.clear();
    p.build().unwrap();
    assert_eq!(p.statistic(Count::Tetrahedra).unwrap(), 0);
}
