#!/usr/bin/env python3
"""The scripts of bench/: what they read, compare and measure. usage: bench_scripts_test.py RINCEAU SOURCES BUILD"""

import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

RINCEAU, SOURCES, BUILD = (Path(word).resolve() for word in sys.argv[1:4])
sys.path.insert(0, str(SOURCES / "bench"))

import compare
import join_runs
from measures import kernels, machine, made_drawings, made_meshes, measure, papers, tables
from measures.figures import figure


def seconds(name, *runs, unit="s", group="commands"):
    return figure(group, name, unit, runs)


class Comparing(unittest.TestCase):
    def word(self, old, new, floor=0.05):
        return compare.verdict(old, new, floor)[2]

    def test_a_figure_beyond_the_threshold_is_worse_or_better(self):
        self.assertEqual(self.word(seconds("a", 1.0, 1.01), seconds("a", 1.2, 1.21)), compare.WORSE)
        self.assertEqual(self.word(seconds("a", 1.2, 1.21), seconds("a", 1.0, 1.01)), compare.BETTER)
        self.assertEqual(self.word(seconds("a", 1.0, 1.01), seconds("a", 1.04, 1.05)), compare.SAME)

    def test_noisy_runs_widen_the_threshold(self):
        steady, noisy = seconds("a", 1.0, 1.0, 1.0), seconds("a", 1.2, 1.5, 1.6)
        self.assertEqual(self.word(steady, seconds("a", 1.2, 1.2, 1.2)), compare.WORSE)
        self.assertEqual(self.word(steady, noisy), compare.SAME)

    def test_a_single_run_is_not_judged_but_memory_is(self):
        self.assertEqual(self.word(seconds("a", 1.0), seconds("a", 2.0, 2.0)), compare.SHOWN)
        self.assertEqual(self.word(seconds("a", 10, unit="MiB"), seconds("a", 12, unit="MiB")), compare.WORSE)

    def test_only_common_figures_are_compared(self):
        rows = compare.compared([seconds("a", 1, 1), seconds("b", 1, 1)], [seconds("b", 1, 1), seconds("c", 1, 1)], 0.05)
        self.assertEqual([row[1]["name"] for row in rows], ["b"])

    def status(self, folder, old, new):
        about = dict(commit="c", date="d", processor="p", compiler="g", build_type="Release")
        for name, figures in (("old", old), ("new", new)):
            (folder / name).write_text(json.dumps({"machine": about, "figures": figures}))
        return subprocess.run([sys.executable, SOURCES / "bench/compare.py", folder / "old", folder / "new"],
                              capture_output=True, text=True)

    def test_the_command_says_what_is_worse_by_its_status(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            old = [seconds("analyze", 1.0, 1.0), seconds("render", 1.0, 1.0)]
            same = self.status(folder, old, old)
            worse = self.status(folder, old, [seconds("analyze", 1.5, 1.5), seconds("render", 0.5, 0.5)])
            self.assertEqual(same.returncode, 0, same.stderr)
            self.assertEqual(worse.returncode, 1)
            self.assertIn("| commands | analyze | s | 1 | 1.50 | 1.50 | 5 % | WORSE |", worse.stdout)
            self.assertIn("1 worse, 1 better", worse.stdout)
            (folder / "old").write_text("{}")
            broken = subprocess.run([sys.executable, SOURCES / "bench/compare.py", folder / "old", folder / "new"],
                                    capture_output=True, text=True)
            self.assertNotEqual(broken.returncode, 0)
            self.assertNotIn("Traceback", broken.stderr)

    def test_runs_of_rounds_are_joined_in_turn(self):
        rounds = [{"machine": {}, "figures": [seconds("a", 1.0), seconds("b", 5.0)]},
                  {"machine": {}, "figures": [seconds("b", 6.0), seconds("a", 2.0)]}]
        runs = {one["name"]: one["runs"] for one in join_runs.joined(rounds)["figures"]}
        self.assertEqual(runs, {"a": [1.0, 2.0], "b": [5.0, 6.0]})


def program(file, text):
    file.write_text("#!/bin/sh\n" + text)
    file.chmod(0o755)


@unittest.skipUnless(shutil.which("git"), "git is not there")
class ComparingCommits(unittest.TestCase):
    """In a repository that holds bench/ alone, with stand-ins for cmake and ninja that put the program there ready-made."""

    def git(self, folder, *words):
        return subprocess.run(["git", "-c", "user.name=n", "-c", "user.email=e@example.org", *words], cwd=folder, check=True,
                              capture_output=True, text=True).stdout

    def test_both_are_measured_in_turn_and_nothing_is_left(self):
        with tempfile.TemporaryDirectory() as name:
            tree, tools = Path(name) / "tree", Path(name) / "tools"
            shutil.copytree(SOURCES / "bench", tree / "bench", ignore=shutil.ignore_patterns("kernels", "studies", "__pycache__"))
            tools.mkdir()
            program(tools / "cmake", "exit 0\n")
            program(tools / "ninja", f'mkdir -p "$2/cli" && ln -s "{RINCEAU}" "$2/cli/rinceau"\n')
            self.git(tree, "init", "--quiet")
            self.git(tree, "add", ".")
            self.git(tree, "commit", "--quiet", "-m", "one")
            self.git(tree, "commit", "--quiet", "--allow-empty", "-m", "two")
            ran = subprocess.run([tree / "bench/compare_commits.sh", "HEAD~1", "HEAD", "--", "--quick", "--match", "derive"],
                                 env={**os.environ, "PATH": f"{tools}:{os.environ['PATH']}", "TMPDIR": name},
                                 capture_output=True, text=True)
            self.assertIn(ran.returncode, (0, 1), ran.stderr)  # 1: the machine was busy with something else meanwhile
            old, new = (self.git(tree, "rev-parse", "--short=12", commit).strip() for commit in ("HEAD~1", "HEAD"))
            self.assertRegex(ran.stdout, f"old: {old}, .*; new: {new}, ")
            self.assertRegex(ran.stdout, r"\n6 figures compared: \d worse, \d better, 0 not judged; 0 of the old ones")
            self.assertEqual(len(self.git(tree, "worktree", "list").splitlines()), 1)
            self.assertEqual(sorted(left.name for left in Path(name).iterdir()), ["tools", "tree"])


class Reading(unittest.TestCase):
    def test_kernels_are_read_with_all_repetitions_and_their_real_size(self):
        one = {"run_type": "iteration", "time_unit": "ms", "run_name": "rule_choice/nested/1000/process_time"}
        report = {"benchmarks": [
            {**one, "cpu_time": 2.0, "items_per_second": 480_000.0},
            {**one, "cpu_time": 3.0, "items_per_second": 320_000.0},
            {**one, "run_type": "aggregate", "cpu_time": 2.5},
            {**one, "run_name": "kd_tree_build/1000/process_time", "time_unit": "s", "cpu_time": 0.25},
        ]}
        self.assertEqual(kernels.parsed(report), {("rule choice, nested", 1000): (960, [0.002, 0.003]),
                                                  ("kd tree build", 1000): (1000, [0.25])})

    def test_definitions_are_set_and_none_is_missed(self):
        self.assertEqual(made_drawings.with_definitions("define rows = 16\nx\n", {"rows": 3}), "define rows = 3\nx\n")
        with self.assertRaises(ValueError):
            made_drawings.with_definitions("define rows = 16\n", {"columns": 3})

    def test_rules_of_a_shape_grammar_are_counted(self):
        self.assertEqual(papers.rules_of(SOURCES / "samples/surface/rings_a.fgsg"), 3)


class Tables(unittest.TestCase):
    def test_the_exponent_is_that_of_the_power(self):
        self.assertAlmostEqual(tables.exponent([(n, 3 * n**1.5) for n in (10, 100, 1000)]), 1.5)
        self.assertIsNone(tables.exponent([(10, 1), (10, 2)]))

    def test_numbers_have_three_digits(self):
        shown = [tables.number(x) for x in (0.012345, 1.2345, 12.345, 1234.5, 7, None, "text")]
        self.assertEqual(shown, ["0.0123", "1.23", "12.3", "1,234", "7", "–", "text"])

    def test_short_rows_are_filled_and_text_stands_left(self):
        self.assertEqual(tables.table(["a", "b", "c"], [["x", 1]], text=(0, -1)),
                         "| a | b | c |\n|---|--:|---|\n| x | 1 |  |")


class Meshes(unittest.TestCase):
    def test_faces_cut_in_four_are_the_same_surface(self):
        def euler(positions, triangles):
            edges = {frozenset(pair) for a, b, c in triangles for pair in ((a, b), (b, c), (c, a))}
            return len(positions) - len(edges) + len(triangles)

        coarse = made_meshes.read(SOURCES / "samples/surface/three_rings.obj")
        fine = made_meshes.cut(*coarse)
        self.assertEqual(len(fine[1]), 4 * len(coarse[1]))
        self.assertEqual(euler(*fine), euler(*coarse))


class Measuring(unittest.TestCase):
    def test_seconds_and_memory_are_those_of_the_command(self):
        idle = measure.taken(["sleep", "0.2"])
        busy = measure.taken([sys.executable, "-c", "x = bytearray(90 << 20)\nimport time\n"
                              "while time.process_time() < 0.25: pass"], runs=2)
        self.assertLess(idle.seconds, 0.1)
        self.assertGreaterEqual(busy.seconds, 0.25)
        self.assertEqual(len(busy.runs), 2)
        self.assertTrue(90 < busy.peak_mib < 150, busy.peak_mib)
        self.assertLess(idle.peak_mib, 20)

    def test_a_command_that_fails_is_no_figure(self):
        with self.assertRaisesRegex(measure.CommandFailed, "status 3: no"):
            measure.taken(["sh", "-c", "echo no >&2; exit 3"])
        with self.assertRaisesRegex(measure.CommandFailed, "no_such_program"):
            measure.taken(["no_such_program"])

    def test_the_machine_is_described_also_without_a_repository(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertEqual(machine.described(Path(folder), Path(folder))["commit"], "unknown")

    def test_the_one_command_measures_and_keeps_what_it_prints(self):
        with tempfile.TemporaryDirectory() as name:
            kept = Path(name) / "kept.json"
            ran = subprocess.run([sys.executable, SOURCES / "bench/run.py", BUILD, "--rinceau", RINCEAU, "--quick", "--only",
                                  "commands", "--match", "derive", "--json", kept], capture_output=True, text=True)
            self.assertEqual(ran.returncode, 0, ran.stderr)
            self.assertIn("| derive | elements | 960 | 3,136 | 10,000 |", ran.stdout)
            figures = json.loads(kept.read_text())["figures"]
            self.assertEqual([one["size"] for one in figures if one["unit"] == "s"], [960, 3136, 10000])
            self.assertTrue(all(one["command"].startswith("rinceau derive ornament_") for one in figures))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
