"""The chart of bench/run: how many times longer each peer takes, by workload."""

import textwrap

from tables import GOOD, groups, ours

COLOURS = {
    "ioverlay": "#d95f02",
    "clipper2": "#7570b3",
    "boost": "#1b9e77",
    "geos": "#666666",
    "cgal": "#e6ab02",
}


def draw(report, path):
    try:
        import matplotlib

        matplotlib.use("svg")
        import matplotlib.pyplot as plt
    except ImportError:
        print("no matplotlib (bench/peers/install): no chart")
        return
    plt.rcParams["svg.hashsalt"] = "oblast"  # the same figures give the same file
    plt.rcParams["svg.fonttype"] = "none"
    most = max((row["threads"] for row in report["rows"]), default=1)
    chosen = [(key, rows) for key, rows in groups(report["rows"]).items() if key[2] == most and ours(rows)]
    if not chosen:
        return
    figure, axes = plt.subplots(figsize=(9, 1.5 + 0.3 * len(chosen)))
    labelled = set()
    for y, ((workload, operation, _), rows) in enumerate(reversed(chosen)):
        for row in rows:
            if row["peer"].startswith("oblast") or "seconds" not in row or not row.get("ours_seconds"):
                continue
            family = row["peer"].split("-")[0]
            good = row.get("verdict") in GOOD
            axes.plot(
                row["seconds"] / row["ours_seconds"],
                y,
                marker="o" if good else "x",
                color=COLOURS.get(family, "black"),
                linestyle="none",
                label=family if family not in labelled and good else None,
            )
            if good:
                labelled.add(family)
    names = [k[0] if k[1] == "default" else f"{k[0]} {k[1]}" for k, _ in reversed(chosen)]
    axes.set_yticks(range(len(chosen)), names)
    axes.set_xscale("log")
    axes.axvline(1, color="black", linewidth=1)
    axes.set_xticks([0.5, 1, 2, 5, 10, 20, 50, 100], ["1/2", "1", "2", "5", "10", "20", "50", "100"])
    axes.set_xlabel(f"time / oblast's, {most} threads; right of 1 oblast is faster; x: wrong result")
    axes.grid(axis="x", which="both", linewidth=0.3)
    axes.legend(loc="lower right")
    axes.set_title("\n".join(textwrap.wrap(report["machine"], 90)), fontsize=8, loc="right")
    figure.tight_layout()
    figure.savefig(path, metadata={"Date": None})
