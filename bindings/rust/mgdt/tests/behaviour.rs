// SPDX-License-Identifier: MIT
//! What the crate refuses, how it stops, and that it gives memory back.

use mgdt::{Check, ErrorKind, Order, Parameter, Separation, Statistic, Triangulation};
use std::ops::ControlFlow;
use std::panic::{catch_unwind, AssertUnwindSafe};
use std::sync::mpsc;

/// Numbers in [0, 1).
fn random_points(n: usize, mut state: u64) -> Vec<[f64; 3]> {
    let mut next = || {
        state = state
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (state >> 11) as f64 / 9007199254740992.0
    };
    (0..n).map(|_| [next(), next(), next()]).collect()
}

fn with(points: &[[f64; 3]]) -> Triangulation {
    let mut t = Triangulation::new().unwrap();
    t.insert(points).unwrap();
    t
}

#[track_caller]
fn refused<T: std::fmt::Debug>(result: Result<T, mgdt::Error>, kind: ErrorKind, words: &[&str]) {
    let e = result.unwrap_err();
    assert_eq!(e.kind(), kind, "{}", e);
    assert!(!e.message().is_empty() && e.to_string() == e.message());
    for word in words {
        assert!(
            e.message().contains(word),
            "'{}' does not say '{}'",
            e,
            word
        );
    }
}

#[test]
fn a_cube_is_filled() {
    let points: Vec<[f64; 3]> = (0..8)
        .map(|k| [f64::from(k / 4), f64::from(k / 2 % 2), f64::from(k % 2)])
        .collect();
    let t = with(&points);
    let mut total = 0.0;
    for v in t.tetrahedra().unwrap() {
        let [a, b, c, d] = v.map(|k| points[k]);
        let [u, v, w] = [b, c, d].map(|p| [p[0] - a[0], p[1] - a[1], p[2] - a[2]]);
        let six = u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0])
            + u[2] * (v[0] * w[1] - v[1] * w[0]);
        assert!(six > 0.0);
        total += six;
    }
    assert!([5, 6].contains(&t.tetrahedron_count()));
    assert_eq!(total, 6.0);
    assert_eq!(t.hull_facet_count(), 12);
    t.check(Check::Canonical).unwrap();
}

#[test]
fn flat_and_small_sets_are_valid_and_wait() {
    let mut t = Triangulation::new().unwrap();
    assert_eq!(t.dimension(), None);
    assert_eq!(t.nearest_vertex([0.0; 3]).unwrap(), None);
    assert_eq!(t.locate([0.0; 3]).unwrap(), None);
    t.insert(&[]).unwrap();
    for k in 0..100 {
        t.insert(&[[f64::from(k / 10), f64::from(k % 10), 0.0]])
            .unwrap();
    }
    assert_eq!(
        (t.dimension(), t.tetrahedron_count(), t.vertex_count()),
        (Some(2), 0, 100)
    );
    assert!(t.tetrahedra().unwrap().is_empty() && t.neighbors().unwrap().is_empty());
    assert!(t.vertex_tetrahedra().unwrap().of(3).is_empty());
    assert_eq!(t.nearest_vertex([3.2, 4.1, 7.0]).unwrap(), Some(34));
    t.check(Check::Canonical).unwrap();
    t.insert(&[[0.0, 0.0, 1.0]]).unwrap();
    assert_eq!(t.dimension(), Some(3));
    assert!(t.tetrahedron_count() >= 162);
    t.check(Check::Canonical).unwrap();
    t.clear();
    assert_eq!(t.point_count(), 0);
    t.insert(&[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
        .unwrap();
    assert_eq!(t.tetrahedron_count(), 1);
}

#[test]
fn points_leave_move_and_get_other_numbers() {
    let mut points = random_points(200, 3);
    let mut t = with(&points);
    t.set_canonical_output(true);
    let out: Vec<usize> = (0..200).step_by(2).collect();
    let some: Vec<usize> = (1..200).step_by(4).collect();
    for &k in &some {
        points[k][2] += 1.0;
    }
    let places: Vec<[f64; 3]> = some.iter().map(|&k| points[k]).collect();
    t.move_points(&some, &places).unwrap();
    t.remove(&out).unwrap();
    for &k in &out {
        points[k] = [f64::NAN; 3];
    }
    t.move_all(&points).unwrap();
    assert_eq!(t.statistic(Statistic::PointsMoved), 50.0);
    let numbers = t.renumber().unwrap();
    assert_eq!(numbers[..4], [None, Some(0), None, Some(1)]);
    let rest: Vec<[f64; 3]> = points.into_iter().skip(1).step_by(2).collect();
    let mut fresh = with(&rest);
    fresh.set_canonical_output(true);
    assert_eq!(t.tetrahedra().unwrap(), fresh.tetrahedra().unwrap());
    t.check(Check::Canonical).unwrap();
    let wrong = ErrorKind::InvalidArgument;
    refused(t.remove(&[3, 3]), wrong, &["point 3"]);
    refused(t.remove(&[100]), wrong, &["no point 100"]);
    refused(t.remove(&[usize::MAX]), wrong, &[]);
    refused(t.move_points(&[3], &[]), wrong, &["1 points and 0"]);
    refused(t.move_all(&[[0.0; 3]]), wrong, &["1 places"]);
    let nowhere = [[0.0, f64::NAN, 0.0]];
    refused(t.move_points(&[3], &nowhere), ErrorKind::NotFinite, &["point 3"]);
    t.canceller().cancel();
    refused(t.remove(&[3]), ErrorKind::Cancelled, &["after 0 of 1"]);
    t.remove(&[]).unwrap();
    t.move_points(&[], &[]).unwrap();
    assert_eq!(t.vertex_count(), 100);
}

#[test]
fn bad_values_are_refused_and_change_nothing() {
    let points = random_points(100, 1);
    let mut t = with(&points);
    let before = t.tetrahedra().unwrap();
    let nan = [0.0, f64::NAN, 0.0];
    refused(
        t.insert(&[[0.0; 3], nan]),
        ErrorKind::NotFinite,
        &["point 101", "y"],
    );
    let infinite = [f64::NEG_INFINITY, 0.0, 0.0];
    refused(
        t.insert(&[infinite]),
        ErrorKind::NotFinite,
        &["point 100", "x"],
    );
    refused(t.locate(nan), ErrorKind::NotFinite, &[]);
    refused(t.nearest_vertex(nan), ErrorKind::NotFinite, &[]);
    refused(
        t.locate_points(&[[0.0; 3], nan]),
        ErrorKind::NotFinite,
        &["1"],
    );
    refused(
        t.insert_columns(&[0.0], &[0.0, 1.0], &[0.0]),
        ErrorKind::InvalidArgument,
        &["1, 2"],
    );
    let x = [0.0; 7];
    refused(
        t.insert_strided(3, &x, &x[1..], &x[2..], 3),
        ErrorKind::InvalidArgument,
        &["y has 6 elements"],
    );
    refused(
        t.insert_strided(usize::MAX, &x, &x, &x, 2),
        ErrorKind::InvalidArgument,
        &["too few"],
    );
    refused(
        t.set_parameter(Parameter::Threshold, -1.0),
        ErrorKind::InvalidArgument,
        &["-1"],
    );
    refused(t.set_isa(Some("mmx")), ErrorKind::InvalidArgument, &["mmx"]);
    refused(t.set_isa(Some("a\0b")), ErrorKind::InvalidArgument, &[]);
    refused(t.reserve(usize::MAX), ErrorKind::TooLarge, &[]);
    refused(
        "spiral".parse::<Order>(),
        ErrorKind::UnknownScheme,
        &["spiral"],
    );
    refused("a\0".parse::<Order>(), ErrorKind::UnknownScheme, &[]);
    assert_eq!(Order::available(), Order::ALL);
    for order in Order::ALL {
        assert_eq!(order.name().parse::<Order>().unwrap(), order);
    }
    assert_eq!(Order::MultiGrid.to_string(), "multi-grid");
    assert_eq!(t.point_count(), 100);
    assert_eq!(t.tetrahedra().unwrap(), before);
    t.check(Check::Canonical).unwrap();
    let parts: Vec<_> = mgdt::version()
        .split('.')
        .map(|p| p.parse::<u32>())
        .collect();
    assert!(parts.len() == 3 && parts.iter().all(|p| p.is_ok()));
}

#[test]
fn the_memory_limit() {
    let points = random_points(1000, 2);
    let mut t = Triangulation::new().unwrap();
    t.set_memory_limit(Some(100_000)).unwrap();
    refused(t.insert(&points), ErrorKind::OutOfMemory, &["memory"]);
    t.check(Check::Canonical).unwrap();
    assert!(t.statistic(Statistic::PeakMemoryBytes) <= 100_000.0);
    t.set_memory_limit(Some(0)).unwrap();
    refused(t.insert(&points), ErrorKind::OutOfMemory, &[]);
    t.set_memory_limit(None).unwrap();
    t.insert(&points).unwrap();
    assert_eq!(t.vertex_count(), 1000);
    t.check(Check::Canonical).unwrap();
}

#[test]
fn settings_are_read_as_they_are_set() {
    let mut t = Triangulation::new().unwrap();
    assert_eq!(
        (t.order(), t.seed(), t.threads()),
        (Some(Order::Auto), 0, 1)
    );
    assert_eq!(t.memory_limit(), None);
    assert_eq!((t.compact(), t.canonical_output()), (false, false));
    assert_eq!(
        t.parameter(Parameter::Separation),
        f64::from(Separation::Rounds)
    );
    t.set_order(Order::KdTree).unwrap();
    t.set_seed(u64::MAX);
    t.set_threads(3).unwrap();
    t.set_memory_limit(Some(1 << 40)).unwrap();
    t.set_compact(true).unwrap();
    t.set_canonical_output(true);
    t.set_parameter(Parameter::Separation, Separation::Passes.into())
        .unwrap();
    t.set_parameter(Parameter::Threshold, 50.0).unwrap();
    assert_eq!(
        (t.order(), t.seed(), t.threads()),
        (Some(Order::KdTree), u64::MAX, 3)
    );
    assert_eq!(t.memory_limit(), Some(1 << 40));
    assert_eq!((t.compact(), t.canonical_output()), (true, true));
    assert_eq!(t.parameter(Parameter::Separation), 1.0);
    assert_eq!(t.parameter(Parameter::Threshold), 50.0);
    t.insert(&random_points(1000, 3)).unwrap();
    let before = t.statistic(Statistic::MemoryBytes);
    t.shrink();
    assert!(t.statistic(Statistic::MemoryBytes) < before);
    t.check(Check::Canonical).unwrap();
}

#[test]
fn many_nearest_vertices() {
    let points = random_points(500, 4);
    let places = random_points(300, 5);
    let t = with(&points);
    let found = t.nearest_vertices(&places).unwrap();
    let mut few = vec![0_i32; places.len()];
    t.nearest_vertices_into(&places, &mut few).unwrap();
    for (k, &place) in places.iter().enumerate() {
        assert_eq!(found[k], t.nearest_vertex(place).unwrap());
        assert_eq!(found[k], Some(few[k] as usize));
    }
    refused(
        t.nearest_vertices_into(&places, &mut few[1..]),
        ErrorKind::BufferTooSmall,
        &["299", "300"],
    );
    assert_eq!(
        Triangulation::new()
            .unwrap()
            .nearest_vertices(&places[..1])
            .unwrap(),
        [None]
    );
}

#[test]
fn compact_storage() {
    let points = random_points(1000, 2);
    let mut t = Triangulation::new().unwrap();
    t.insert(&points).unwrap();
    let tetrahedra = t.tetrahedra().unwrap();
    let before = t.statistic(Statistic::MemoryBytes);
    t.set_compact(true).unwrap();
    let after = t.statistic(Statistic::MemoryBytes);
    assert!(after < before - 100.0 * 1000.0);
    t.check(Check::Canonical).unwrap();
    t.set_memory_limit(Some(1)).unwrap();
    refused(t.set_compact(false), ErrorKind::OutOfMemory, &["memory"]);
    t.set_memory_limit(None).unwrap();
    t.set_compact(false).unwrap();
    assert!(t.statistic(Statistic::MemoryBytes) > after);
    assert_eq!(t.tetrahedra().unwrap(), tetrahedra);
    t.check(Check::Canonical).unwrap();
}

#[test]
fn progress_and_stopping() {
    let points = random_points(1000, 3);
    let mut seen = Vec::new();
    let mut t = Triangulation::new().unwrap();
    t.insert_with_progress(&points, |fraction| {
        seen.push(fraction);
        ControlFlow::Continue(())
    })
    .unwrap();
    assert!(seen.len() > 50 && seen.windows(2).all(|w| w[0] <= w[1]));
    assert_eq!(seen.last(), Some(&1.0));

    for by_token in [false, true] {
        let mut t = Triangulation::new().unwrap();
        let canceller = t.canceller();
        let result = t.insert_with_progress(&points, |fraction| {
            if fraction > 0.4 && by_token {
                canceller.cancel();
            }
            if fraction > 0.4 && !by_token {
                return ControlFlow::Break(());
            }
            ControlFlow::Continue(())
        });
        refused(result, ErrorKind::Cancelled, &["1000 points"]);
        assert!(t.vertex_count() > 100 && t.vertex_count() < 1000);
        t.check(Check::Canonical).unwrap();
        // The closure is gone: this one hears of nothing and is not stopped.
        t.insert(&points).unwrap();
        assert_eq!(t.vertex_count(), 1000);
        t.check(Check::Canonical).unwrap();
    }
}

#[test]
fn stopping_from_another_thread() {
    let points = random_points(20_000, 4);
    let mut t = Triangulation::new().unwrap();
    t.set_order(Order::Random).unwrap();
    let canceller = t.canceller();
    std::thread::scope(|scope| {
        let (started, is_started) = mpsc::channel();
        let (cancelled, is_cancelled) = mpsc::channel::<()>();
        let worker = scope.spawn(|| {
            let t = &mut t;
            t.insert_with_progress(&points, move |_| {
                // The first call waits until the other thread has cancelled.
                if started.send(()).is_ok() {
                    let _ = is_cancelled.recv();
                }
                ControlFlow::Continue(())
            })
        });
        is_started.recv().unwrap();
        drop(is_started);
        canceller.clone().cancel();
        drop(cancelled);
        refused(worker.join().unwrap(), ErrorKind::Cancelled, &[]);
    });
    assert!(t.vertex_count() < 20_000);
    t.check(Check::Geometric).unwrap();
    canceller.cancel();
    refused(t.insert(&points), ErrorKind::Cancelled, &[]);
    drop(t);
    canceller.cancel(); // of what is gone: nothing happens
}

#[test]
fn a_panic_in_the_closure_comes_out() {
    let points = random_points(1000, 5);
    for at in [0.0, 0.5, 1.0] {
        let mut t = Triangulation::new().unwrap();
        let mut calls_after = 0;
        let mut panicked = false;
        let caught = catch_unwind(AssertUnwindSafe(|| {
            t.insert_with_progress(&points, |fraction| {
                if panicked {
                    calls_after += 1;
                }
                if fraction >= at {
                    panicked = true;
                    std::panic::panic_any("what I say");
                }
                ControlFlow::Continue(())
            })
        }));
        assert_eq!(
            caught.unwrap_err().downcast_ref::<&str>(),
            Some(&"what I say")
        );
        assert_eq!(calls_after, 0);
        t.check(Check::Canonical).unwrap();
        t.insert(&points).unwrap();
        assert_eq!(t.vertex_count(), 1000);
    }
}
