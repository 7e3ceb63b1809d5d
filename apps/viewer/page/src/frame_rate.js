// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// How many points a frame may draw while the camera moves.

const WANTED = 1000 / 30; // milliseconds a frame
const COMFORTABLE = 1000 / 50;
const FEWEST = 20000; // still show the shape of a cloud

/** The number of points of the next frame, after one of `drawn` points took `milliseconds`. The points are in random
 *  order, so that any first part of them is an even sample. */
export function nextNumberOfPoints(drawn, milliseconds, points) {
  if (milliseconds > WANTED)
    return Math.min(points, Math.max(FEWEST, Math.floor((drawn * WANTED) / milliseconds)));
  if (milliseconds < COMFORTABLE)
    return Math.min(points, Math.ceil(drawn * 1.25));
  return drawn;
}
