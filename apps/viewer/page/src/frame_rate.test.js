// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Tests of how many points a frame draws.

import assert from "node:assert/strict";
import { test } from "node:test";

import { nextNumberOfPoints } from "./frame_rate.js";

test("a slow frame is followed by one with as few points as time allows", () => {
  assert.equal(nextNumberOfPoints(2000000, 100, 2000000), 666666);
});

test("a fast frame is followed by one with more points, up to all", () => {
  assert.equal(nextNumberOfPoints(100000, 16, 2000000), 125000);
  assert.equal(nextNumberOfPoints(1900000, 16, 2000000), 2000000);
});

test("a frame in time is followed by its like", () => {
  assert.equal(nextNumberOfPoints(500000, 25, 2000000), 500000);
});

test("some points are always drawn", () => {
  assert.equal(nextNumberOfPoints(20000, 5000, 2000000), 20000);
  assert.equal(nextNumberOfPoints(10, 5000, 10), 10);
});
