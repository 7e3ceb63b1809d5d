// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The documentation site in a browser: every page, link, picture and block of code, and the search.

import assert from "node:assert/strict";
import { createReadStream, existsSync, readdirSync, statSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";
import { after, before, test } from "node:test";

import { decode, openPage, startBrowser } from "./browser.mjs";

const SITE = process.env.PCL_SHAPE_SITE;
const TYPES = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".png": "image/png",
                ".svg": "image/svg+xml", ".json": "application/json" };
const PHONE = { width: 390, height: 800 };

let server, origin, browser;

function answer(request, response) {
  const path = join(SITE, normalize(decodeURIComponent(new URL(request.url, "http://site").pathname)));
  if (!existsSync(path) || !statSync(path).isFile()) {
    response.writeHead(404).end();
    return;
  }
  response.writeHead(200, { "Content-Type": TYPES[extname(path)] ?? "application/octet-stream" });
  createReadStream(path).pipe(response);
}

before(async () => {
  server = createServer(answer);
  await new Promise((listening) => server.listen(0, "127.0.0.1", listening));
  origin = `http://127.0.0.1:${server.address().port}`;
  browser = await startBrowser();
});

after(async () => {
  await browser?.close();
  server.close();
});

/** What a page has: its links, its anchors, pictures that do not show, and code that runs over its width. */
function inspect() {
  const isWide = (element) => element.scrollWidth > element.clientWidth + 1;
  return {
    links: [...document.querySelectorAll("a[href]")].map((a) => a.href),
    anchors: [...document.querySelectorAll("[id]")].map((element) => element.id),
    blank: [...document.images].filter((image) => image.naturalWidth === 0).map((image) => image.src),
    wide: [...document.querySelectorAll("pre")].filter(isWide).map((pre) => pre.textContent.slice(0, 60)),
    width: document.documentElement.scrollWidth,
  };
}

/** All pages that links lead to from the first one, each with what inspect() finds. */
async function crawl() {
  const { page, problems } = await openPage(browser, { viewport: PHONE });
  const pages = new Map();
  const waiting = [`${origin}/README.html`];
  while (waiting.length > 0) {
    const url = waiting.pop();
    if (pages.has(url))
      continue;
    await page.goto(url, { waitUntil: "load" });
    await page.evaluate(() => Promise.all([...document.images].map((image) => {
      image.loading = "eager";
      return image.decode().catch(() => undefined); // those that fail are found by their size
    })));
    const found = await page.evaluate(inspect);
    pages.set(url, found);
    for (const link of found.links.map((link) => link.split("#")[0]))
      if (isPage(link) && !pages.has(link))
        waiting.push(link);
  }
  await page.close();
  return { pages, problems };
}

const isPage = (link) => link.startsWith(`${origin}/`) && link.endsWith(".html") && !link.includes("/pictures/");

function brokenLinks(pages) {
  const broken = [];
  for (const [url, { links }] of pages)
    for (const link of links.filter((link) => link.startsWith(`${origin}/`))) {
      const [target, anchor] = link.split("#");
      const path = join(SITE, decodeURIComponent(new URL(target).pathname));
      const known = pages.get(target);
      if (!existsSync(path) || (anchor && known && !known.anchors.includes(decodeURIComponent(anchor))))
        broken.push(`${url}: ${link}`);
    }
  return broken;
}

test("every page opens, every link leads somewhere, every picture shows, code fits a phone", async () => {
  const { pages, problems } = await crawl();
  assert.ok(pages.size > 30, `only ${pages.size} pages`);
  assert.deepEqual(problems, []);
  assert.deepEqual(brokenLinks(pages), []);
  const bad = [...pages].filter(([, { blank, wide, width }]) => blank.length + wide.length > 0 || width > PHONE.width)
    .map(([url, { blank, wide, width }]) => ({ url, blank, wide, width }));
  assert.deepEqual(bad, []);
  console.log(`${pages.size} pages, ${[...pages.values()].reduce((sum, { links }) => sum + links.length, 0)} links`);
});

test("the index leads to the first page", async () => {
  const { page, problems } = await openPage(browser);
  await page.goto(`${origin}/index.html`);
  await page.waitForURL(/README\.html$/);
  assert.deepEqual(problems, []);
  await page.close();
});

/** One search for pages, tutorials and the reference. */
async function search(word) {
  const { page, problems } = await openPage(browser);
  await page.goto(`${origin}/search.html?q=${word}`);
  await page.locator("#search-results li a").first().waitFor();
  await page.waitForFunction(() => /found|matching/i.test(document.querySelector("#search-results").innerText));
  const links = await page.locator("#search-results li a").evaluateAll((all) => all.map((a) => a.href));
  assert.deepEqual(problems, []);
  await page.close();
  return links.map((link) => link.slice(origin.length));
}

test("the search finds the reference, pages and tutorials", async () => {
  assert.ok((await search("setOutlierRate")).some((link) => link.startsWith("/reference/inad.html")));
  const found = await search("histogram");
  assert.ok(found.some((link) => link.startsWith("/doc/method.html")), found.join(" "));
  assert.ok(found.some((link) => link.startsWith("/doc/tutorials/content/shape_model.html")), found.join(" "));
});

const withPages = process.env.PCL_SHAPE_PAGES === "1";
test("living pictures are linked from tutorials, and show something", { skip: !withPages }, async () => {
  const pictures = existsSync(join(SITE, "pictures")) ? readdirSync(join(SITE, "pictures")) : [];
  assert.ok(pictures.length > 0, "no living picture was made");
  const { page, problems } = await openPage(browser, { viewport: { width: 800, height: 600 } });
  await page.goto(`${origin}/doc/tutorials/content/shape_edge_detection.html`);
  const links = await page.locator('a[href*="/pictures/"]').evaluateAll((all) => all.map((a) => a.href));
  assert.equal(links.length, 4, "two pictures, and two captions");
  for (const picture of pictures) {
    await page.goto(`${origin}/pictures/${picture}`);
    await page.waitForFunction(() => document.body.dataset.drawn);
    const { data } = await decode(browser, await page.screenshot({ clip: { x: 0, y: 60, width: 500, height: 540 } }));
    let inked = 0;
    for (let i = 0; i < data.length; i += 4)
      inked += Math.min(data[i], data[i + 1], data[i + 2]) < 240;
    assert.ok((4 * inked) / data.length > 0.1, `${picture} is blank`);
  }
  assert.deepEqual(problems, []);
  await page.close();
});
