// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The names of instances: texts of the page that follow places of the scene.

const DARKER = 0.6; // than the box, to be read

export class Names {
  constructor(container, layers) {
    this.labels = layers.flatMap((layer) => layer.names.map((name) => {
      const element = document.createElement("span");
      element.textContent = name.text;
      element.style.color = `color-mix(in srgb, ${name.color} ${100 * DARKER}%, black)`;
      container.append(element);
      return { element, layer, at: name.at };
    }));
  }

  /** Move them to where they are seen. */
  place(camera, { width, height }) {
    for (const { element, layer, at } of this.labels) {
      const seen = at.clone().project(camera);
      element.hidden = !layer.object.visible || seen.z > 1;
      element.style.left = `${((seen.x + 1) / 2) * width}px`;
      element.style.top = `${((1 - seen.y) / 2) * height}px`;
    }
  }
}
