// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What is drawn over the points: creases, boxes of instances, grasps, normals.

import { BufferGeometry, Color, ConeGeometry, CylinderGeometry, Float32BufferAttribute, Group, HemisphereLight,
         InstancedMesh, LineBasicMaterial, LineSegments, Matrix4, MeshLambertMaterial, Quaternion, SphereGeometry,
         Vector3 } from "three";

const Y = new Vector3(0, 1, 0);
const GREEN = "#239b4b", RED = "#cd1437", DARK = "#5f5f5f";

/** Copies of a shape that lies along y: each {at, along, scale: [width, length], color}. */
function copiesOf(shape, places) {
  const mesh = new InstancedMesh(shape, new MeshLambertMaterial(), places.length);
  const matrix = new Matrix4(), turn = new Quaternion();
  places.forEach(({ at, along, scale: [width, length], color }, i) => {
    turn.setFromUnitVectors(Y, along);
    mesh.setMatrixAt(i, matrix.compose(at, turn, new Vector3(width, length, width)));
    mesh.setColorAt(i, new Color(color));
  });
  mesh.frustumCulled = false;
  return mesh;
}

function vectorOf(array) {
  return new Vector3(...array);
}

/** The straight parts of a line, as cylinders. */
function tubesOf({ points, spacing, color }) {
  const radius = 1.5 * spacing; // partly below the points
  return points.slice(1).map((point, i) => {
    const from = vectorOf(points[i]), to = vectorOf(point);
    const along = to.clone().sub(from);
    const length = along.length();
    return { at: from.add(to).multiplyScalar(0.5), along: along.normalize(), scale: [radius, length], color };
  });
}

function jointsOf({ points, spacing, color }) {
  return points.map((point) => ({ at: vectorOf(point), along: Y, scale: [1.5 * spacing, 1.5 * spacing], color }));
}

function linesOf(lines) {
  return [copiesOf(new CylinderGeometry(1, 1, 1, 10, 1, true), lines.flatMap(tubesOf)),
          copiesOf(new SphereGeometry(1, 10, 6), lines.flatMap(jointsOf))];
}

function segmentsOf(corners, color) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new Float32BufferAttribute(corners, 3));
  return new LineSegments(geometry, new LineBasicMaterial({ color }));
}

/** The twelve edges of a box. */
function boxOf({ min, max, color }) {
  const corner = (bits) => [0, 1, 2].map((axis) => ((bits >> axis) & 1 ? max : min)[axis]);
  const corners = [];
  for (let bits = 0; bits < 8; ++bits)
    for (let axis = 0; axis < 3; ++axis)
      if (!((bits >> axis) & 1))
        corners.push(...corner(bits), ...corner(bits | (1 << axis)));
  return segmentsOf(corners, color);
}

/** An arrow whose tip is at the place, and the suction cup's disc, for each grasp. */
function graspsOf({ grasps, cup_radius }) {
  const LENGTH = 4 * cup_radius, TIP = 0.3; // of the length
  const shafts = [], tips = [], discs = [];
  for (const { position, approach, seals } of grasps) {
    const color = seals ? GREEN : RED;
    const along = vectorOf(approach).negate(); // out of the surface
    const above = (length) => vectorOf(position).addScaledVector(along, length);
    shafts.push({ at: above(((1 + TIP) / 2) * LENGTH), along, scale: [0.03 * LENGTH, (1 - TIP) * LENGTH], color });
    tips.push({ at: above((TIP / 2) * LENGTH), along: along.clone().negate(), scale: [0.1 * LENGTH, TIP * LENGTH],
                color });
    discs.push({ at: above(0.1 * cup_radius), along, scale: [cup_radius, 0.01 * cup_radius], color });
  }
  return [copiesOf(new CylinderGeometry(1, 1, 1, 12), shafts), copiesOf(new ConeGeometry(1, 1, 16), tips),
          copiesOf(new CylinderGeometry(1, 1, 1, 40), discs)];
}

/** A stroke along each normal. */
function normalsOf({ places, directions, length }) {
  const corners = places.flatMap((place, i) => [...place, ...place.map((p, axis) => p + length * directions[i][axis])]);
  return [segmentsOf(corners, DARK)];
}

function groupOf(objects) {
  const group = new Group();
  group.add(...objects, new HemisphereLight("#ffffff", "#888888", 3));
  return group;
}

/** The layers that the page has, each {name, object, on, names}: names are texts at places. */
export function makeLayers(cloud) {
  const layers = [];
  const add = (name, objects, on, names = []) => layers.push({ name, object: groupOf(objects), on, names });
  if (cloud.lines)
    add("Creases as lines", linesOf(cloud.lines), true);
  if (cloud.instances)
    add("Boxes of instances", cloud.instances.map(boxOf), true,
        cloud.instances.map(({ name, color, min, max }) =>
          ({ text: name, color, at: vectorOf(min).add(vectorOf(max)).multiplyScalar(0.5) })));
  if (cloud.grasps)
    add("Grasps", graspsOf(cloud.grasps), true);
  if (cloud.arrows)
    add("Normals", normalsOf(cloud.arrows), cloud.arrows.on);
  return layers;
}
