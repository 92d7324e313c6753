"""Draws the histories of one or several runs beside each other. Run by tools/plot.

  energies  kinetic, strain and total energy, and the total less the work of loads where there is any, one panel per run
  total     total energy of all runs in one panel
  momenta   linear and angular momentum, one panel per run
  ledger    magnitudes of what the books of energy and momenta miss, relative to the greatest energy and momenta (of a body
            without momentum that is round-off by round-off)
  path      where a probe goes, and the energies beside it, one row per run
  error     distance of the probed positions at the end from those of a reference, relative, over the step size; runs of the
            same label make a line
"""

import argparse
import math
import sys
from pathlib import Path

import matplotlib
import numpy
from matplotlib.figure import Figure

import plots
from plots import COLOURS, Plot, Series

USAGE, FILES = 1, 5  # exit codes, as those of mortise itself
PANEL, MOST_ACROSS = (3.6, 2.5), 3  # size in inches, panels side by side
SMALLEST = 1e-20  # a magnitude of zero is drawn nowhere


class Parser(argparse.ArgumentParser):
    def error(self, message):
        stop(USAGE, f"{message} (tools/plot --help)")


def stop(code, message):
    print("tools/plot: " + " ".join(message.split()), file=sys.stderr)
    sys.exit(code)


class Run:
    """A history with its label; rows between two times only."""

    def __init__(self, word, begin, end):
        label, _, path = word.rpartition("=")
        file = Path(path) / "history.csv" if Path(path).is_dir() else Path(path)
        self.label = label or (file.parent.name if file.name == "history.csv" else file.stem)
        self.file = file
        try:
            history, _ = plots.read_history(file)
        except (OSError, plots.HistoryError) as error:
            stop(FILES, f"{file}: {error.strerror if isinstance(error, OSError) else error}")
        shown = (history["time"] >= begin) & (history["time"] <= end)
        if not shown.any():
            stop(FILES, f"{file}: no row between the times {begin:g} and {end:g}")
        self.columns = {name: values[shown] for name, values in history.items()}

    def __getitem__(self, name):
        if name not in self.columns:
            stop(FILES, f"{self.file}: no column {name}")
        return self.columns[name]


def energies(run):
    series = [Series("kinetic", run["kinetic_energy"]), Series("strain", run["strain_energy"]), Series("total", run["total_energy"])]
    if plots.largest([run["external_work"]]) > plots.ROUND_OFF * plots.largest([run["total_energy"]]):
        series.append(Series("total less work of loads", run["total_energy"] - run["external_work"], "--"))
    return Plot(run.label, run["time"], series, "energy")


def momenta(run):
    series = [Series(f"{kind} {axis}", run[f"{kind}_momentum_{axis}"], style)
              for kind, style in (("linear", "--"), ("angular", "-")) for axis in "xyz"]
    return Plot(run.label, run["time"], series, "momentum")


def length(run, vector):
    return numpy.sqrt(sum(run[f"{vector}_{axis}"] ** 2 for axis in "xyz"))


def ledger(run):
    energy = plots.largest([run["total_energy"], run["external_work"]])
    magnitudes = {"ledger mismatch": (run["ledger_mismatch"], energy), "algorithmic dissipation": (run["algorithmic_dissipation"], energy),
                  "linear momentum": (run["linear_momentum_mismatch"], plots.largest([length(run, "linear_momentum")])),
                  "angular momentum": (run["angular_momentum_mismatch"], plots.largest([length(run, "angular_momentum")]))}
    series = [Series(name, numpy.where(numpy.abs(v) <= SMALLEST * scale, numpy.nan, numpy.abs(v) / max(scale, 1e-300)))
              for name, (v, scale) in magnitudes.items()]
    return Plot(run.label, run["time"], series, "relative", log=True)


def draw_panels(runs, panel_of, file):
    """One panel per run, with one legend for all; panels of a logarithmic axis share it."""
    panels = [panel_of(run) for run in runs]
    across = min(len(panels), MOST_ACROSS if len(panels) != 4 else 2)
    down = math.ceil(len(panels) / across)
    figure = Figure(figsize=(PANEL[0] * across, PANEL[1] * down + 0.5), dpi=150)
    grid = figure.subplots(down, across, squeeze=False)
    for axes, panel in zip(grid.flat, panels):
        plots.draw_lines(axes, panel)
        axes.set_title(panel.title, fontsize=9, loc="left")
    for axes in list(grid.flat)[len(panels):]:
        axes.set_visible(False)
    if panels[0].log:
        shown = list(grid.flat)[:len(panels)]
        limits = [axes.get_ylim() for axes in shown]
        for axes in shown:
            axes.set_ylim(min(low for low, _ in limits), max(high for _, high in limits))
    legend, columns = fullest_legend(grid.flat), min(6, 2 * across)
    rows = math.ceil(len(legend[1]) / columns)
    figure.legend(*legend, loc="upper center", ncol=columns)
    figure.tight_layout(rect=(0, 0, 1, 1 - (0.1 + 0.2 * rows) / figure.get_figheight()))
    save(figure, file)


def fullest_legend(panels):
    return max((axes.get_legend_handles_labels() for axes in panels), key=lambda legend: len(legend[1]))


def draw_total(runs, file):
    figure = Figure(figsize=(6.4, 4.0), dpi=150, layout="constrained")
    axes = figure.add_subplot()
    for k, run in enumerate(runs):
        style = ["-", "--", ":", "-."][k // len(COLOURS) % 4]
        axes.plot(run["time"], run["total_energy"], style, color=COLOURS[k % len(COLOURS)], label=run.label)
    axes.set_xlabel("time")
    axes.set_ylabel("total energy")
    legend_above(axes)
    save(figure, file)


def legend_above(axes):
    labels = axes.get_legend_handles_labels()[1]
    axes.legend(loc="lower left", bbox_to_anchor=(0, 1), borderaxespad=0.2, ncol=3 if max(map(len, labels)) < 20 else 2)


def position_columns(run):
    return [name for name in run.columns if name.startswith(("position_", "displacement_"))]


def draw_paths(runs, columns, file):
    figure = Figure(figsize=(2 * PANEL[0], PANEL[1] * len(runs) + 0.5), dpi=150)
    grid = figure.subplots(len(runs), 2, squeeze=False)
    for (left, right), run in zip(grid, runs):
        names = columns.split(",") if columns else position_columns(run)[:2]
        if len(names) != 2:
            stop(USAGE, f"{run.file}: a path needs two columns of positions; --path COLUMN,COLUMN names them")
        left.plot(run[names[0]], run[names[1]], color=COLOURS[0], marker="o" if len(run["time"]) <= plots.FEW_ROWS else None)
        left.set_xlabel(plots.in_words(names[0]))
        left.set_ylabel(plots.in_words(names[1]))
        if names[0] != "time":
            left.set_aspect("equal", adjustable="datalim")
        left.set_title(run.label, fontsize=9, loc="left")
        plots.draw_lines(right, energies(run))
    figure.legend(*fullest_legend(grid[:, 1]), loc="upper right", ncol=4)
    figure.tight_layout(rect=(0, 0, 1, 1 - 0.3 / figure.get_figheight()))
    save(figure, file)


def draw_errors(runs, reference, file):
    if reference is None:
        stop(USAGE, "error needs --reference RUN")
    exact = {name: reference[name][-1] for name in position_columns(reference)}
    if not exact:
        stop(FILES, f"{reference.file}: no probes of positions")
    lines = {}
    for run in runs:
        if not math.isclose(run["time"][-1], reference["time"][-1], rel_tol=1e-9):
            stop(FILES, f"{run.file}: ends at {run['time'][-1]:g}, the reference at {reference['time'][-1]:g}")
        off = math.hypot(*(run[name][-1] - value for name, value in exact.items())) / math.hypot(*exact.values())
        lines.setdefault(run.label, []).append((run["dt"][-1], off))
    with_powers = {"text.parse_math": True}
    with matplotlib.rc_context(with_powers):
        figure = Figure(figsize=(6.4, 4.2), dpi=150, layout="constrained")
        axes = figure.add_subplot()
        for k, (label, points) in enumerate(lines.items()):
            axes.loglog(*zip(*sorted(points)), color=COLOURS[k % len(COLOURS)], marker="o", label=label,
                        linestyle=["-", "--", ":", "-."][k // len(COLOURS) % 4])
        axes.set_xlabel("step size")
        axes.set_ylabel("relative error of the positions at the end")
        legend_above(axes)
        save(figure, file)


def save(figure, file):
    try:
        figure.savefig(file, metadata={"Software": None} if file.suffix == ".png" else None)
    except (OSError, ValueError) as error:
        stop(FILES, f"{file}: {error}")
    print(file)


def main():
    parser = Parser(prog="tools/plot", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("figure", metavar="FIGURE", choices=["energies", "total", "momenta", "ledger", "path", "error"])
    parser.add_argument("runs", metavar="[LABEL=]RUN", nargs="+", help="the folder of a run or its history.csv")
    parser.add_argument("-o", dest="file", metavar="OUT.png", type=Path, required=True)
    parser.add_argument("--from", dest="begin", metavar="T", type=float, default=-math.inf)
    parser.add_argument("--to", dest="end", metavar="T", type=float, default=math.inf)
    parser.add_argument("--path", dest="columns", metavar="COLUMN,COLUMN", help="of the figure `path`; default: the first two of positions")
    parser.add_argument("--reference", metavar="RUN", help="of the figure `error`")
    options = parser.parse_args()
    with matplotlib.rc_context(plots.STYLE):
        runs = [Run(word, options.begin, options.end) for word in options.runs]
        panels = {"energies": energies, "momenta": momenta, "ledger": ledger}
        if options.figure in panels:
            draw_panels(runs, panels[options.figure], options.file)
        elif options.figure == "total":
            draw_total(runs, options.file)
        elif options.figure == "path":
            draw_paths(runs, options.columns, options.file)
        else:
            reference = Run(options.reference, options.begin, options.end) if options.reference else None
            draw_errors(runs, reference, options.file)


if __name__ == "__main__":
    main()
