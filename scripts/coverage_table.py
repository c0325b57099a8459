"""Which share of the lines of each folder ran: a table from gcovr's summary.

coverage_table.py SUMMARY.json LEAST

The exit status is 0 only if the share of all lines is at least LEAST percent.
"""
import collections
import json
import sys


def main(path, least):
    with open(path, encoding='utf-8') as file:
        files = json.load(file)['files']
    lines, run = collections.Counter(), collections.Counter()
    for entry in files:
        for folder in (entry['filename'].split('/')[0], 'all'):
            lines[folder] += entry['line_total']
            run[folder] += entry['line_covered']
    print('| folder | lines | run | share |\n|---|--:|--:|--:|')
    for folder in sorted(lines, key=lambda name: (name == 'all', name)):
        print(f'| {folder} | {lines[folder]:,} | {run[folder]:,} | {100 * run[folder] / max(lines[folder], 1):.1f} % |')
    print('\nLeast covered:')
    worst = sorted(files, key=lambda entry: (entry['line_covered'] - entry['line_total'], entry['filename']))[:10]
    for entry in worst:
        print(f"- {entry['filename']}: {entry['line_total'] - entry['line_covered']} of {entry['line_total']} lines do not run")
    return 0 if lines['all'] > 0 and 100 * run['all'] >= float(least) * lines['all'] else 1


if __name__ == '__main__':
    sys.exit(main(*sys.argv[1:]))
