"""The tables of doc/performance.md from the results of scripts/measure/benchmark.sh."""
import re
import textwrap

INSTRUCTIONS = {"avx3": "AVX-512", "avx2": "AVX2", "sse4": "SSE4", "neon": "NEON",
                "portable": "plain C++"}


class Results:
    def __init__(self, data):
        self.machine = data["machine"]
        self.runs = data["runs"]

    def of(self, benchmark):
        """Pairs of (cloud, result)."""
        return [(r["cloud"], r["result"]) for r in self.runs if r["benchmark"] == benchmark]

    def one(self, benchmark):
        return self.of(benchmark)[0]


def number(value):
    """Two or three digits of a small number, all of a large one."""
    if value is None:
        return "–"
    if value >= 200:
        return f"{value:,.0f}"
    return f"{value:.1f}" if value >= 10 else f"{value:#.2g}"


def wrapped(text):
    return textwrap.fill(text, 100, break_long_words=False, break_on_hyphens=False)


def table(head, rows):
    lines = ["| " + " | ".join(str(cell) for cell in line) + " |" for line in [head, *rows]]
    return "\n".join([lines[0], "|---" * len(head) + "|", *lines[1:]])


def rewrite(path, tables):
    """Replace what is between the marks of the tables that a page has and that are given."""
    def replace(match):
        return f"{match[1]}\n{tables[match[2]]}\n{match[3]}" if match[2] in tables else match[0]

    text = path.read_text(encoding="utf-8")
    marks = r"(<!-- begin (\w+) -->)\n.*?(<!-- end \2 -->)"
    path.write_text(re.sub(marks, replace, text, flags=re.DOTALL), encoding="utf-8")


def settings(result):
    return [result["threads"], INSTRUCTIONS[result["target"]]]


def against_pcl(result):
    return [number(result[key]) for key in
            ("pcl_ms", "pcl_unsorted_ms", "pcl_shape_ms", "speedup", "speedup_unsorted")]


AGAINST_PCL = ["PCL, sorted (ms)", "PCL, unsorted (ms)", "pcl_shape (ms)",
               "times faster than sorted", "than unsorted"]


def pipelines(results, *benchmarks):
    rows = [[benchmark] * (len(benchmarks) > 1) +
            [cloud, number(result["points"]), *settings(result), *against_pcl(result)]
            for benchmark in benchmarks for cloud, result in results.of(benchmark)]
    head = ["task"] * (len(benchmarks) > 1) + ["cloud", "points", "threads", "instructions"]
    return table(head + AGAINST_PCL, rows)


def k_sweep(results):
    cloud, result = results.one("k_sweep")
    rows = [[r["k"], number(r["paper_us"]), number(r["pcl_us"]), number(r["pcl_shape_us"]),
             number(r["speedup"]), number(r["pcl_shape_with_sorting_us"])]
            for r in result["k_sweep"]]
    return (f"{cloud}, {result['points']:,} points, threads: {result['threads']}, "
            f"{INSTRUCTIONS[result['target']]}; PCL's tree is built in "
            f"{number(result['pcl_build_us'])} µs a point:\n\n" +
            table(["k", "the paper (µs)", "PCL (µs)", "pcl_shape (µs)", "times faster than PCL",
                   "pcl_shape's first run (µs)"], rows))


def structures(results):
    cloud, result = results.one("structures")
    own = result["pcl_shape_us_per_query"]
    rows = [[s["name"], number(s["build_ms"]), number(s["us_per_query"]),
             number(s["us_per_query"] / own)] for s in result["structures"]]
    rows.append(["pcl_shape, building included", "–", number(own), "1"])
    return (f"{cloud}, {result['points']:,} points, INAD over {1e3 * result['radius']:.0f} mm, "
            f"threads: {result['threads']}, {INSTRUCTIONS[result['target']]}:\n\n" +
            table(["structure", "building (ms)", "search and INAD (µs/query)",
                   "times pcl_shape's"], rows))


def cost(results):
    _, result = results.one("cost_per_point")
    rows = [[number(s["points"]), number(s["neighbors_per_point"]), number(s["ns_per_point"]),
             f"{s['ratio']:.2f}", number(s["max_extra_bytes_per_point"])]
            for s in result["sizes"]]
    return (f"Threads: {result['threads']}, {INSTRUCTIONS[result['target']]}:\n\n" +
            table(["points", "neighbors/point", "ns/point", "ratio", "extra heap (B/point)"],
                  rows))


STAGES = {"start": "process start (with `--version`)", "read": "reading", "normals": "normals",
          "inad": "INAD", "edge_detection": "edge detection", "write": "encoding and writing",
          "other": "converting, appending fields, JSON, exit", "wall": "**all**"}


def process(results):
    cloud, result = results.one("process")
    wall = result["ms"]["wall"]
    rows = [[text, number(result["ms"][stage]), f"{100 * result['ms'][stage] / wall:.0f} %"]
            for stage, text in STAGES.items() if stage in result["ms"]]
    return (f"{cloud}, threads: {result['threads']}:\n\n" +
            table(["stage", "ms", "share"], rows) +
            f"\n\nShare that is neither reading, writing nor process start: "
            f"**{100 * result['share']:.0f} %**.")


def agreement(results):
    """The worst of all comparisons but the laser scan, whose normals are hardly defined."""
    compared = [r for name in ("pipeline", "edges", "surfaces") for _, r in results.of(name)]
    mu, sigma, heap = (max(r[key] for r in compared) for key in
                       ("mu_p999", "sigma_p999", "max_extra_bytes_per_point"))
    return wrapped(
        f"In all comparisons of these two tables both go through exactly the same number of "
        f"neighbors, and 99.9 % of mu agree within {1e3 * mu:.1g} mrad, of sigma within "
        f"{1e3 * sigma:.1g} mrad. The most heap in use beside the returned clouds is {heap:.1f} "
        f"bytes a point.")


def machine(results):
    m = results.machine
    return wrapped(f"Measured at commit {m['commit']}, on {m['cores']} cores of {m['processor']}, {m['compiler']}, "
                   f"`CMAKE_BUILD_TYPE={m['build_type']}`, PCL {m['pcl']}; runs of each: "
                   f"{m['repeat']}; load average before: {m['load']}.")


def readme(results):
    """The sentence of README.md about PCL: of the scene that everybody can generate."""
    def scene(task):
        return next(r for cloud, r in results.of(task) if cloud == "scene" and r["threads"] == 1)

    def seconds(task):
        return [number(1e-3 * scene(task)[key]) for key in
                ("pcl_shape_ms", "pcl_unsorted_ms", "pcl_ms")]

    return wrapped(
        "Normals, INAD and likelihood of {:,} points on one thread take {} s at 25 mm; over "
        "`pcl::search::KdTree` they take {} s, and {} s if it sorts, as it does by default. At 15 and 6 mm "
        "they take {} s, {} s and {} s.".format(scene("surfaces")["points"], *seconds("surfaces"), *seconds("edges")))


def all_tables(results):
    return {
        "machine": machine(results),
        "agreement": agreement(results),
        "pipeline": pipelines(results, "pipeline"),
        "detectors": pipelines(results, "edges", "surfaces"),
        "uneven": pipelines(results, "uneven"),
        "k_sweep": k_sweep(results),
        "structures": structures(results),
        "cost": cost(results),
        "process": process(results),
        "readme": readme(results),
    }
