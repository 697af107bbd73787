// SPDX-License-Identifier: MIT
//! A first program: the corners of a cube and its centre, and what mgdt says of them.
//!
//!     cargo run --example cube

fn main() -> Result<(), mgdt::Error> {
    let mut points = vec![[0.5, 0.5, 0.5]];
    for k in 0..8 {
        points.push([f64::from(k / 4), f64::from(k / 2 % 2), f64::from(k % 2)]);
    }
    let mut t = mgdt::Triangulation::new()?;
    t.set_canonical_output(true);
    t.insert(&points)?;
    t.check(mgdt::Check::Canonical)?;

    let tetrahedra = t.tetrahedra()?;
    let volume: f64 = tetrahedra
        .iter()
        .map(|v| volume(v.map(|k| points[k])))
        .sum();
    println!(
        "{} tetrahedra, {} triangles on the hull, volume {}",
        tetrahedra.len(),
        t.hull_facet_count(),
        volume
    );
    println!(
        "nearest to (0.9, 0.1, 0.8): point {:?}",
        t.nearest_vertex([0.9, 0.1, 0.8])?
    );
    println!("outside: {:?}", t.locate([2.0, 2.0, 2.0])?);

    match t.insert(&[[0.0; 3], [0.0, f64::NAN, 0.0]]) {
        Err(e) if e.kind() == mgdt::ErrorKind::NotFinite => println!("refused: {}", e),
        other => other?,
    }
    Ok(())
}

fn volume([a, b, c, d]: [[f64; 3]; 4]) -> f64 {
    let [u, v, w] = [b, c, d].map(|p| [p[0] - a[0], p[1] - a[1], p[2] - a[2]]);
    (u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0])
        + u[2] * (v[0] * w[1] - v[1] * w[0]))
        / 6.0
}
