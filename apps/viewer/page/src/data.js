// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Reads what pcl_shape_viewer wrote into the page: a header in JSON, and arrays in base64.

const ARRAY_TYPES = { uint8: Uint8Array, uint16: Uint16Array, uint32: Uint32Array, float32: Float32Array };

/** The bytes of a text in base64. */
export function bytesOf(base64) {
  if (Uint8Array.fromBase64)
    return Uint8Array.fromBase64(base64);
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i)
    bytes[i] = text.charCodeAt(i);
  return bytes;
}

/** The array that the header refers to as {id, type}; its element leaves the page, as it would be kept twice. */
function takeArray({ id, type }, document) {
  const element = document.getElementById(id);
  const bytes = bytesOf(element.textContent);
  element.remove();
  return new ARRAY_TYPES[type](bytes.buffer);
}

/** The header with arrays in the place of references. */
export function readCloud(document) {
  const cloud = JSON.parse(document.getElementById("cloud").textContent);
  cloud.positions = takeArray(cloud.positions, document);
  for (const field of cloud.fields)
    if (field.values)
      field.values = takeArray(field.values, document);
  if (cloud.shades)
    cloud.shades = takeArray(cloud.shades, document);
  return cloud;
}
