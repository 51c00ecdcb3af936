"""The tables of bench/run, as Markdown."""

JUDGED_GOOD = ("valid", "touching", "ogc valid", "self-touching")  # bench/driver/judge.cpp
GOOD = (*JUDGED_GOOD, "contours only", "not judged")


def duration(seconds):
    for unit, factor in (("s", 1), ("ms", 1e3), ("us", 1e6)):
        if seconds * factor >= 1 or unit == "us":
            return f"{seconds * factor:.3g} {unit}"


def groups(rows):
    """Rows by what was measured, in order."""
    result = {}
    for row in rows:
        result.setdefault((row["workload"], row["operation"], row["threads"]), []).append(row)
    return result


def good(rows, prefix="", verdicts=GOOD):
    """Rows of peers whose result is good."""
    return [
        r
        for r in rows
        if r["peer"].startswith(prefix)
        and not r["peer"].startswith("oblast")
        and "seconds" in r
        and r.get("verdict") in verdicts
    ]


def best_peer(rows, prefix=""):
    """The fastest peer with a good result in polygons, as ours is; None where there is none."""
    return min(good(rows, prefix, (*JUDGED_GOOD, "not judged")), key=lambda r: r["seconds"], default=None)


def best_of_contours(rows):
    """The fastest that leaves it to others which contour is a hole of which."""
    return min(good(rows, verdicts=("contours only",)), key=lambda r: r["seconds"], default=None)


def ours(rows):
    return next((r for r in rows if r["peer"] == "oblast" and "seconds" in r), None)


def detail_table(rows):
    lines = [
        "| workload | operation | threads | engine | median | spread | / ours | peak MiB | input MiB "
        "| contours | vertices | result |",
        "|---|---|--:|---|--:|--:|--:|--:|--:|--:|--:|---|",
    ]
    for (workload, operation, threads), members in groups(rows).items():
        for row in members:
            head = f"| {workload} | {operation} | {threads} | {row['peer']} |"
            if "seconds" not in row:
                # "unsupported" is the driver's word that the peer does not claim it; anything else is a failure.
                reason = f"unsupported: {row['unsupported']}" if "unsupported" in row else f"FAILED: {row['error']}"
                lines.append(f"{head} | | | | | | | {reason} |")
                continue
            spread = (row.get("slowest", row["seconds"]) - row.get("fastest", row["seconds"])) / row["seconds"]
            verdict = row.get("verdict", "")
            if verdict in ("invalid", "wrong area"):
                verdict = f"{verdict.upper()}: {row['fault']}"
            lines.append(
                f"{head} {duration(row['seconds'])} | {100 * spread:.0f} % | {ratio(row)} | {row['peak_kib'] / 1024:.0f} "
                f"| {row['input_kib'] / 1024:.0f} | {row['contours']} | {row['vertices']} | {verdict} |"
            )
    return "\n".join(lines)


def provenance(report):
    """The machine and every version, two lines."""
    versions = {row["peer"]: row["version"] for row in report["rows"] if "version" in row}
    commits = sorted({row["commit"] for row in report["rows"] if "commit" in row})
    told = [f"{peer} {version}" for peer, version in versions.items() if not peer.startswith("oblast-")]
    return f"{report['date']}, {report['machine']}.\n\nVersions: {'; '.join(told)}. Commit: {', '.join(commits)}."


def ratio(row):
    """A peer's time divided by ours of the same sitting; empty where ours failed."""
    if not row.get("ours_seconds"):
        return ""
    times = row["seconds"] / row["ours_seconds"]
    return f"{times:.2f}" if times < 10 else f"{times:.0f}"


def named(row):
    return row["peer"] + ("\\*" if row.get("verdict") == "contours only" else "")


def against(rows, prefix):
    """How many times longer than ours a family of peers takes at its best; or why there is no such figure."""
    best = best_peer(rows, prefix)
    if best:
        return ratio(best)
    family = [row for row in rows if row["peer"].startswith(prefix) and "unsupported" not in row]
    if not family:
        return "-"
    if any("seconds" in row for row in family):
        return "wrong"
    return "too slow" if all(row["error"].startswith("not done") for row in family) else "failed"


def summary_table(report):
    """One line a workload and operation. Ratios are a peer's time divided by ours (above 1: we are faster)."""
    by_threads = {}
    for (workload, operation, threads), rows in groups(report["rows"]).items():
        by_threads.setdefault((workload, operation), {})[threads] = rows
    counts = sorted({threads for measured in by_threads.values() for threads in measured})
    columns = ["workload", "edges"]
    for threads in counts:
        columns += [f"oblast, {threads} thread{'s' * (threads > 1)}", "best peer", "/ ours"]
    columns += ["GEOS / ours", "Clipper2 / ours", "loose contours / ours", "peak MiB", "leanest peer"]
    lines = ["| " + " | ".join(columns) + " |", "|---|--:|" + "--:|---|--:|" * len(counts) + "--:|--:|--:|--:|---|"]
    for (workload, operation), measured in by_threads.items():
        name = workload if operation == "default" else f"{workload}, {operation}"
        cells = [name, f"{next(iter(measured.values()))[0].get('edges', 0):,}"]
        for threads in counts:
            rows = measured.get(threads, [])
            reference, best = ours(rows), best_peer(rows)
            cells.append(duration(reference["seconds"]) if reference else "failed" if rows else "")
            cells.append(f"{best['peer']} {duration(best['seconds'])}" if best else "none" if rows else "")
            cells.append(ratio(best) if best else "")
        rows = measured[min(measured)]  # these peers know no threads
        leanest = min(good(rows), key=lambda r: r["peak_kib"], default=None)
        loose = best_of_contours(rows)
        cells += [against(rows, "geos"), against(rows, "clipper2"), f"{loose['peer']} {ratio(loose)}" if loose else "-"]
        cells.append(f"{ours(rows)['peak_kib'] / 1024:.0f}" if ours(rows) else "")
        cells.append(f"{named(leanest)} {leanest['peak_kib'] / 1024:.0f}" if leanest else "")
        lines.append("| " + " | ".join(cells) + " |")
    notes = (
        "Loose contours (\\*) were not assigned to polygons, and are not judged but by their area: no peer's best. "
        + faults(report)
    )
    return "\n".join([provenance(report), "", *lines, "", notes])


def faults(report):
    """How many results of each engine are invalid or wrong, and how often it failed or was too slow."""
    counts = {}
    for row in report["rows"]:
        bad = row.get("verdict") in ("invalid", "wrong area")
        fault = "invalid or wrong" if bad else "failed or too slow" if "error" in row else None
        per_peer = counts.setdefault(row["peer"], {})
        per_peer["of"] = per_peer.get("of", 0) + ("unsupported" not in row)
        if fault:
            per_peer[fault] = per_peer.get(fault, 0) + 1
    told = []
    for peer, per_peer in counts.items():
        what = [f"{number} {fault}" for fault, number in per_peer.items() if fault != "of"]
        if peer == "oblast" or what:
            told.append(f"{peer} {', '.join(what) or 'none'} of {per_peer['of']}")
    return f"Faulty results (those of peers do not count as best): {'; '.join(told)}."


def growth_table(report):
    """Time and memory per edge by size; growth is against the size above, a tenth as large."""
    lines = [
        "| workload | threads | engine | edges | median | ns an edge | growth | bytes an edge |",
        "|---|--:|---|--:|--:|--:|--:|--:|",
    ]
    series = {}
    for row in report["rows"]:
        family = row["workload"].rsplit("-", 1)[0]
        series.setdefault((family, row["operation"], row["threads"], row["peer"]), []).append(row)
    for (family, _, threads, peer), rows in series.items():
        before = None
        for row in sorted(rows, key=lambda r: r["edges"]):
            head = f"| {family} | {threads} | {peer} | {row['edges']:,} |"
            if "seconds" not in row:
                lines.append(f"{head} | | | {row.get('error') or row.get('unsupported')} |")
                continue
            each = row["seconds"] / row["edges"] * 1e9
            growth = f"{each / before:.2f}" if before else ""
            memory = (row["peak_kib"] - row["input_kib"]) * 1024 / row["edges"]
            lines.append(f"{head} {duration(row['seconds'])} | {each:.0f} | {growth} | {memory:.0f} |")
            before = each
    return "\n".join([provenance(report), "", *lines])
