#!/usr/bin/env python3
"""Compares two files of bench/run.py --json, figure by figure.

    bench/compare.py OLD.json NEW.json

A figure is worse if its least run is more than a threshold above the old one's: the larger of --threshold and of what the
runs of either differ by among themselves (median over least). Figures of a single run are shown but not judged, for nothing
is known of their noise; memory hardly varies and is judged by the threshold alone. Exit status 1 if anything is worse.
"""

import argparse
import json
import statistics
import sys
from pathlib import Path

from measures.figures import key, least
from measures.tables import number, table

JUDGED = {"s", "MiB"}  # less is better; other units (counts) are only shown if they differ
LEAST_SECONDS = 0.01  # below this the clock's own grain decides
BETTER, SAME, WORSE, SHOWN = "better", "", "WORSE", "one run"


def spread(one):
    """How much the middle run is above the least one, as a share."""
    low = least(one)
    return statistics.median(one["runs"]) / low - 1 if low > 0 else 0.0


def threshold_for(old, new, floor):
    if old["unit"] == "MiB":
        return floor
    return max(floor, spread(old), spread(new))


def verdict(old, new, floor):
    """(ratio new / old, threshold, word)."""
    before, after = least(old), least(new)
    if before == 0:
        return None, floor, SAME if after == 0 else SHOWN
    ratio, threshold = after / before, threshold_for(old, new, floor)
    if old["unit"] not in JUDGED:
        return ratio, threshold, SAME if ratio == 1 else SHOWN
    if old["unit"] == "s" and min(len(old["runs"]), len(new["runs"])) < 2:
        return ratio, threshold, SHOWN
    if old["unit"] == "s" and max(before, after) < LEAST_SECONDS and old["group"] != "kernels":
        return ratio, threshold, SAME
    if ratio > 1 + threshold:
        return ratio, threshold, WORSE
    return ratio, threshold, BETTER if ratio < 1 / (1 + threshold) else SAME


def compared(old_figures, new_figures, floor):
    """[(figure of old, of new, ratio, threshold, word)] of what both have, in the new one's order."""
    before = {key(one): one for one in old_figures}
    rows = []
    for new in new_figures:
        old = before.get(key(new))
        if old:
            rows.append((old, new, *verdict(old, new, floor)))
    return rows


def read(file):
    try:
        kept = json.loads(Path(file).read_text())
        return kept["machine"], kept["figures"]
    except (OSError, ValueError, KeyError, TypeError) as error:
        sys.exit(f"{file}: expected figures of bench/run.py --json ({error})")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("old", type=Path)
    parser.add_argument("new", type=Path)
    parser.add_argument("--threshold", type=float, default=0.05, metavar="SHARE", help="what is noise in any case (0.05)")
    parser.add_argument("--all", action="store_true", help="also figures that are the same")
    options = parser.parse_args()
    (old_machine, old), (new_machine, new) = read(options.old), read(options.new)
    rows = compared(old, new, options.threshold)
    print(f"old: {old_machine['commit']}, {old_machine['date']}; new: {new_machine['commit']}, {new_machine['date']}")
    for what in ("processor", "compiler", "build_type"):
        if old_machine[what] != new_machine[what]:
            print(f"not the same {what.replace('_', ' ')}: {old_machine[what]}; {new_machine[what]}")
    shown = [row for row in rows if options.all or row[4]]
    if shown:
        print("\n" + table(["group", "figure", "unit", "old", "new", "new / old", "threshold", ""],
                           [[o["group"], o["name"], o["unit"], least(o), least(n), ratio, f"{100 * threshold:.0f} %", word]
                            for o, n, ratio, threshold, word in shown], text=(0, 1, 2, -1)))
    worse, better = (sum(row[4] == word for row in rows) for word in (WORSE, BETTER))
    gone = len({key(one) for one in old} - {key(one) for one in new})
    print(f"\n{len(rows)} figures compared: {worse} worse, {better} better, "
          f"{sum(row[4] == SHOWN for row in rows)} not judged; {gone} of the old ones are missing")
    if not rows:
        sys.exit("the files have no figure in common")
    sys.exit(1 if worse else 0)


if __name__ == "__main__":
    main()
