// SPDX-License-Identifier: MIT
// Writes unions and differences of random solids, made by the npm package manifold-3d, as OFF files.
//
//   node csg.mjs MANIFOLD_JS FOLDER
import { writeFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

const [script, folder] = process.argv.slice(2);
const module = await import(pathToFileURL(script).href);
const wasm = await module.default();
wasm.setup();
const { Manifold } = wasm;

let state = 2014n;
const mask = (1n << 64n) - 1n;
function random() {
  state = (state * 6364136223846793005n + 1442695040888963407n) & mask;
  return Number(state >> 11n) / 2 ** 53;
}

function solid() {
  const kind = Math.floor(3 * random());
  const size = 0.3 + random();
  const made = kind === 0 ? Manifold.cube([size, 0.5 + random(), 0.5 + random()], true)
    : kind === 1 ? Manifold.sphere(size / 1.5, 8 + 4 * Math.floor(6 * random()))
    : Manifold.cylinder(0.5 + 2 * random(), size / 2, size / 2, 8 + Math.floor(24 * random()), true);
  return made.rotate([360 * random(), 360 * random(), 360 * random()])
    .translate([random(), random(), random()]);
}

for (let k = 0; k < 60; ++k) {
  let whole = solid();
  for (let part = 2 + Math.floor(8 * random()); part > 0; --part)
    whole = random() < 0.6 ? whole.add(solid()) : whole.subtract(solid());
  const mesh = whole.getMesh();
  const lines = [];
  for (let i = 0; i < mesh.vertProperties.length; i += mesh.numProp)
    lines.push(mesh.vertProperties.slice(i, i + 3).join(" "));
  const points = lines.length;
  for (let i = 0; i < mesh.triVerts.length; i += 3)
    lines.push("3 " + mesh.triVerts.slice(i, i + 3).join(" "));
  if (points > 0)
    writeFileSync(`${folder}/csg-${String(k).padStart(2, "0")}.off`,
      `OFF\n${points} ${lines.length - points} 0\n${lines.join("\n")}\n`);
}
console.log("done");
