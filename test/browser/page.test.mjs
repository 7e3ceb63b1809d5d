// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The page of pcl_shape_viewer -html in a browser.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";

import { decode, openPage, shareOf, startBrowser } from "./browser.mjs";

const BLUE = [70, 120, 205], ORANGE = [240, 140, 30], CRIMSON = [205, 20, 55], GREEN = [35, 155, 75];
const LIGHT_GRAY = [205, 205, 205], VIOLET = [68, 1, 84], YELLOW = [253, 231, 37];

let directory, browser;

before(async () => {
  directory = mkdtempSync(join(tmpdir(), "pcl_shape_page_"));
  browser = await startBrowser();
});

after(async () => {
  await browser?.close();
  rmSync(directory, { recursive: true });
});

/** A square of 60 x 60 points, 5 mm apart, 1 m away: the left half is planar, the right one curved, every fourth
 *  column is an edge; and normals, of which those of the right half look aside. */
function writeSquare(name) {
  const rows = [];
  for (let j = 0; j < 60; ++j)
    for (let i = 0; i < 60; ++i)
      rows.push([0.005 * (i - 30), 0.005 * (j - 30), 1, i < 30 ? 1 : 2, i % 4 === 0 ? 1 : 0, i < 30 ? 0 : 1,
                 i < 30 ? "-0.3 -0.46 -0.84" : "0.94 0 -0.3357"].join(" "));
  const path = join(directory, name);
  writeFileSync(path, ["# .PCD v0.7 - Point Cloud Data file format", "VERSION 0.7",
    "FIELDS x y z surface edge likelihood normal_x normal_y normal_z", "SIZE 4 4 4 4 4 4 4 4 4",
    "TYPE F F F U U F F F F", "COUNT 1 1 1 1 1 1 1 1 1", `WIDTH ${rows.length}`, "HEIGHT 1",
    "VIEWPOINT 0 0 0 1 0 0 0", `POINTS ${rows.length}`, "DATA ascii", ...rows, ""].join("\n"));
  return path;
}

function writeJson(name, value) {
  const path = join(directory, name);
  writeFileSync(path, JSON.stringify(value));
  return path;
}

/** Without an X server. */
function makePage(...words) {
  const output = join(directory, "page.html");
  const env = { ...process.env };
  delete env.DISPLAY;
  execFileSync(process.env.PCL_SHAPE_VIEWER, [...words, "-html", output], { env });
  return output;
}

async function open(path, options = { viewport: { width: 1000, height: 700 } }) {
  const { page, problems } = await openPage(browser, options);
  const requests = [];
  page.on("request", (request) => requests.push(request.url()));
  await page.goto(pathToFileURL(path).href);
  await page.waitForFunction(() => document.body.dataset.drawn);
  return { page, problems, requests };
}

async function pixelsOf(page) {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  return decode(browser, await page.screenshot({ clip: { x: 0, y: 80, width: 700, height: 620 } }));
}

const choose = (page, field) => page.locator(`input[name="field"][value="${field}"]`).check();

test("fields color the points, and a field that is switched changes the colors", async () => {
  const { page, problems, requests } = await open(makePage(writeSquare("square.pcd")));
  const surface = await pixelsOf(page);
  assert.ok(shareOf(surface, BLUE) > 0.1 && shareOf(surface, ORANGE) > 0.1, "planar is blue, curved orange");
  assert.equal(shareOf(surface, CRIMSON), 0);

  await choose(page, "edge");
  const edge = await pixelsOf(page);
  assert.ok(shareOf(edge, CRIMSON) > 0.05 && shareOf(edge, LIGHT_GRAY) > 0.1, "edges are red");
  assert.equal(shareOf(edge, BLUE) + shareOf(edge, ORANGE), 0);

  await choose(page, "likelihood");
  const likelihood = await pixelsOf(page);
  assert.ok(shareOf(likelihood, VIOLET) > 0.1 && shareOf(likelihood, YELLOW) > 0.1, "the ends of Viridis");

  assert.deepEqual(problems, []);
  assert.equal(requests.filter((url) => !/^(file|data|blob):/.test(url)).length, 0, "nothing comes from a network");
  await page.close();
});

test("the legend names and counts the labels, and hides them", async () => {
  const { page, problems } = await open(makePage(writeSquare("square.pcd")));
  assert.match(await page.locator("#legend").innerText(), /planar\s+1,800[^]*curved\s+1,800/);
  await page.locator("#legend label", { hasText: "planar" }).locator("input").uncheck();
  const pixels = await pixelsOf(page);
  assert.equal(shareOf(pixels, BLUE), 0);
  assert.ok(shareOf(pixels, ORANGE) > 0.1);
  assert.deepEqual(problems, []);
  await page.close();
});

test("edges are painted on top of surfaces", async () => {
  const { page, problems } = await open(makePage(writeSquare("square.pcd")));
  await page.locator('input[data-over="edge"]').check();
  const pixels = await pixelsOf(page);
  for (const color of [BLUE, ORANGE, CRIMSON])
    assert.ok(shareOf(pixels, color) > 0.05, `${color}`);
  assert.deepEqual(problems, []);
  await page.close();
});

test("shading is dark where the surface turns away", async () => {
  const { page } = await open(makePage(writeSquare("square.pcd"), "-field", "plain", "-shade"));
  const dark = LIGHT_GRAY.map((channel) => Math.round(0.3 * channel));
  assert.ok(shareOf(await pixelsOf(page), dark) > 0.1);
  await page.locator('input[data-layer="Shading by normals"]').uncheck();
  const pixels = await pixelsOf(page);
  assert.equal(shareOf(pixels, dark), 0);
  await page.close();
});

test("creases, boxes, grasps and normals are layers", async () => {
  const lines = writeJson("lines.json", { format: "pcl_shape lines", version: 1, lines: [
    { spacing: 0.004, points: [[-0.1, 0.05, 0.98], [0.1, 0.05, 0.98]] }] });
  const instances = writeJson("instances.json", { instances: [
    { id: 1, class: "curved", centroid: [0, 0, 1], primitive: { type: "cylinder" } }] });
  const grasps = writeJson("grasps.json", { cup_radius: 0.03, grasps: [
    { position: [-0.05, 0, 1], approach: [0, 0, 1], seals: true },
    { position: [0.07, 0, 1], approach: [0, 0, 1], seals: false }] });
  const { page, problems } = await open(makePage(writeSquare("square.pcd"), "-field", "plain", "-lines", lines,
                                                 "-instances", instances, "-grasps", grasps, "-normals"));
  const grayOf = async () => shareOf(await pixelsOf(page), LIGHT_GRAY);
  assert.ok((await page.locator("#names").innerText()).includes("1 curved, cylinder"));
  let before = await grayOf();
  for (const layer of ["Creases as lines", "Grasps", "Normals"]) {
    await page.locator(`input[data-layer="${layer}"]`).uncheck();
    const now = await grayOf();
    assert.ok(now > before, `${layer} covers points: ${before} to ${now}`);
    before = now;
  }
  await page.locator('input[data-layer="Boxes of instances"]').uncheck();
  await pixelsOf(page);
  assert.equal((await page.locator("#names span:visible").count()), 0);
  assert.deepEqual(problems, []);
  await page.close();
});

test("a click shows the values of the point", async () => {
  const { page, problems } = await open(makePage(writeSquare("square.pcd")));
  await page.mouse.click(420, 350);
  const text = await page.locator("#picked").innerText();
  assert.match(text, /x, y, z[^]*1\.0000 m[^]*surface\s+planar[^]*likelihood\s+0\.0000/);
  assert.deepEqual(problems, []);
  await page.close();
});

test("the mouse turns the cloud, and all of it is drawn when it rests", async () => {
  const { page, problems } = await open(makePage(writeSquare("square.pcd")));
  const before = await pixelsOf(page);
  await page.mouse.move(350, 350);
  await page.mouse.down();
  await page.mouse.move(520, 400, { steps: 8 });
  await page.mouse.up();
  await page.waitForFunction(() => document.body.dataset.drawn === "3600");
  assert.notDeepEqual((await pixelsOf(page)).data, before.data);
  await page.locator("#reset").click();
  await page.waitForFunction(() => document.body.dataset.drawn === "3600");
  assert.deepEqual((await pixelsOf(page)).data, before.data);
  assert.deepEqual(problems, []);
  await page.close();
});

test("a cloud with too many points is shown in part, and the page says so", async () => {
  const path = makePage(writeSquare("square.pcd"), "-max_points", "900");
  const { page, problems } = await open(path);
  assert.match(await page.locator("#note").innerText(), /^900 of 3,600 points/);
  assert.equal(await page.evaluate(() => document.body.dataset.drawn), "900");
  assert.ok(shareOf(await pixelsOf(page), BLUE) > 0.1, "points grow where there are fewer");
  assert.deepEqual(problems, []);
  await page.close();
});

test("a narrow window hides the panel and shows the whole cloud", async () => {
  const { page, problems } = await open(makePage(writeSquare("square.pcd")),
                                        { viewport: { width: 390, height: 780 } });
  assert.equal(await page.locator("#panel").isVisible(), false);
  const pixels = await decode(browser, await page.screenshot());
  const column = (x) => Array.from({ length: pixels.height }, (_, y) => 4 * (y * pixels.width + x))
    .some((at) => BLUE.every((channel, c) => Math.abs(pixels.data[at + c] - channel) <= 6));
  assert.equal(column(2), false, "white at the left border");
  await page.locator("#panel_switch").click();
  assert.equal(await page.locator("#panel").isVisible(), true);
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
  assert.deepEqual(problems, []);
  await page.close();
});

test("a single point is seen, wherever it is", async () => {
  const path = join(directory, "point.pcd");
  writeFileSync(path, ["VERSION 0.7", "FIELDS x y z surface", "SIZE 4 4 4 4", "TYPE F F F U", "COUNT 1 1 1 1", "WIDTH 1",
    "HEIGHT 1", "VIEWPOINT 0 0 0 1 0 0 0", "POINTS 1", "DATA ascii", "1000 2000 3000 1", ""].join("\n"));
  const { page, problems } = await open(makePage(path));
  assert.ok(shareOf(await pixelsOf(page), BLUE) > 0.0005, "20 x 20 pixels of 700 x 620");
  await page.mouse.click(500, 350);
  assert.match(await page.locator("#picked").innerText(), /1000\.0000, 2000\.0000, 3000\.0000 m/);
  assert.deepEqual(problems, []);
  await page.close();
});

test("the page names the licenses of what it is made of", () => {
  const html = readFileSync(makePage(writeSquare("square.pcd")), "utf8");
  assert.match(html, /three\.js [0-9.]+, which draws the page:\s+The MIT License/);
  assert.match(html, /BSD 3-Clause License|Redistribution and use in source and binary forms/);
});

test("names from a file are text, not HTML", async () => {
  const { page, problems } = await open(makePage(writeSquare("<b><!--<script>x.pcd")));
  assert.equal(await page.locator("#title").innerText(), "<b><!--<script>x.pcd");
  assert.deepEqual(problems, []);
  await page.close();
});
