"""The tables of the documentation: each by its name, made from what is stored in benches/results."""

import math

from table_scenes import scenes_of
from table_sources import Missing

OURS, DEFAULT = "unisize for 0.27, lists", "Rapier 0.27, BVH"
OURS_036, DEFAULT_036 = "unisize for 0.36, boxes handed over", "Rapier 0.36, BVH"
REST_036 = f"{DEFAULT_036}, without the deferred optimization"

# Dimension and density.
CASES = [(2, "0.2"), (2, "0.8"), (3, "0.1"), (3, "0.4")]

MOTIONS = {
    "all move": "all",
    "one in 10 moves": "one in ten",
    "one in 100 moves": "one in a hundred",
    "all in their margin": "all, within their margin",
}


def ratio(value):
    shown = f"{value:.2f}" if value < 10 else f"{value:.0f}"
    return f"**{shown}**" if value >= 2 else f"*{shown}*" if shown < "1" else shown


def significant(value):
    """Three digits, as in text."""
    return f"{value:,.0f}" if value >= 100 else f"{value:.3g}" if value >= 0.001 or value == 0 else f"{value:.5f}"


def thousands(cell):
    return f"{int(cell):,}" if cell.isdigit() else cell


def table(head, rows, right=True):
    line = "|---" + ("|---:" if right else "|---") * (len(head) - 1) + "|"
    return "\n".join(["| " + " | ".join(head) + " |", line] + ["| " + " | ".join(row) + " |" for row in rows])


def mean(values):
    return math.exp(sum(map(math.log, values)) / len(values))


# README.md: `compare`.


def of_scenes(sources, head, columns, first):
    """A row a scene that the first column's page has; a column is (version, rays, dimension, figure). Before them, the number of colliders may stand."""
    scenes = scenes_of(sources, columns[0][0])
    figure = lambda column, name: sources.scene(column[0], [f"--rays {column[1]}"], column[2], name, column[3])
    cells = {name: [figure(column, name) for column in columns] for name in scenes}
    colliders = lambda name: [f"{figure(first, name):,}"] if first else []
    rows = [[label, *colliders(name), *map(ratio, cells[name])] for name, label in scenes.items()]
    means = [ratio(mean(column)) for column in zip(*cells.values())]
    rows.append(["geometric mean", *([""] if first else []), *means])
    return table(head, rows, right=False)


def whole_steps(version):
    head = ["scene", "colliders", "2D", "3D", "one ray, 2D", "3D", "16 rays, 2D", "3D"]
    columns = [(version, rays, dim, "step") for rays in (0, 1, 16) for dim in (2, 3)]
    return lambda sources: of_scenes(sources, head, columns, (version, 0, 3, "colliders"))


def both_parallel(sources):
    version = "0-36-parallel"
    head = ["scene", "colliders", "whole step, 2D", "3D", "broad phase, 2D", "3D"]
    columns = [(version, 0, dim, what) for what in ("step", "broad phase") for dim in (2, 3)]
    return of_scenes(sources, head, columns, (version, 0, 3, "colliders"))


def broad_phase(sources):
    head = ["scene", "0.36, 2D", "3D", "longest update, 2D", "3D", "0.27, 2D", "3D", "longest update, 2D", "3D"]
    figures = [(what, dim) for what in ("broad phase", "longest") for dim in (2, 3)]
    columns = [(version, 0, dim, what) for version in ("0-36", "0-27") for what, dim in figures]
    return of_scenes(sources, head, columns, None)


def beyond_free(sources):
    """Whole steps beside what a broad phase that takes no time would give, and the pairs that decide it."""
    figure = lambda dim, name, what: sources.scene("0-36", ["--rays 0"], dim, name, what)
    head = ["scene"]
    for dim in ("2D", "3D"):
        head += [f"whole step, {dim}", "free", "pairs without contact", "unisize"]
    whats = ("default without contact", "ours without contact")
    rows = []
    for name, label in scenes_of(sources, "0-36").items():
        rows.append([label])
        for dim in (2, 3):
            step, free = figure(dim, name, "step"), figure(dim, name, "limit")
            shown = f"**{step:.2f}**" if step > free else f"{step:.2f}"
            rows[-1] += [shown, f"{free:.2f}", *(f"{figure(dim, name, what):,}" for what in whats)]
    return table(head, rows)


FILTERED = [
    ("tile-map", "map of 30,000 fixed blocks, 500 balls", "bodies"),
    ("ships", "three rigid ships of 1,728 cubes", "bodies"),
    ("ghosts", "3,000 ghosts", "groups"),
]


def filtered(sources, level, dim, name, what="step"):
    return sources.scene("filter", [f"--filter {level}"], dim, name, what)


def filter_(sources):
    head = ["whole step, default over unisize (60 steps)", "2D", "2D, filtered", "3D", "3D, filtered"]
    rows = []
    for name, label, best in FILTERED:
        cells = [ratio(filtered(sources, level, dim, name)) for dim in (2, 3) for level in ("off", best)]
        rows.append([f"{label}; `PairFilter::{best.title()}`", *cells])
    return table(head, rows, right=False)


def filter_levels(sources):
    levels = ("off", "bodies", "groups", "shapes")
    head = ["scene", *(f"`{level.title()}` {dim}D" for dim in (2, 3) for level in levels)]
    row = lambda name, what: [ratio(filtered(sources, level, dim, name, what)) for dim in (2, 3) for level in levels]
    rows = [[label, *row(name, "step")] for name, label, _ in FILTERED]
    rows.append(["longest update of the map", *row("tile-map", "longest")])
    return table(head, rows)


AIMS_036 = [
    ("broad phase, gas of 10,000", 6, "broad phase", ["gas"]),
    ("broad phase, swarm of 10,000", 6, "broad phase", ["swarm"]),
    ("broad phase, 2,000 falling balls", 3, "broad phase", ["falling-balls"]),
    ("broad phase, map", 2, "broad phase", ["tile-map"]),
    ("broad phase, ships", 2, "broad phase", ["ships"]),
    ("whole step, gas", 1.4, "step", ["gas"]),
    ("whole step, swarm", 1.7, "step", ["swarm"]),
    ("whole step, the slowest of all scenes", 1, "step", None),
]


def aims_036(sources):
    rows = []
    for label, aim, what, names in AIMS_036:
        cells = []
        for dim in (2, 3):
            figures = {name: sources.scene("0-36", ["--rays 0"], dim, name, what) for name in names or scenes_of(sources, "0-36")}
            worst = min(figures, key=figures.get)
            shown = f"{figures[worst]:.2f}"
            cells.append((f"**{shown}**" if figures[worst] >= aim else shown) + (f", {worst}" if len(figures) > 1 else ""))
        rows.append([label, f"{aim:g}", *cells])
    return table(["what", "aim", "2D", "3D"], rows)


def share(sources):
    """Of `share` for Rapier 0.27, of `compare` for 0.36."""
    rows = []
    for row in sources.rows("share"):
        rows.append(["0.27", row["dimension"], thousands(row["balls"]), row["broad phase"], row["ms of a step"], row["of which it takes"], row["part"]])
    for dim in (2, 3):
        for which in ("default", "ours"):
            get = lambda what: sources.scene("0-36", ["--rays 0"], dim, "falling-balls", f"{which} {what}")
            step, its = get("ms"), get("broad ms")
            name = "unisize" if which == "ours" else which
            rows.append(["0.36", f"{dim}D", "2,000", name, f"{step:.2f}", f"{its:.3f}", f"{100 * its / step:.1f} %"])
    return table(["Rapier", "dimension", "balls", "broad phase", "ms of a step", "of which it takes", "part"], rows)


# The peers.


def faster(sources, case, motion, count, ours, default, what="mean_ms"):
    of = lambda contender: sources.peer("updates", *case, motion, count, contender)
    if what == "worst_ms" or ours == default:
        return float(of(default)[what]) / float(of(ours)[what])
    return float(of(default)["mean_ms"]) / float(of(ours)["mean_ms"])


def in_cases(versions):
    return [f"{dim}D, {density}: {version}" if i == 0 else version for dim, density in CASES for i, version in enumerate(versions)]


def updates(sources):
    rows = []
    for motion, label in MOTIONS.items():
        for count in (10_000, 1 << 17):
            cells = []
            for case in CASES:
                cells.append(ratio(faster(sources, case, motion, count, OURS, DEFAULT)))
                cells.append(ratio(faster(sources, case, motion, count, OURS_036, DEFAULT_036)))
            rows.append([label, f"{count:,}", *cells])
    return table(["bodies that move", "n", *in_cases(("0.27", "0.36"))], rows)


def updates_without_deferred(sources):
    rows = []
    for motion, label in MOTIONS.items():
        for count in (10_000, 1 << 17):
            cells = []
            for case in CASES:
                cells.append(ratio(faster(sources, case, motion, count, OURS_036, DEFAULT_036)))
                is_there = ("updates", *map(str, case), motion, str(count), REST_036) in sources.peers()
                cells.append(ratio(faster(sources, case, motion, count, OURS_036, REST_036)) if is_there else "–")
            rows.append([label, f"{count:,}", *cells])
    return table(["bodies that move", "n", *in_cases(("all", "without"))], rows)


def longest(sources):
    rows = []
    for motion, label in MOTIONS.items():
        for count in (100, 1_000, 10_000, 1 << 17):
            cells = []
            for case in CASES:
                for ours, default in ((OURS, DEFAULT), (OURS_036, DEFAULT_036)):
                    of = lambda name: float(sources.peer("updates", *case, motion, count, name)["worst_ms"])
                    cell = " / ".join(significant(of(name)) for name in (ours, default))
                    cells.append(f"**{cell}**" if of(ours) > of(default) else cell)
            frames = {sources.peer("updates", *case, motion, count, name)["frames"] for case in CASES for name in (OURS, OURS_036)}
            if len(frames) > 1:
                raise Missing(f"rows of {motion}, n = {count}, are of different numbers of updates")
            frames = frames.pop()
            rows.append([label, f"{count:,}", thousands(frames), *cells])
    return table(["bodies that move", "n", "updates", *in_cases(("0.27", "0.36"))], rows)


def kernels(sources):
    """Nanoseconds a box, of all that were measured at the last numbers of boxes."""
    counts = [1 << 17, 1 << 20]
    found = sources.peers()
    # 2^20 boxes are measured at the lower density only in 2D.
    columns = [(case, count) for case in CASES for count in counts if ("kernels", *map(str, case), "", str(count), "unisize GridSweep") in found]
    contenders = dict.fromkeys(key[5] for key in found if key[0] == "kernels")
    rows = []
    for contender in contenders:
        cells = []
        for case, count in columns:
            row = found.get(("kernels", *map(str, case), "", str(count), contender))
            cells.append(f"{float(row['typical_ms']) * 1e6 / count:.0f}, {float(row['ratio']):.1f}" if row else "–")
        rows.append([contender.replace("unisize ", ""), *cells])
    exponent = {1 << 17: 17, 1 << 20: 20}
    head = [f"{dim}D, {density}, 2<sup>{exponent[count]}</sup>" for (dim, density), count in columns]
    return table(["", *head], rows)


# The benches.


def floor(sources):
    tables = [sources.rows("phases", "GridSweep", f"{dim}D", "f32", f"density {density}") for dim, density in CASES]
    if len({tuple(line["n"] for line in lines) for lines in tables}) > 1:
        raise Missing("the tables of the floor are of different numbers of boxes")
    rows = [[thousands(lines[0]["n"]), *(line["times the floor"] for line in lines)] for lines in zip(*tables)]
    return table(["boxes", *(f"{dim}D, density {density}" for dim, density in CASES)], rows)


def memory(sources):
    found = {}
    for row in sources.rows("memory"):
        for name, column in ((row["Rapier"], "its own, bytes a collider"), (f"unisize for {row['Rapier'].split()[-1]}", "unisize"), ("aim", "aim")):
            found.setdefault(name, {}).setdefault(row["dimension"], []).append(int(row[column]))
    span = lambda values: f"{min(values)} to {max(values)}" if min(values) < max(values) else f"{min(values)}"
    names = sorted(name for name in found if name.startswith("unisize")) + sorted(name for name in found if name.startswith("Rapier")) + ["aim"]
    return table(["", "2D", "3D"], [[name, span(found[name]["2D"]), span(found[name]["3D"])] for name in names])


def scale(sources):
    cells = {(row["dimension"], row["bodies"]): row for row in sources.rows("scale")}
    names = ["kernel, ns a box", "update, ns a body", "bytes a body", "Rapier 0.27: update"]
    counts = dict.fromkeys(row["bodies"] for row in sources.rows("scale"))
    rows = [[thousands(count), *(thousands(cells[dim, count][name]) for dim in ("2D", "3D") for name in names)] for count in counts]
    head = [f"{dim}: {name}" if i == 0 else name for dim in ("2D", "3D") for i, name in enumerate(["kernel", "update", "bytes", "Rapier 0.27: update"])]
    return table(["bodies", *head], rows)


def hard_boxes(dim):
    def make(sources):
        titles = {"Parry Bvh": "Parry `Bvh`", "BruteForce": "brute force"}
        found = grouped(sources.rows("hard-boxes", f"{dim}D"), "boxes", "method")
        methods = list(next(iter(found.values())))
        rows = []
        for boxes, lines in found.items():
            cells = [f"{significant(float(line['ns for each box and pair']))}, {line['slope of time']}{fewer(line['n'], 1 << 18)}" for line in lines.values()]
            rows.append([boxes, *cells])
        return table(["boxes", *(titles.get(name, f"`{name}`") for name in methods)], rows)

    return make


def hard_motions(dim):
    def make(sources):
        found = grouped(sources.rows("hard-motions", f"{dim}D"), "motion", "broad phase")
        methods = dict.fromkeys(name for lines in found.values() for name in lines)
        rows = []
        for motion, lines in found.items():
            cells = []
            for name in methods:
                line = lines[name]
                times = [significant(float(line[f"{which} ms"])) for which in ("mean", "worst")]
                cells.append(f"{' / '.join(times)}, {line['slope of time']}{fewer(line['n'], 1 << 16)}")
            rows.append([motion, *cells])
        return table(["motion", *(name.replace("RankSweep", "`RankSweep`") for name in methods)], rows)

    return make


def grouped(rows, outer, inner):
    found = {}
    for row in rows:
        found.setdefault(row[outer], {})[row[inner]] = row
    return found


def fewer(cell, most):
    """Of a cell like `4096, stopped after 7`: the number if it is not the largest, and when it was stopped."""
    count, *stopped = cell.split(", ")
    notes = [] if int(count) == most else [f"n = {int(count):,}"]
    notes += stopped
    return f" ({', '.join(notes)})" if notes else ""


def queries(sources):
    rows = []
    for row in sources.rows("queries"):
        first = [row["µs of the first ray, mean of steps 1 to 100"], row["of the last 100"]]
        counts = [thousands(row["balls"]), thousands(row["of which move"])]
        rows.append([f"{row['dimension']}D", *counts, *first, row["further ray"], row["ratio"], row["default's ray"]])
    head = ["", "balls", "moving", "first ray, steps 1 to 100", "last 100", "further ray", "ratio", "default's ray"]
    return table(head, rows)


UNITS = {
    "compared": "a candidate compared, in order",
    "picked": "asked whether it has moved",
    "walked": "a list walked",
    "looked up": "a box looked up",
    "searched": "a box searched for in a run",
    "found": "a candidate found",
}


def prices(sources):
    taken = sources.prices_taken()
    rows = []
    for row in sources.rows_with("prices", "unit"):
        if row["unit"] in UNITS:
            fitted = [significant(float(row[f"ns in {dim}D"])) for dim in (2, 3)]
            rows.append([UNITS[row["unit"]], *fitted, f"{taken[row['unit']]:g}" if row["unit"] in taken else "–"])
    return table(["unit", "2D", "3D", "taken"], rows)


def foresight(sources):
    found = {}
    for row in sources.rows_with("prices", "over best"):
        fixed = [float(cell) for moves, cell in row.items() if moves.isdigit()]
        found.setdefault(row["scene"], {})[row[""]] = [f"{float(row['by speed']):.2f}", f"{max(fixed):.2f}"]
    rows = [[scene, *cells["2D"], *cells["3D"]] for scene, cells in found.items()]
    return table(["scene", "2D", "best fixed", "3D", "best fixed"], rows)


TABLES = {
    "whole-steps-0-36": whole_steps("0-36"),
    "whole-steps-0-27": whole_steps("0-27"),
    "both-parallel": both_parallel,
    "broad-phase": broad_phase,
    "beyond-free": beyond_free,
    "filter": filter_,
    "filter-levels": filter_levels,
    "aims-0-36": aims_036,
    "share": share,
    "updates": updates,
    "updates-without-deferred": updates_without_deferred,
    "longest-updates": longest,
    "peers-kernels": kernels,
    "floor": floor,
    "memory": memory,
    "queries": queries,
    "prices": prices,
    "foresight": foresight,
    "scale": scale,
    "hard-boxes-2d": hard_boxes(2),
    "hard-boxes-3d": hard_boxes(3),
    "hard-motions-2d": hard_motions(2),
    "hard-motions-3d": hard_motions(3),
}


def make(name, sources):
    """A table by its name, or one that a stored file has as it is: `copied FILE: HEADING`."""
    if name.startswith("copied "):
        file, _, heading = name.removeprefix("copied ").partition(": ")
        return sources.table(file, heading)
    if name not in TABLES:
        raise Missing(f"there is no maker of this name in .ci/table_makers.py")
    return TABLES[name](sources)
