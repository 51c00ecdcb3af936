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


def best_peer(rows):
    """The fastest peer with a good result, and None where there is none."""
    good = [r for r in rows if not r["peer"].startswith("oblast") and "seconds" in r and r.get("verdict") in GOOD]
    return min(good, key=lambda r: r["seconds"], default=None)


def ours(rows):
    return next((r for r in rows if r["peer"] == "oblast" and "seconds" in r), None)


def detail_table(rows):
    lines = [
        "| workload | operation | threads | engine | median | spread | / ours | peak MiB | input MiB | contours | vertices | result |",
        "|---|---|--:|---|--:|--:|--:|--:|--:|--:|--:|---|",
    ]
    for (workload, operation, threads), members in groups(rows).items():
        reference = ours(members)
        for row in members:
            head = f"| {workload} | {operation} | {threads} | {row['peer']} |"
            if "seconds" not in row:
                # "unsupported" is the driver's word that the peer does not claim it; anything else is a failure.
                reason = f"unsupported: {row['unsupported']}" if "unsupported" in row else f"FAILED: {row['error']}"
                lines.append(f"{head} | | | | | | | {reason} |")
                continue
            spread = (row.get("slowest", row["seconds"]) - row.get("fastest", row["seconds"])) / row["seconds"]
            ratio = f"{row['seconds'] / reference['seconds']:.2f}" if reference else ""
            verdict = row.get("verdict", "")
            if verdict in ("invalid", "wrong area"):
                verdict = f"{verdict.upper()}: {row['fault']}"
            lines.append(
                f"{head} {duration(row['seconds'])} | {100 * spread:.0f} % | {ratio} | {row['peak_kib'] / 1024:.0f} "
                f"| {row['input_kib'] / 1024:.0f} | {row['contours']} | {row['vertices']} | {verdict} |"
            )
    return "\n".join(lines)


def summary_table(report):
    """One line a workload: our time, the best peer's, and the ratio (above 1: we are faster)."""
    versions = {row["peer"]: row["version"] for row in report["rows"] if "version" in row}
    lines = [
        report["machine"],
        "",
        "; ".join(f"{peer} {version}" for peer, version in versions.items()),
        "",
        "| workload | operation | threads | oblast | best peer | its time | ratio | least peak of peers / ours |",
        "|---|---|--:|--:|---|--:|--:|--:|",
    ]
    for (workload, operation, threads), members in groups(report["rows"]).items():
        reference, best = ours(members), best_peer(members)
        if not reference:
            lines.append(f"| {workload} | {operation} | {threads} | failed | | | | |")
            continue
        head = f"| {workload} | {operation} | {threads} | {duration(reference['seconds'])} |"
        if not best:
            lines.append(f"{head} none finished with a valid result | | | |")
            continue
        peaks = [r["peak_kib"] for r in members if not r["peer"].startswith("oblast") and "seconds" in r and r.get("verdict") in GOOD]
        lines.append(
            f"{head} {best['peer']} | {duration(best['seconds'])} | {best['seconds'] / reference['seconds']:.2f} "
            f"| {min(peaks) / reference['peak_kib']:.2f} |"
        )
    return "\n".join(lines)
