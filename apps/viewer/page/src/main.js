// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Begins with the page: reads the cloud, draws it, and fills the panel.

import { paintCloud } from "./colors.js";
import { readCloud } from "./data.js";
import { makeLayers } from "./layers.js";
import { Names } from "./names.js";
import { showFields, showLayers, showLegend, switchPanel } from "./panel.js";
import { describeClicks } from "./pick.js";
import { makePoints } from "./points.js";
import { View } from "./view.js";

const element = (id) => document.getElementById(id);

/** The field that colors the points, those painted on top of it, and the labels that are hidden, by field. */
class State {
  constructor(cloud) {
    this.field = cloud.fields[0];
    this.over = new Set();
    this.hidden = new Map();
  }

  hiddenOf(field) {
    if (!this.hidden.has(field))
      this.hidden.set(field, new Set());
    return this.hidden.get(field);
  }
}

function showTexts(cloud) {
  document.title = cloud.title;
  element("title").textContent = cloud.title;
  element("note").textContent = cloud.note;
  element("made_by").textContent = cloud.made_by;
}

/** Give the user a file. */
function download(blob, name) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  URL.revokeObjectURL(link.href);
}

function connectButtons(view, points, cloud) {
  element("reset").addEventListener("click", () => view.reset());
  element("save").addEventListener("click", async () => download(await view.picture(), `${cloud.title}.png`));
  element("point_size").addEventListener("input", (event) => {
    const factor = 2 ** event.target.valueAsNumber;
    points.material.uniforms.spacing.value = cloud.spacing * factor;
    points.material.uniforms.fixedSize.value = (cloud.point_size ?? 0) * factor;
    view.draw();
  });
}

/** Shading is a layer to the user, and a part of the material. */
function shadingOf(cloud, points) {
  const set = (shaded) => { points.material.uniforms.shaded.value = shaded; };
  set(cloud.shaded);
  return { name: "Shading by normals", on: cloud.shaded, set };
}

function start() {
  const cloud = readCloud(document);
  showTexts(cloud);
  const points = makePoints(cloud);
  const layers = makeLayers(cloud);
  const names = new Names(element("names"), layers);
  const view = new View(element("view"), cloud, points, (drawn) => {
    names.place(view.camera, view.sizes());
    document.body.dataset.drawn = drawn;
  });
  for (const { object, on } of layers) {
    object.visible = on;
    view.scene.add(object);
  }

  const state = new State(cloud);
  const tint = points.geometry.getAttribute("tint");
  const repaint = () => {
    paintCloud(cloud, state.field, state.over, state.hiddenOf(state.field), tint.array);
    tint.needsUpdate = true;
    document.body.dataset.field = state.field.name;
    view.draw();
  };
  const change = () => {
    showLegend(element("legend_title"), element("legend"), cloud, state, repaint);
    repaint();
  };
  showFields(element("fields"), cloud, state, change);
  const switches = cloud.shades ? [shadingOf(cloud, points), ...layers] : layers;
  showLayers(element("layers_section"), element("layers"), switches, (layer, on) => {
    if (layer.set)
      layer.set(on);
    else
      layer.object.visible = on;
    view.draw();
  });
  switchPanel(element("panel_switch"), element("panel"));
  connectButtons(view, points, cloud);
  describeClicks(element("view"), element("picked"), view, cloud);
  change();
}

/** Say it on the page, too: few look into the console. */
function report(error) {
  const canvas = document.createElement("canvas");
  const text = canvas.getContext("webgl2") ? `The page cannot be shown: ${error.message}`
                                           : "This page needs WebGL 2, which this browser does not offer.";
  Object.assign(element("problem"), { textContent: text, hidden: false });
}

try {
  start();
} catch (error) {
  report(error);
  throw error;
}
