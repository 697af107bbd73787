// SPDX-License-Identifier: MIT
//! Alone in its process, since it measures that.

use mgdt::{Statistic, Triangulation};

fn resident() -> f64 {
    let text = std::fs::read_to_string("/proc/self/statm").unwrap();
    text.split(' ').nth(1).unwrap().parse::<f64>().unwrap() * 4096.0
}

fn make(points: &[[f64; 3]]) -> f64 {
    let mut held = 0.0;
    for _ in 0..1000 {
        let mut t = Triangulation::new().unwrap();
        let canceller = t.canceller();
        t.insert(points).unwrap();
        held += t.statistic(Statistic::MemoryBytes);
        drop(t);
        canceller.cancel();
    }
    held
}

#[test]
fn handles_are_freed() {
    let mut state = 1_u64;
    let mut next = || {
        state = state
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (state >> 11) as f64 / 9007199254740992.0
    };
    let points: Vec<_> = (0..1000).map(|_| [next(), next(), next()]).collect();
    make(&points);
    let before = resident();
    let held = make(&points);
    let grown = resident() - before;
    println!(
        "{:.0} MB in 1000 handles; the process grew by {:.1} MB",
        held / 1e6,
        grown / 1e6
    );
    assert!(held > 200e6);
    assert!(grown < 20e6);
}
