// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The points on the graphics card: their material and their buffers.

import { BufferAttribute, BufferGeometry, Points, ShaderMaterial } from "three";

// A point is a little larger than the distance between points, seen from where it is, so that surfaces are closed; but
// it is seen at all, and no blot.
const VERTEX = `
attribute vec4 tint;
attribute float shade;
uniform float spacing;       // meters, times the user's factor
uniform float growth;        // larger where only some of the points are drawn
uniform float pixels;        // of a length 1 at distance 1
uniform float fixedSize;     // pixels, or 0
uniform float ratio;         // pixels of the screen in one of the page
uniform bool shaded;
varying vec3 color;
void main() {
  vec4 seen = modelViewMatrix * vec4(position, 1.0);
  gl_Position = tint.a > 0.5 ? projectionMatrix * seen : vec4(2.0, 2.0, 2.0, 1.0);
  float touching = 1.4 * growth * spacing * pixels / -seen.z;
  gl_PointSize = fixedSize > 0.0 ? fixedSize * ratio : clamp(touching, 1.5 * ratio, 20.0 * ratio);
  color = shaded ? tint.rgb * shade : tint.rgb;
}`;

const FRAGMENT = `
varying vec3 color;
void main() {
  gl_FragColor = vec4(color, 1.0);
}`;

/** The points of the page's cloud, with four bytes of color each, white at first. */
export function makePoints(cloud) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(cloud.positions, 3));
  geometry.setAttribute("tint", new BufferAttribute(new Uint8Array(4 * cloud.points).fill(255), 4, true));
  const shades = cloud.shades ?? new Uint8Array(cloud.points).fill(255);
  geometry.setAttribute("shade", new BufferAttribute(shades, 1, true));
  const material = new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    uniforms: { spacing: { value: cloud.spacing }, growth: { value: 1 }, pixels: { value: 1 }, ratio: { value: 1 },
                fixedSize: { value: cloud.point_size ?? 0 }, shaded: { value: false } },
  });
  const points = new Points(geometry, material);
  points.frustumCulled = false;
  return points;
}
