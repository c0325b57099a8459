#!/usr/bin/env python3
"""Whether the pages are right about the tree: check_docs.py ROOT. Prints what is wrong, one fault a line."""
import sys
from pathlib import Path

import links
import listed
import names
import shown_code

CHECKS = {"links": links.faults, "names": names.faults, "listed": listed.faults, "shown code": shown_code.faults}


def main():
    root = Path(sys.argv[1]).resolve()
    found = [fault for check in CHECKS.values() for fault in check(root)]
    if found:
        print("\n".join(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
