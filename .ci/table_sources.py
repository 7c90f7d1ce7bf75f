"""What the benches and `compare` printed, read from benches/results."""

import csv
import itertools
import re


class Missing(Exception):
    """A file or a figure that a table needs and nobody has stored."""


class Sources:
    """The stored outputs of one machine."""

    def __init__(self, folder):
        self.folder = folder
        self.cache = {}

    def _file(self, pattern):
        files = sorted(self.folder.glob(pattern))
        if len(files) != 1:
            raise Missing(f"{len(files)} files like benches/results/{pattern} instead of one")
        return files[0]

    def _cached(self, key, read):
        if key not in self.cache:
            self.cache[key] = read()
        return self.cache[key]

    def markdown(self, name):
        """The tables of *-NAME.md: pairs of a heading and rows, each row from the column's name to the cell."""
        return self._cached(("markdown", name), lambda: tables_of(self._file(f"*-cores-{name}.md").read_text()))

    def rows(self, name, *words):
        """The rows of the table of *-NAME.md whose heading has all these words."""
        for heading, rows in self.markdown(name):
            if all(word in heading for word in words):
                return rows
        raise Missing(f"no table in *-{name}.md whose heading has {words}")

    def table(self, name, heading):
        """The first table of *-NAME.md below this heading, as it stands, without the spaces that align it."""
        lines = iter(self._file(f"*-cores-{name}.md").read_text().splitlines())
        if not any(line.lstrip("# ") == heading for line in lines if line.startswith("#")):
            raise Missing(f"no heading {heading!r} in *-{name}.md")
        lines = itertools.dropwhile(lambda line: not line.startswith("|"), lines)
        rows = [cells_of(line) for line in itertools.takewhile(lambda line: line.startswith("|"), lines)]
        rows[1:2] = [["---:" if cell.endswith(":") or all(map(is_figure, column)) else "---" for cell, *column in zip(*rows[1:])]]
        return "\n".join(f"| {' | '.join(row)} |" for row in rows)

    def rows_with(self, name, column):
        """The rows of the table of *-NAME.md that has a column of this name."""
        for _, rows in self.markdown(name):
            if rows and column in rows[0]:
                return rows
        raise Missing(f"no table in *-{name}.md with a column {column!r}")

    def prices_taken(self):
        """The prices of `src/tuning.rs`: unit -> nanoseconds."""
        tuning = (self.folder.parent.parent / "src" / "tuning.rs").read_text()
        prices = tuning.split("mod prices {")[1]
        found = re.findall(r"const ([A-Z_]+): u64 = ([0-9_]+);", prices)
        return {name.lower().replace("_", " "): int(tenths) / 10 for name, tenths in found}

    def peers(self):
        """The figures of unisize-peers: (subject, dimension, density, motion, n, contender) -> row."""

        def read():
            with open(self._file("*-cores.csv")) as file:
                key = ("subject", "dimension", "density", "motion", "count", "contender")
                return {tuple(row[name] for name in key): row for row in csv.DictReader(file)}

        return self._cached("peers", read)

    def peer(self, *key):
        try:
            return self.peers()[tuple(str(part) for part in key)]
        except KeyError:
            raise Missing(f"no row {key} in the figures of the peers") from None

    def compare(self, version):
        """What `compare` printed: options -> dimension -> scene -> figures."""
        read = lambda: compared(self._file(f"*-cores-compare-{version}.md").read_text())
        return self._cached(("compare", version), read)

    def scenes(self, version):
        """The names of all scenes that any run of `compare` has in any dimension."""
        return {name for run in self.compare(version).values() for scenes in run.values() for name in scenes}

    def scene(self, version, options, dimension, name, what):
        """One figure of `compare`, of the first run that had all these options."""
        for line, run in self.compare(version).items():
            if all(f"{option} " in f"{line} " for option in options) and name in run[dimension]:
                try:
                    return run[dimension][name][what]
                except KeyError:
                    raise Missing(f"no {what} of {name} in *-compare-{version}.md, {line}") from None
        raise Missing(f"no run of {name} with {options} in *-compare-{version}.md")


def tables_of(text):
    """Pairs of the last heading and the rows of a Markdown table, for each in the text."""
    found, heading, head = [], "", None
    for line in text.splitlines():
        if line.startswith("#"):
            heading, head = line.lstrip("# "), None
        elif not line.startswith("|"):
            head = None
        else:
            cells = cells_of(line)
            if head is None:
                head, is_first = cells, True
                found.append((heading, []))
            elif is_first:
                is_first = False
            else:
                found[-1][1].append(dict(zip(head, cells)))
    return found


def is_figure(cell):
    """Whether a cell holds a number, or says that there is none."""
    return re.fullmatch(r"[+-]?[0-9.,]+(e-?[0-9]+)?( %)?|[-–]", cell) is not None


def cells_of(line):
    """The cells of a line of a Markdown table."""
    return [cell.strip() for cell in line.strip().strip("|").split("|")]


def compared(text):
    found, run, dimension = {}, None, None
    for line in text.splitlines():
        if line.startswith("## "):
            run = found.setdefault(line.strip("# `"), {2: {}, 3: {}})
        elif start := re.match(r"rapier([23])d .* Whole steps", line):
            dimension = int(start.group(1))
        elif run is not None and dimension and (words := line.split()) and re.fullmatch(r"[a-z][a-z0-9.-]*", words[0]):
            if len(words) > 14 and words[-1].count("/") == 1:
                if words[11] != "yes":
                    raise Missing(f"contacts differ: {line}")
                scene = run[dimension].setdefault(words[0], {})
                scene["colliders"] = int(words[2])
                scene["default ms"], scene["ours ms"] = float(words[3]), float(words[4])
                scene["step"] = float(words[5])
                scene["default broad ms"], scene["ours broad ms"] = float(words[12]), float(words[13])
                scene["broad phase"] = float(words[14])
                if len(words) > 18:
                    scene["default without contact"], scene["ours without contact"] = int(words[15]), int(words[16])
                    scene["limit"] = float(words[17])
            elif len(words) == 8 and words[0] in run[dimension]:
                run[dimension][words[0]]["longest"] = float(words[3]) / float(words[4])
    return found
