// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Makes the page without a cloud, as a C++ source: its script with all that it imports, style and licenses inside.

// Usage: node build.mjs LICENSE OUTPUT.cpp, where node_modules are those of package.json
import { build } from "esbuild";
import { readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const read = (...parts) => readFileSync(join(...parts), "utf8");

async function scriptOf(entry) {
  const result = await build({ entryPoints: [entry], bundle: true, minify: true, format: "iife", target: "es2022",
                               write: false, legalComments: "none", logLevel: "warning" });
  return result.outputFiles[0].text;
}

const escapeHtml = (text) => text.replace(/&/g, "&amp;").replace(/</g, "&lt;");

function licensesOf(own) {
  const { version } = JSON.parse(read(here, "node_modules", "three", "package.json"));
  return `This page and pcl_shape:\n\n${own.trim()}\n\nthree.js ${version}, which draws the page:\n\n` +
    read(here, "node_modules", "three", "LICENSE").trim();
}

/** In the script nothing may end the element that it is in. */
async function pageOf(license) {
  const script = (await scriptOf(join(here, "src", "main.js"))).replace(/<\/script/gi, "<\\/script");
  const parts = { "PAGE_LICENSES": escapeHtml(licensesOf(license)), "/* PAGE_STYLE */": read(here, "src", "style.css"),
                  "/* PAGE_SCRIPT */": script };
  return Object.entries(parts).reduce((page, [mark, text]) => page.replace(mark, () => text), read(here, "page.html"));
}

/** A text as string literals of C++, which join to one. */
function literalsOf(text) {
  const bytes = [...Buffer.from(text, "utf8")].map((byte) => {
    const character = String.fromCharCode(byte);
    if (character === "\n")
      return "\\n";
    if (byte < 32 || byte > 126)
      return "\\" + byte.toString(8).padStart(3, "0");
    return '"\\?'.includes(character) ? "\\" + character : character;
  });
  const lines = [];
  for (let from = 0; from < bytes.length; from += 2000)
    lines.push(`    "${bytes.slice(from, from + 2000).join("")}"`);
  return lines.join("\n");
}

const [license, output] = process.argv.slice(2);
const [before, after] = (await pageOf(read(license))).split("<!-- PAGE_DATA -->");
writeFileSync(output, `// The page of pcl_shape_viewer -html; made by build.mjs.

#include "viewer/page_template.h"

namespace pcl::app {

const PageTemplate*
pageTemplate()
{
  static constexpr char before[] =
${literalsOf(before)};
  static constexpr char after[] =
${literalsOf(after)};
  static constexpr PageTemplate page{{before, sizeof before - 1}, {after, sizeof after - 1}};
  return &page;
}

} // namespace pcl::app
`);
