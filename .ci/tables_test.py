"""Tests of `.ci/tables` and `.ci/criterion`, on small files whose tables are known: python3 .ci/tables_test.py"""

import importlib.machinery
import importlib.util
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True

CI = pathlib.Path(__file__).resolve().parent

from table_makers import fewer, make, ratio, significant
from table_sources import Missing, Sources, tables_of


def script(name):
    """A script without an ending, as a module."""
    loader = importlib.machinery.SourceFileLoader(name, str(CI / name))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(name, loader))
    loader.exec_module(module)
    return module


SCALE = """# Head

| dimension | bodies | kernel, ns a box | update, ns a body | longest | bytes a body | Rapier 0.27: update | longest | bytes |
|---|--:|--:|--:|--:|--:|--:|--:|--:|
| 2D | 100000 | 41 | 90 | 228 | 246 | 1543 | 636 | 243 |
| 3D | 100000 | 54 | 152 | 341 | 328 | 884 | 1086 | 296 |
"""

SCALE_TABLE = """| bodies | 2D: kernel | update | bytes | Rapier 0.27: update | 3D: kernel | update | bytes | Rapier 0.27: update |
|---|---:|---:|---:|---:|---:|---:|---:|---:|
| 100,000 | 41 | 90 | 246 | 1,543 | 54 | 152 | 328 | 884 |"""

COMPARED = """## `compare --rays 0 --filter {level}`

```text
rapier{dim}d 0.27. Whole steps: each broad phase alone, queries included.

tile-map          500     30500     5.873    2.142  {whole} 2.71-2.77     1139    1139      789         0   yes      6.854     0.212  32.29  ok/ok
ships             500     30500     5.873    2.142  {whole} 2.71-2.77     1139    1139      789         0   yes      6.854     0.212  32.29  ok/ok
ghosts            500     30500     5.873    2.142  {whole} 2.71-2.77     1139    1139      789         0   yes      6.854     0.212  32.29  ok/ok

updates, ms                   mean              longest         pairs, all     rays
tile-map           0.329     0.130      1.126     0.563      3967      3967        0
```
"""

# A scene as `compare` printed it at first, and one as it does now, with three columns more.
BOTH_LAYOUTS = """## `compare-opened --rays {rays} --filter off`

```text
rapier{dim}d 0.36. Whole steps: each broad phase alone, queries included. The rest: the default drives, unisize follows.
Without contact: of each broad phase alone. Limit: the ratio of whole steps with a broad phase that takes no time.

tile-map          500     30500     5.873    2.142  2.742 2.71-2.77     1139    1139      789         0   yes      6.854     0.212  32.29  ok/ok
pyramid-8000         8000      8001     9.000    6.000  1.500 1.49-1.51     1139    1139      789         0   yes      6.854     0.212  32.29      350     349   3.25  ok/ok
```
"""

HEAD = "subject,dimension,density,motion,count,contender,setting,frames,typical_ms,mean_ms,worst_ms,pairs,ratio\n"


def peers():
    lines = []
    for dim, density in ((2, "0.2"), (2, "0.8"), (3, "0.1"), (3, "0.4")):
        for motion in ("all move", "one in 10 moves", "one in 100 moves", "all in their margin"):
            for count in (100, 1000, 10000, 131072):
                contenders = {
                    '"unisize for 0.27, lists"': (1, 8),
                    '"Rapier 0.27, BVH"': (6, 7),
                    '"unisize for 0.36, boxes handed over"': (2, 3),
                    '"Rapier 0.36, BVH"': (3, 9),
                }
                for name, (mean, worst) in contenders.items():
                    lines.append(f"updates,{dim},{density},{motion},{count},{name},,60,{mean},{mean},{worst},5,1\n")
    return HEAD + "".join(lines)


class Tables(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.results = self.root / "benches" / "results"
        self.results.mkdir(parents=True)
        (self.root / "docs").mkdir()
        (self.root / "README.md").write_text("Nothing\n")
        self.store("scale", SCALE)
        self.sources = Sources(self.results)

    def store(self, name, text):
        (self.results / f"some-processor-2-cores-{name}.md").write_text(text)

    def run_on_root(self, *options):
        command = [sys.executable, str(CI / "tables"), "--root", str(self.root), *options]
        return subprocess.run(command, capture_output=True, text=True)

    def test_numbers_are_written_as_in_text(self):
        self.assertEqual([ratio(x) for x in (0.987, 1.995, 2, 9.99, 10.4)], ["*0.99*", "2.00", "**2.00**", "**9.99**", "**10**"])
        self.assertEqual([significant(x) for x in (9097.8, 272.0, 17.94, 5.0, 0.0336, 0.00012, 0.0)], ["9,098", "272", "17.9", "5", "0.0336", "0.00012", "0"])
        self.assertEqual(fewer("65536", 65536), "")
        self.assertEqual(fewer("16384, stopped after 6", 65536), " (n = 16,384, stopped after 6)")

    def test_every_table_of_a_page_is_under_its_heading(self):
        found = tables_of("# a\n\n| x | y |\n|---|---|\n| 1 | 2 |\n\n## b\n| x |\n|---|\n| 3 |\n| 4 |\n\n| z |\n|---|\n")
        self.assertEqual(found, [("a", [{"x": "1", "y": "2"}]), ("b", [{"x": "3"}, {"x": "4"}]), ("b", [])])

    def test_a_table_is_made_of_its_source(self):
        self.assertEqual(make("scale", self.sources), SCALE_TABLE)

    def test_a_stored_table_can_be_copied(self):
        copied = make("copied scale: Head", self.sources)
        self.assertIn("| 2D | 100000 | 41 | 90 |", copied)

    def test_updates_are_compared_with_what_they_replace(self):
        (self.results / "some-processor-2-cores.csv").write_text(peers())
        lines = make("updates", self.sources).split("\n")
        self.assertEqual(lines[2], "| all | 10,000 |" + " **6.00** | 1.50 |" * 4)
        self.assertEqual(len(lines), 2 + 4 * 2)
        # Where nothing is deferred, there is no other figure.
        without = make("updates-without-deferred", self.sources).split("\n")
        self.assertEqual(without[2], "| all | 10,000 |" + " 1.50 | – |" * 4)
        # Bold where unisize's own is the longer one.
        longest = make("longest-updates", self.sources).split("\n")
        self.assertEqual(longest[2], "| all | 100 | 60 |" + " **8 / 7** | 3 / 9 |" * 4)

    def test_filters_are_told_apart(self):
        runs = {("off", 2): "1.5", ("bodies", 2): "3.5", ("groups", 2): "4.5", ("shapes", 2): "4.6",
                ("off", 3): "1.1", ("bodies", 3): "3.1", ("groups", 3): "4.1", ("shapes", 3): "4.2"}
        self.store("compare-filter", "".join(COMPARED.format(level=level, dim=dim, whole=whole) for (level, dim), whole in runs.items()))
        lines = make("filter", self.sources).split("\n")
        self.assertEqual(lines[2], "| map of 30,000 fixed blocks, 500 balls; `PairFilter::Bodies` | 1.50 | **3.50** | 1.10 | **3.10** |")
        self.assertEqual(lines[4], "| 3,000 ghosts; `PairFilter::Groups` | 1.50 | **4.50** | 1.10 | **4.10** |")
        lines = make("filter-levels", self.sources).split("\n")
        self.assertEqual(lines[-1], "| longest update of the map |" + " **2.00** |" * 8)

    def test_a_page_may_be_older_than_scenes_and_columns(self):
        self.store("compare-0-36", "".join(BOTH_LAYOUTS.format(rays=rays, dim=dim) for rays in (0, 1, 16) for dim in (2, 3)))
        lines = make("whole-steps-0-36", self.sources).split("\n")
        self.assertEqual([line.split(" | ")[:3] for line in lines[2:4]], [["| map of fixed blocks, 500 balls", "30,500", "**2.74**"], ["| pyramid of 8,000", "8,001", "1.50"]])
        self.assertEqual(len(lines), 2 + 2 + 1)
        figure = lambda name, what: self.sources.scene("0-36", ["--rays 1"], 3, name, what)
        self.assertEqual([figure("pyramid-8000", what) for what in ("broad phase", "default without contact", "ours without contact", "limit")], [32.29, 350, 349, 3.25])
        with self.assertRaises(Missing):
            figure("tile-map", "limit")

    def test_what_is_missing_is_told(self):
        for name in ("no-such-table", "floor", "updates", "copied scale: no such heading"):
            with self.assertRaises(Missing):
                make(name, self.sources)

    def test_a_figure_that_differs_is_named(self):
        page = self.root / "docs" / "page.md"
        page.write_text(f"Text\n\n<!-- table scale -->\n{SCALE_TABLE}\n<!-- end of scale -->\n\nMore\n")
        self.assertEqual(self.run_on_root("--check").returncode, 0)
        wrong = page.read_text().replace("| 152 |", "| 151 |")
        page.write_text(wrong)
        checked = self.run_on_root("--check")
        self.assertEqual(checked.returncode, 1)
        self.assertIn("docs/page.md:6: table scale: 100,000, update: '151' instead of '152'", checked.stderr)
        self.assertEqual(page.read_text(), wrong)
        self.assertEqual(self.run_on_root().returncode, 0)
        self.assertIn("| 152 |", page.read_text())
        self.assertTrue(page.read_text().endswith("<!-- end of scale -->\n\nMore\n"))

    def test_a_table_without_source_or_end_is_a_fault(self):
        (self.root / "README.md").write_text("\n<!-- table floor -->\n<!-- end of floor -->\n<!-- table scale -->\nx\n")
        checked = self.run_on_root("--check")
        self.assertEqual(checked.returncode, 1)
        self.assertIn("README.md:2: table floor: 0 files like", checked.stderr)
        self.assertIn("table scale has no end", checked.stderr)


class Criterion(unittest.TestCase):
    def test_means_and_ratios_are_in_a_table(self):
        with tempfile.TemporaryDirectory() as home:
            for function, value in (("default", 9000.0), ("unisize", 3000.0)):
                folder = pathlib.Path(home) / "group" / function / "100" / "new"
                folder.mkdir(parents=True)
                name = {"group_id": "update/2D", "function_id": function, "value_str": "100"}
                (folder / "benchmark.json").write_text(json.dumps(name))
                bounds = {"lower_bound": value - 100, "upper_bound": value + 100}
                mean = {"point_estimate": value, "confidence_interval": bounds}
                (folder / "estimates.json").write_text(json.dumps({"mean": mean}))
            criterion = script("criterion")
            groups = criterion.measured(pathlib.Path(home))
            lines = list(criterion.tables(groups))
        self.assertEqual(lines[1], "| n | default | unisize | default / unisize |")
        self.assertEqual(lines[3], "| 100 | 9 µs (8.9 µs to 9.1 µs) | 3 µs (2.9 µs to 3.1 µs) | 3.00 |")


if __name__ == "__main__":
    unittest.main()
