#!/usr/bin/env python3
"""Rewrite the tables of doc/evaluation.md that compare with peers.

Usage: scripts/evaluate/peer_tables.py RESULTS [ROOT]
RESULTS is what scripts/evaluate/compare_peers.sh kept: a line of JSON for each run. ROOT is the repository
by default. A table stands between <!-- begin NAME --> and <!-- end NAME -->.
"""
import json
import pathlib
import sys
import textwrap

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))

from benchmark_tables import rewrite, table  # noqa: E402

GROUPS = {"real": "given real scenes", "exact": "clouds with exact creases",
          "generated": "generated scenes"}
SAMPLINGS = {"parts_pds0": "even", "parts_pds15": "even, .15 s", "parts_pds40": "even, .40 s",
             "parts_rnd15": "random, .15 s"}
CLEAR = 0.0005  # a difference that the tables show


def share(value):
    return "–" if value is None else f"{value:.3f}".removeprefix("0")


def shares(mean, *names):
    return [share(mean.get(name)) for name in names]


def described(row):
    """The setting, and the threshold if it was chosen."""
    if not row["tuned"]:
        return row["setting"]
    least, most = f"{row['threshold']:.2g}", f"{row.get('max_threshold', row['threshold']):.2g}"
    return f"{row['setting']}; from {least}" + (f" to {most}" if most != least else "")


def edges(rows):
    head = ["edges", "setting", "F1", "P", "R", "IoU", "accuracy", "time (s)"]
    return table(head, [
        [row["peer"], described(row),
         *shares(row["mean"], "edge_f1", "edge_precision", "edge_recall", "edge_iou", "accuracy"),
         f"{row['mean']['seconds']:.2f}"] for row in rows])


def surfaces(rows):
    head = ["curved or planar", "setting", "curved F1", "P", "R", "planar F1", "P", "R",
            "class-mean IoU", "accuracy", "time (s)"]
    return table(head, [
        [row["peer"], described(row),
         *shares(row["mean"], "curved_f1", "curved_precision", "curved_recall", "planar_f1",
                 "planar_precision", "planar_recall", "mean_iou", "accuracy"),
         f"{row['mean']['seconds']:.2f}"] for row in rows])


def parts(runs):
    """F1 of each sampling, the mean of the parts, and the time of all of them."""
    columns = [key for key in SAMPLINGS if (key, "edges") in runs]
    rows = [[row["peer"] for row in runs[key, "edges"]] for key in columns]
    assert all(peers == rows[0] for peers in rows), "the runs of parts have different peers"
    lines = []
    for place, peer in enumerate(rows[0]):
        of_peer = [runs[key, "edges"][place]["mean"] for key in columns]
        lines.append([peer, *(share(mean["edge_f1"]) for mean in of_peer),
                      f"{sum(mean['seconds'] for mean in of_peer) / len(of_peer):.2f}"])
    return table(["edge F1", *(SAMPLINGS[key] for key in columns), "time (s)"], lines)


def clouds(rows, key, value=share):
    """A number of each cloud beside each other."""
    names = [cloud["cloud"] for cloud in rows[0]["clouds"]]
    return table(["edges", "setting", *names, "time (s)"], [
        [row["peer"], described(row), *(value(cloud[key]) for cloud in row["clouds"]),
         f"{row['mean']['seconds']:.2f}"] for row in rows])


def wrong(accuracy):
    return f"{1 - accuracy:.4f}".removeprefix("0")


def better(rows, key):
    """(cloud, peer, the peer's value, ours) wherever a peer is clearly better."""
    own = {cloud["cloud"]: cloud.get(key) for cloud in rows[0]["clouds"]}
    return [(cloud["cloud"], row["peer"], cloud[key], own[cloud["cloud"]])
            for row in rows[1:] for cloud in row["clouds"]
            if key in cloud and cloud[key] > own[cloud["cloud"]] + CLEAR]


def faster(rows):
    own = rows[0]["mean"]["seconds"]
    return [f"{row['peer']} ({row['mean']['seconds']:.2f} s against {own:.2f})"
            for row in rows[1:] if row["mean"]["seconds"] < own]


KEYS = {"edges": {"edge_f1": "edge F1", "edge_precision": "edge precision",
                  "edge_recall": "edge recall"},
        "surfaces": {"curved_f1": "curved F1", "planar_f1": "planar F1"}}


def losses_of_key(rows, key, name):
    """Cloud by cloud the peer that is best there; precision and recall only as a mean."""
    if not key.endswith("_f1"):
        own = rows[0]["mean"][key]
        found = [f"{row['peer']} {share(row['mean'][key])}" for row in rows[1:]
                 if row["mean"][key] > own + CLEAR]
        return [f"mean {name} {share(own)}: {'; '.join(found)}"] if found else []
    best = {}
    for loss in better(rows, key):
        best[loss[0]] = max(best.get(loss[0], loss), loss, key=lambda one: one[2])
    return [f"{name} of {cloud}: {peer} {share(value)}, ours {share(own)}"
            for cloud, peer, value, own in best.values()]


def losses(runs):
    lines = []
    for (group, task), rows in runs.items():
        if group not in GROUPS:
            continue  # their tables are short
        found = [line for key, name in KEYS[task].items()
                 for line in losses_of_key(rows, key, name)]
        quick = faster(rows)
        if quick:
            found.append("less time: " + ", ".join(quick))
        title = f"- **{GROUPS[group]}, {task}.** "
        text = title + (". ".join(one[0].upper() + one[1:] for one in found) + "."
                        if found else "Nowhere in this table.")
        lines.append(textwrap.fill(text, 100, subsequent_indent="  ", break_long_words=False,
                                   break_on_hyphens=False))
    return "\n".join(lines)


def read(path):
    """{(group, task): rows}"""
    runs = {}
    for line in path.read_text(encoding="utf-8").splitlines():
        run = json.loads(line)
        for task in KEYS:
            if task in run["result"]:
                runs[run["group"], task] = run["result"][task]
    return runs


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit("usage: scripts/evaluate/peer_tables.py RESULTS [ROOT]")
    root = pathlib.Path(sys.argv[2]) if len(sys.argv) == 3 else \
        pathlib.Path(__file__).resolve().parent.parent.parent
    runs = read(pathlib.Path(sys.argv[1]))
    tables = {f"peers_{group}_{task}": (edges if task == "edges" else surfaces)(rows)
              for (group, task), rows in runs.items() if group in GROUPS}
    # These are not in the page.
    if any(group in SAMPLINGS for group, _ in runs):
        print(parts(runs), end="\n\n")
    if ("rgbd", "edges") in runs:
        print(clouds(runs["rgbd", "edges"], "accuracy", wrong), end="\n\n")
    if ("dense", "edges") in runs:
        print(clouds(runs["dense", "edges"], "edge_f1"), end="\n\n")
    if set(GROUPS) <= {group for group, _ in runs}:
        tables["peers_losses"] = losses(runs)
    rewrite(root / "doc/evaluation.md", tables)


if __name__ == "__main__":
    main()
