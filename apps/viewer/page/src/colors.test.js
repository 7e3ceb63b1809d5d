// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Tests of the colors of points.

import assert from "node:assert/strict";
import { test } from "node:test";

import { paintCloud, stepOf } from "./colors.js";

const legend = [{ name: "none", color: "#cdcdcd" }, { name: "edge", color: "#cd1437" }];
const edges = { kind: "labels", legend, values: Uint8Array.of(0, 1, 0), nothing: 0 };
const numbers = { kind: "numbers", range: [0, 2], values: Float32Array.of(-1, 2, NaN) };
const cloud = { points: 3, viridis: ["#000001", "#000002", "#000003"] };

function painted(field, over = [], hidden = new Set()) {
  const colors = new Uint8Array(12);
  paintCloud(cloud, field, over, hidden, colors);
  return [...colors];
}

test("labels have the colors of the legend, and alpha 0 where they are hidden", () => {
  assert.deepEqual(painted(edges, [], new Set([0])), [205, 205, 205, 0, 205, 20, 55, 255, 205, 205, 205, 0]);
});

test("numbers have the colors of the scale, beyond its ends those of the ends, NaN gray", () => {
  assert.deepEqual(painted(numbers), [0, 0, 1, 255, 0, 0, 3, 255, 150, 150, 150, 255]);
});

test("a field on top paints only what it has labels for", () => {
  assert.deepEqual(painted(numbers, [edges]), [0, 0, 1, 255, 205, 20, 55, 255, 150, 150, 150, 255]);
});

test("colors are as they are", () => {
  assert.deepEqual(painted({ kind: "colors", values: Uint8Array.of(1, 2, 3, 4, 5, 6, 7, 8, 9) }),
                   [1, 2, 3, 255, 4, 5, 6, 255, 7, 8, 9, 255]);
});

test("a number's place on the scale is rounded", () => {
  assert.equal(stepOf(0.24, [0, 1], 3), 0);
  assert.equal(stepOf(0.26, [0, 1], 3), 1);
});
