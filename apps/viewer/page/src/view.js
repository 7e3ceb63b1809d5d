// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Draws the scene when something has changed, with fewer points while the camera moves if all take too long.

import { Color, ColorManagement, LinearSRGBColorSpace, PerspectiveCamera, Scene, Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";

import { nextNumberOfPoints } from "./frame_rate.js";

const REST = 150; // milliseconds without movement before all points are drawn again
const RADIANS = Math.PI / 180;
const WIDEST = 110; // degrees from bottom to top; beyond, the picture is distorted

// Colors are as they are written: the same as in pcl_shape_viewer.
ColorManagement.enabled = false;

export class View {
  /** `onDrawn` is called after each frame. */
  constructor(canvas, cloud, points, onDrawn) {
    this.cloud = cloud;
    this.points = points;
    this.onDrawn = onDrawn;
    this.budget = cloud.points;
    this.lastMove = -Infinity;
    this.renderer = new WebGLRenderer({ canvas, antialias: true });
    this.renderer.outputColorSpace = LinearSRGBColorSpace;
    this.renderer.setClearColor(new Color(1, 1, 1));
    this.scene = new Scene();
    this.scene.add(points);
    this.camera = new PerspectiveCamera();
    this.camera.up.fromArray(cloud.camera.up).normalize();
    this.camera.position.fromArray(cloud.camera.position);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.zoomToCursor = true;
    this.controls.rotateSpeed = 0.5; // half a turn for the height of the window
    this.controls.listenToKeyEvents(canvas);
    this.reset();
    this.controls.addEventListener("change", () => this.moved());
    new ResizeObserver(() => this.resize()).observe(canvas);
    this.resize();
  }

  /** Back to the camera that the page begins with. */
  reset() {
    const { position, focus } = this.cloud.camera;
    this.camera.position.fromArray(position);
    this.controls.target.fromArray(focus);
    this.controls.update();
    this.draw();
  }

  moved() {
    this.lastMove = performance.now();
    this.draw();
  }

  /** As wide a view as the page was made for, or as high a one where the window is narrower. */
  resize() {
    const { canvas, width, height } = this.sizes();
    this.renderer.setPixelRatio(window.devicePixelRatio);
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    const { angle, aspect } = this.cloud.camera;
    const half = Math.tan((angle * RADIANS) / 2) * Math.max(1, aspect / this.camera.aspect);
    this.camera.fov = Math.min(WIDEST, (2 * Math.atan(half)) / RADIANS);
    const { uniforms } = this.points.material;
    uniforms.ratio.value = window.devicePixelRatio;
    uniforms.pixels.value = canvas.height / 2 / Math.tan((this.camera.fov * RADIANS) / 2);
    this.draw();
  }

  sizes() {
    const canvas = this.renderer.domElement;
    return { canvas, width: canvas.clientWidth || 1, height: canvas.clientHeight || 1 };
  }

  /** Draw at the next chance. */
  draw() {
    this.frame ??= requestAnimationFrame((time) => this.drawFrame(time));
  }

  drawFrame(time) {
    this.frame = undefined;
    const moving = performance.now() - this.lastMove < REST;
    if (moving && this.lastFrame !== undefined)
      this.budget = nextNumberOfPoints(this.budget, time - this.lastFrame, this.cloud.points);
    this.lastFrame = moving ? time : undefined;
    this.render(moving ? this.budget : this.cloud.points);
    if (moving)
      this.draw();
  }

  render(points) {
    this.points.geometry.setDrawRange(0, points);
    this.points.material.uniforms.growth.value = Math.sqrt(this.cloud.points / points);
    const distance = this.camera.position.distanceTo(this.controls.target);
    const { radius } = this.cloud;
    this.camera.near = Math.max(1e-3 * distance, 1e-6 * radius);
    this.camera.far = 4 * (distance + this.camera.position.distanceTo(new Vector3(...this.cloud.center)) + radius);
    this.camera.updateProjectionMatrix();
    this.renderer.render(this.scene, this.camera);
    this.onDrawn(points);
  }

  /** What is seen now, as a PNG. */
  async picture() {
    this.render(this.cloud.points);
    return new Promise((resolve) => this.renderer.domElement.toBlob(resolve, "image/png"));
  }
}
