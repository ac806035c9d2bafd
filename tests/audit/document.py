#!/usr/bin/python3
"""Writes the tables of docs/audit.md about the study of damages.

  document.py VERDICTS.json…

The files are those of damage.py --json; verdicts on one recording may be in several. Without files only
the table of damages that no file can tell is written."""
import json
import re
import sys
from collections import Counter, defaultdict
from pathlib import Path

from damage import FAULTS, VERDICTS
from damage_list import undecidable_table

PAGE = Path(__file__).resolve().parents[2] / "docs/audit.md"
TABLE = r"(<!-- {}: .*? -->\n)(.*?)(<!-- until here -->)"
COLUMNS = [word for word in VERDICTS if word not in FAULTS]


def counts_table(verdicts):
    counts = defaultdict(Counter)
    for one in verdicts:
        counts[one["recording"]][one["verdict"]] += 1
    lines = ["| recording | " + " | ".join(COLUMNS) + " | silent or wrong |", "|---" * (len(COLUMNS) + 2) + "|"]
    for recording, count in sorted(counts.items()):
        cells = [*(count[word] for word in COLUMNS), sum(count[word] for word in FAULTS)]
        lines.append(f"| {recording} | " + " | ".join(map(str, cells)) + " |")
    return "\n".join(lines) + "\n"


def with_table(page, name, table):
    return re.sub(TABLE.format(name), lambda found: found[1] + table + found[3], page, count=1, flags=re.S)


def main(files):
    verdicts = [one for file in files for one in json.loads(Path(file).read_text())]
    page = with_table(PAGE.read_text(encoding="utf-8"), "undecidable", undecidable_table())
    if verdicts:
        page = with_table(page, "study", counts_table(verdicts))
    PAGE.write_text(page, encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])
