// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A headless Chromium for tests, its pages with what they complain of, and the colors of their pixels.

import { chromium } from "playwright-core";

const PATIENCE = 120000; // milliseconds: the machine may have other things to do

/** Chromium without a screen, and without a graphics card: SwiftShader draws what WebGL asks for. */
export function startBrowser() {
  return chromium.launch({
    executablePath: process.env.PCL_SHAPE_CHROMIUM,
    args: ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"],
  });
}

/** A page, and the list of all that its console, its scripts and its requests complain of. */
export async function openPage(browser, options) {
  const page = await browser.newPage(options);
  page.setDefaultTimeout(PATIENCE);
  const problems = [];
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type()) && !isOfDriver(message.text()))
      problems.push(`${page.url()}: ${message.text()}`);
  });
  page.on("pageerror", (error) => problems.push(`${page.url()}: ${error.message}`));
  page.on("requestfailed", (request) => {
    if (request.failure().errorText !== "net::ERR_ABORTED") // the test has gone on to another page
      problems.push(`${request.url()}: ${request.failure().errorText}`);
  });
  page.on("response", (response) => {
    if (response.status() >= 400)
      problems.push(`${response.url()}: status ${response.status()}`);
  });
  return { page, problems };
}

/** Reading pixels back is slow, and the driver says so: it is the test that reads them. */
function isOfDriver(text) {
  return text.includes("GPU stall due to ReadPixels");
}

/** The pixels of a picture in PNG, four bytes each, decoded by the browser. */
export async function decode(browser, png) {
  const page = await browser.newPage();
  const { width, height, data } = await page.evaluate(async (base64) => {
    const image = new Image();
    image.src = `data:image/png;base64,${base64}`;
    await image.decode();
    const canvas = new OffscreenCanvas(image.width, image.height);
    const context = canvas.getContext("2d");
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, image.width, image.height);
    let text = "";
    for (let i = 0; i < data.length; i += 8192)
      text += String.fromCharCode(...data.subarray(i, i + 8192));
    return { width: image.width, height: image.height, data: btoa(text) };
  }, png.toString("base64"));
  await page.close();
  return { width, height, data: Buffer.from(data, "base64") };
}

/** The share of pixels of a color, give or take 6 in each channel. */
export function shareOf({ data }, color) {
  let found = 0;
  for (let i = 0; i < data.length; i += 4)
    found += color.every((channel, c) => Math.abs(data[i + c] - channel) <= 6);
  return (4 * found) / data.length;
}
