// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The point under the mouse, and its values.

import { Vector3, Vector4 } from "three";

const NEAR = 8; // pixels between the click and a point
const MOVED = 4; // pixels: more is no click

/** The visible point nearest to the camera of those near a place of the window, or -1. */
function pointAt(x, y, cloud, tints, camera, { width, height }) {
  const matrix = camera.projectionMatrix.clone().multiply(camera.matrixWorldInverse);
  const clip = new Vector4();
  let best = -1, least = Infinity;
  for (let i = 0; i < cloud.points; ++i) {
    if (tints[4 * i + 3] === 0)
      continue;
    clip.set(cloud.positions[3 * i], cloud.positions[3 * i + 1], cloud.positions[3 * i + 2], 1).applyMatrix4(matrix);
    const dx = ((clip.x / clip.w + 1) / 2) * width - x, dy = ((1 - clip.y / clip.w) / 2) * height - y;
    const aside = Math.hypot(dx, dy);
    if (clip.w <= 0 || aside > NEAR)
      continue;
    const distance = clip.w * (1 + 0.01 * aside); // of points of one surface, the one in the middle
    if (distance < least)
      [best, least] = [i, distance];
  }
  return best;
}

function valueOf(field, point) {
  if (field.kind === "labels")
    return field.legend[field.values[point]].name;
  if (field.kind === "numbers")
    return Number.isNaN(field.values[point]) ? "unknown" : field.values[point].toPrecision(5);
  return [...field.values.subarray(3 * point, 3 * point + 3)].join(", ");
}

/** Pairs of names and values: the coordinates as in the file, and the fields. */
export function describe(cloud, point) {
  const at = [0, 1, 2].map((axis) => (cloud.positions[3 * point + axis] + cloud.offset[axis]).toFixed(4));
  return [["x, y, z", `${at.join(", ")} m`],
          ...cloud.fields.filter((field) => field.values).map((field) => [field.title, valueOf(field, point)])];
}

/** Show the values of the point that is clicked. */
export function describeClicks(canvas, output, view, cloud) {
  let start = new Vector3();
  canvas.addEventListener("pointerdown", (event) => { start = new Vector3(event.clientX, event.clientY, 0); });
  canvas.addEventListener("pointerup", (event) => {
    if (start.distanceTo(new Vector3(event.clientX, event.clientY, 0)) > MOVED)
      return;
    const tints = view.points.geometry.getAttribute("tint").array;
    const point = pointAt(event.clientX, event.clientY, cloud, tints, view.camera, view.sizes());
    output.hidden = point < 0;
    output.replaceChildren();
    if (point >= 0)
      output.append(tableOf(describe(cloud, point)));
  });
}

function tableOf(rows) {
  const table = document.createElement("table");
  for (const row of rows) {
    const line = table.insertRow();
    for (const text of row)
      line.insertCell().textContent = text;
  }
  return table;
}
