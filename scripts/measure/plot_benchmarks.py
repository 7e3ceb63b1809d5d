#!/usr/bin/env python3
"""Draw doc/figures/benchmark_*.png and rewrite the tables of doc/performance.md and README.md.

Usage: scripts/measure/plot_benchmarks.py RESULTS.json [ROOT]
RESULTS.json is what scripts/measure/benchmark.sh wrote. ROOT is the repository by default. A table
stands between <!-- begin NAME --> and <!-- end NAME -->. Needs Debian's python3-matplotlib.
"""
import json
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))

from benchmark_tables import INSTRUCTIONS, Results, all_tables, rewrite  # noqa: E402

PCL, UNSORTED, OWN, PAPER = "#9467bd", "#1f77b4", "#d62728", "#7f7f7f"


def figure(width, height):
    figure, axes = plt.subplots(figsize=(width, height), dpi=100, constrained_layout=True)
    axes.spines[["top", "right"]].set_visible(False)
    return figure, axes


def speedups(results):
    """One pair of bars for each run, grouped by task."""
    runs = [(task, cloud, r) for task in ("pipeline", "edges", "surfaces", "uneven")
            for cloud, r in results.of(task)]
    labels = [("" if task == "uneven" else f"{task}, ") + f"{cloud}, {r['threads']} thread" +
              ("s" if r["threads"] > 1 else "") + f", {INSTRUCTIONS[r['target']]}"
              for task, cloud, r in runs]
    drawing, axes = figure(9, 0.34 * len(runs) + 0.9)
    for key, text, color, offset in (
            ("speedup", "PCL's KdTree, sorted", PCL, -0.2),
            ("speedup_unsorted", "PCL's KdTree, unsorted", UNSORTED, 0.2)):
        places = [i + offset for i in range(len(runs))]
        bars = axes.barh(places, [r[key] for _, _, r in runs], 0.4, color=color, label=text)
        axes.bar_label(bars, fmt="%.0f", fontsize=7, padding=2)
    axes.set_yticks(range(len(runs)), labels, fontsize=8)
    axes.set_ylim(len(runs) - 0.4, -0.6)
    axes.set_xlabel("times faster than the same over")
    axes.legend(loc="lower left", bbox_to_anchor=(0, 1), ncol=2, frameon=False)
    return drawing


def k_sweep(results):
    cloud, result = results.one("k_sweep")
    rows = result["k_sweep"]
    drawing, axes = figure(6, 4)
    for key, text, color in (("paper_us", "the paper (i7-6850K)", PAPER),
                             ("pcl_us", "PCL's KdTree", UNSORTED),
                             ("pcl_shape_us", "pcl_shape", OWN)):
        drawn = [(r["k"], r[key]) for r in rows if r[key] is not None]
        axes.loglog(*zip(*drawn), "o-", color=color, label=text)
    ks = [r["k"] for r in rows]
    axes.set_xticks(ks, [str(k) for k in ks])
    axes.minorticks_off()
    axes.set_xlabel("k nearest points")
    axes.set_ylabel("search and INAD (µs/point)")
    axes.set_title(f"{cloud}, threads: {result['threads']}", fontsize=10)
    axes.grid(alpha=0.3)
    axes.legend()
    return drawing


def cost(results):
    _, result = results.one("cost_per_point")
    drawing, axes = figure(6, 3.6)
    points = [s["points"] for s in result["sizes"]]
    axes.semilogx(points, [s["ns_per_point"] for s in result["sizes"]], "o-", color=OWN)
    for size in result["sizes"]:
        axes.annotate(f"{size['ratio']:.2f}", (size["points"], size["ns_per_point"]),
                      textcoords="offset points", xytext=(0, 7), ha="center", fontsize=8)
    axes.set_ylim(0, 1.25 * max(s["ns_per_point"] for s in result["sizes"]))
    axes.set_xlabel("points of the same density")
    axes.set_ylabel("pipeline (ns/point)")
    axes.set_title(f"Threads: {result['threads']}; over the points: ratio to the first",
                   fontsize=10)
    axes.grid(alpha=0.3)
    return drawing


def structures(results):
    cloud, result = results.one("structures")
    bars = [(s["name"], s["us_per_query"]) for s in result["structures"]]
    bars = sorted(bars, key=lambda bar: -bar[1])
    bars.append(("pcl_shape, building included", result["pcl_shape_us_per_query"]))
    drawing, axes = figure(8, 0.42 * len(bars) + 1)
    drawn = axes.barh([name for name, _ in bars], [us for _, us in bars],
                      color=[UNSORTED] * (len(bars) - 1) + [OWN])
    axes.bar_label(drawn, fmt="%.2g", padding=3)
    axes.invert_yaxis()
    axes.set_xlabel(f"search and INAD over {1e3 * result['radius']:.0f} mm (µs/query), "
                    f"{cloud}, threads: {result['threads']}")
    return drawing


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit("usage: scripts/measure/plot_benchmarks.py RESULTS.json [ROOT]")
    root = pathlib.Path(sys.argv[2] if len(sys.argv) == 3 else __file__).resolve()
    root = root if len(sys.argv) == 3 else root.parent.parent.parent
    results = Results(json.loads(pathlib.Path(sys.argv[1]).read_text(encoding="utf-8")))
    for draw in (speedups, k_sweep, cost, structures):
        # Without the version of matplotlib, a picture changes only with what it shows.
        draw(results).savefig(root / f"doc/figures/benchmark_{draw.__name__}.png",
                              metadata={"Software": None})
    tables = all_tables(results)
    rewrite(root / "doc/performance.md", tables)
    rewrite(root / "README.md", tables)


if __name__ == "__main__":
    main()
