// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// From the values of fields to the colors of points.

export const UNKNOWN = "#969696";

/** [r, g, b] of "#rrggbb", 0 to 255. */
export function channelsOf(color) {
  const value = parseInt(color.slice(1), 16);
  return [value >> 16, (value >> 8) & 255, value & 255];
}

/** The colors of the scale, and that of what is unknown as the last. */
function scaleOf(viridis) {
  return [...viridis, UNKNOWN].map(channelsOf);
}

/** Where a number is on a scale of so many steps; past the last one if it is NaN. */
export function stepOf(value, [min, max], steps) {
  if (Number.isNaN(value))
    return steps;
  const share = Math.min(1, Math.max(0, (value - min) / (max - min)));
  return Math.round(share * (steps - 1));
}

function paint(colors, point, [r, g, b]) {
  colors[4 * point] = r;
  colors[4 * point + 1] = g;
  colors[4 * point + 2] = b;
}

function paintLabels(field, hidden, colors) {
  const palette = field.legend.map((entry) => channelsOf(entry.color));
  for (let i = 0; i < field.values.length; ++i) {
    const label = field.values[i];
    paint(colors, i, palette[label]);
    if (hidden.has(label))
      colors[4 * i + 3] = 0;
  }
}

function paintNumbers(field, viridis, colors) {
  const scale = scaleOf(viridis);
  for (let i = 0; i < field.values.length; ++i)
    paint(colors, i, scale[stepOf(field.values[i], field.range, viridis.length)]);
}

function paintColors(field, colors) {
  for (let i = 0; 3 * i < field.values.length; ++i)
    paint(colors, i, field.values.subarray(3 * i, 3 * i + 3));
}

/** Paint what a field has labels for, and leave the other points as they are. */
function paintOver(field, colors) {
  const palette = field.legend.map((entry) => channelsOf(entry.color));
  for (let i = 0; i < field.values.length; ++i)
    if (field.values[i] !== field.nothing)
      paint(colors, i, palette[field.values[i]]);
}

/** Four bytes for each point: its color by the field, with other fields painted over it; the last byte is 0 where
 *  the point's label is hidden, else 255. */
export function paintCloud(cloud, field, over, hidden, colors) {
  colors.fill(255);
  if (field.kind === "labels")
    paintLabels(field, hidden, colors);
  else if (field.kind === "numbers")
    paintNumbers(field, cloud.viridis, colors);
  else if (field.kind === "colors")
    paintColors(field, colors);
  else
    for (let i = 0; i < cloud.points; ++i)
      paint(colors, i, channelsOf(field.color));
  for (const other of over)
    if (other !== field)
      paintOver(other, colors);
}
