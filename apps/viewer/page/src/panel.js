// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The panel: fields, their legends, layers and the size of points.

import { UNKNOWN } from "./colors.js";

const TICKS = 5;

function make(tag, properties = {}, children = []) {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
}

function swatchOf(color) {
  const swatch = make("span", { className: "swatch" });
  swatch.style.background = color;
  return swatch;
}

function rowOf(input, children) {
  return make("label", { className: "row" }, [input, ...children]);
}

function nameOf(text) {
  return make("span", { className: "name", textContent: text });
}

function checkbox(checked, onChange) {
  const input = make("input", { type: "checkbox", checked });
  input.addEventListener("change", () => onChange(input.checked));
  return input;
}

/** A choice of the field, and of those that are painted on top of it. `state` has field, over and hidden. */
export function showFields(container, cloud, state, onChange) {
  for (const field of cloud.fields) {
    const input = make("input", { type: "radio", name: "field", value: field.name, checked: field === state.field });
    input.addEventListener("change", () => {
      state.field = field;
      onChange();
    });
    const row = make("div", { className: "row" }, [rowOf(input, [nameOf(field.title)])]);
    row.firstChild.style.flex = "1";
    if (field.nothing !== undefined)
      row.append(overOf(field, state, onChange));
    container.append(row);
  }
}

function overOf(field, state, onChange) {
  const input = checkbox(false, (checked) => {
    state.over[checked ? "add" : "delete"](field);
    onChange();
  });
  input.dataset.over = field.name;
  return make("label", { className: "row over", title: "Paint these points over the colors of the field" },
              [input, "on top"]);
}

/** The names, colors and numbers of labels; each can be switched off. */
function showLabels(container, field, state, onChange) {
  const hidden = state.hiddenOf(field);
  const boxes = field.legend.map((entry, label) => checkbox(!hidden.has(label), (checked) => {
    hidden[checked ? "delete" : "add"](label);
    onChange();
  }));
  if (field.legend.length > 2)
    container.append(rowOf(checkbox(hidden.size === 0, (checked) => {
      boxes.forEach((box, label) => {
        box.checked = checked;
        hidden[checked ? "delete" : "add"](label);
      });
      onChange();
    }), [nameOf("all")]));
  field.legend.forEach((entry, label) => container.append(rowOf(boxes[label], [
    swatchOf(entry.color), nameOf(entry.name),
    make("span", { className: "count", textContent: entry.points.toLocaleString("en") })])));
}

function showScale(container, field, viridis) {
  const [min, max] = field.range;
  const scale = make("div", { className: "scale" });
  scale.style.background = `linear-gradient(to right, ${viridis.join(",")})`;
  const ticks = Array.from({ length: TICKS }, (_, i) =>
    make("span", { textContent: Number((min + ((max - min) * i) / (TICKS - 1)).toPrecision(3)) }));
  container.append(scale, make("div", { className: "ticks" }, ticks));
  if (field.unknown > 0)
    container.append(make("div", { className: "row" }, [
      swatchOf(UNKNOWN), nameOf("unknown"),
      make("span", { className: "count", textContent: field.unknown.toLocaleString("en") })]));
}

/** The legend of the field that is chosen. */
export function showLegend(title, container, cloud, state, onChange) {
  title.textContent = state.field.kind === "plain" ? "" : state.field.title;
  container.replaceChildren();
  if (state.field.kind === "labels")
    showLabels(container, state.field, state, onChange);
  else if (state.field.kind === "numbers")
    showScale(container, state.field, cloud.viridis);
}

/** A switch for each layer: {name, on}. */
export function showLayers(section, container, layers, onChange) {
  section.hidden = layers.length === 0;
  for (const layer of layers) {
    const input = checkbox(layer.on, (checked) => onChange(layer, checked));
    input.dataset.layer = layer.name;
    container.append(rowOf(input, [nameOf(layer.name)]));
  }
}

/** The button that hides and shows the panel, which begins hidden in a narrow window. */
export function switchPanel(button, panel) {
  const show = (shown) => {
    panel.hidden = !shown;
    button.setAttribute("aria-expanded", String(shown));
    button.textContent = shown ? "Hide" : "Fields and layers";
  };
  show(!window.matchMedia("(max-width: 640px)").matches);
  button.addEventListener("click", () => show(panel.hidden));
}
