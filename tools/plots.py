"""Reads the history.csv of a run and draws it, one figure per group of columns, as SVG that repeats to the byte."""

import csv
import io
import math
import re
from dataclasses import dataclass, field
from xml.etree import ElementTree

import matplotlib
import matplotlib.ticker
import numpy
from matplotlib.figure import Figure

# Okabe and Ito's colours, told apart by most colour-blind readers; the second list is the same hues for a dark page.
COLOURS = ["#0072b2", "#d55e00", "#009e73", "#b8499a", "#a67c00", "#3a9bd9", "#7a4fbf", "#6b7280"]
DARK_COLOURS = ["#5ab0ea", "#ff8a4c", "#3fd0a0", "#ee8fd0", "#e3bd4a", "#8fd0ff", "#b79cf2", "#a9b1bd"]
AXIS, GRID = "#333333", "#dddddd"
SIZE = (4.9, 3.0)  # inches; a page shows two side by side
FEW_ROWS = 40      # up to here every row gets a marker

# Below this part of the largest value of its kind (forces, energies), a column is round-off and left out.
ROUND_OFF = 1e-12

SVG = "http://www.w3.org/2000/svg"
STYLE = {
    "svg.fonttype": "none", "font.family": "DejaVu Sans", "font.size": 9, "axes.formatter.useoffset": False,
    "axes.spines.top": False, "axes.spines.right": False, "axes.edgecolor": AXIS, "axes.labelcolor": AXIS, "axes.linewidth": 0.8,
    "text.color": AXIS, "text.parse_math": False, "xtick.color": AXIS, "ytick.color": AXIS, "axes.grid": True, "axes.axisbelow": True,
    "grid.color": GRID, "grid.linewidth": 0.6, "lines.linewidth": 1.5, "lines.markersize": 3.5,
    "legend.frameon": False, "legend.fontsize": 9,
}


class HistoryError(Exception):
    """history.csv cannot be read; the text says where and why."""


@dataclass
class Series:
    """One line of a plot."""
    label: str
    values: numpy.ndarray
    style: str = "-"


@dataclass
class Plot:
    """One figure: lines over time, or bars where `bars` is set."""
    title: str
    x: numpy.ndarray
    series: list
    y_label: str = ""
    note: str = ""
    log: bool = False
    steps: bool = False               # a value holds for the whole step before its row
    from_zero: bool = False           # the axis begins at 0
    whole: bool = False               # whole numbers
    bars: dict = field(default_factory=dict)


def read_history(file):
    """Columns by name, as arrays with one value per accepted step; and whether an unfinished last row was left out.

    Raises HistoryError for a file without header or with a row that is not numbers, OSError for one that cannot be opened.
    """
    try:
        with open(file, encoding="utf-8", newline="") as stream:
            text = stream.read()
    except UnicodeDecodeError as error:
        raise HistoryError(f"not a text file (byte {error.start})") from None
    lines = list(csv.reader(io.StringIO(text)))
    if not lines or lines[0][:2] != ["step", "time"]:
        raise HistoryError("line 1: not the header of a history (step, time, ...)")
    # A run that was killed while writing leaves a last line without an end.
    unfinished = len(lines) > 1 and not text.endswith("\n")
    rows = []
    for number, words in enumerate(lines[1:-1] if unfinished else lines[1:], start=2):
        if len(words) != len(lines[0]):
            raise HistoryError(f"line {number}: {len(words)} values under {len(lines[0])} names")
        try:
            rows.append([float(word) for word in words])
        except ValueError as error:
            raise HistoryError(f"line {number}: {error}") from None
    table = numpy.array(rows, dtype=float).reshape(len(rows), len(lines[0]))
    return {name: table[:, i] for i, name in enumerate(lines[0])}, unfinished


def largest(arrays):
    """The largest magnitude among finite values; 0 where there are none."""
    return max((float(numpy.abs(a[numpy.isfinite(a)]).max(initial=0)) for a in arrays), default=0.0)


def columns_of(history, prefix):
    """{owner: {component: column}} for names such as reaction_x.owner, in the order of the file; a scalar's component is ''."""
    found = {}
    for name, values in history.items():
        match = re.fullmatch(re.escape(prefix) + r"(?:_([xyz]))?(?:\.(.*))?", name, re.DOTALL)
        if match:
            found.setdefault(match[2] or "", {})[match[1] or ""] = values
    return found


def vector_plots(history, prefix, what, note, left_out):
    """A plot of three components per contact pair or support; those that are nothing but round-off are named in left_out."""
    groups = columns_of(history, prefix)
    scale = largest(column for _, group in all_forces(history) for column in group.values())
    for owner, components in groups.items():
        title = f"{what}: {owner}"
        if largest(components.values()) <= ROUND_OFF * scale:
            left_out.append(title)
        else:
            yield Plot(title, history["time"], [Series(c, v) for c, v in components.items()], "force", note)


def all_forces(history):
    return [*columns_of(history, "contact_force").items(), *columns_of(history, "reaction").items()]


ENERGIES = ["kinetic_energy", "strain_energy", "stick_energy", "total_energy"]
WORKS = ["external_work", "contact_work", "contact_work_closing", "contact_work_resegmentation", "friction_dissipation",
         "damping_dissipation", "algorithmic_dissipation", "residual_work"]


def in_words(name):
    return name.replace("_", " ")


def ledger_plots(history, left_out):
    """Energies, works since the start, and the mismatch of the ledger."""
    scale = largest(history[n] for n in ENERGIES + WORKS if n in history)
    for title, names, note in [("Energies", ENERGIES, "Of the state at each step."),
                               ("Works and dissipations", WORKS, "Sums since the start.")]:
        there = [n for n in names if n in history]
        shown = [n for n in there if largest([history[n]]) > ROUND_OFF * scale]
        left_out += [in_words(n) for n in there if n not in shown]
        if shown:
            lines = [Series(in_words(n), history[n], "--" if n == "total_energy" else "-") for n in shown]
            yield Plot(title, history["time"], lines, "energy", note)
    if "ledger_mismatch" in history:
        yield from magnitude_plot(history, "Mismatch of the ledger", {"|mismatch|": history["ledger_mismatch"]}, "energy", left_out,
                                  f"What the bookkeeping of a step misses; the largest energy or work of the run is {scale:.3g}.")


def magnitude_plot(history, title, columns, y_label, left_out, note):
    """Magnitudes on a logarithmic axis, where zero has no place and leaves a hole."""
    if largest(columns.values()) == 0:
        left_out.append(title)
        return
    series = [Series(label, numpy.where(v == 0, numpy.nan, numpy.abs(v))) for label, v in columns.items()]
    yield Plot(title, history["time"], series, y_label, note, log=True)


def momentum_plots(history, left_out):
    for prefix in ["linear_momentum", "angular_momentum"]:
        for components in columns_of(history, prefix).values():
            if largest(components.values()) == 0:
                left_out.append(in_words(prefix))
            else:
                yield Plot(in_words(prefix).capitalize(), history["time"], [Series(c, v) for c, v in components.items()])
    missed = {in_words(n).split()[0]: history[n] for n in ("linear_momentum_mismatch", "angular_momentum_mismatch") if n in history}
    if missed:
        yield from magnitude_plot(history, "Mismatch of the momenta", missed, "momentum", left_out,
                                  "What they are away from those at the start and the impulses since.")


def course_plots(history, left_out):
    """What the solver did: active nodes, Newton iterations and cuts, step size. The initial state is no step."""
    status = [n for n in ["active", "stick", "slip"] if n in history and largest([history[n]]) > 0]
    if status:
        yield Plot("Nodes in contact", history["time"], [Series(n, history[n]) for n in status], "nodes", from_zero=True, whole=True)
    else:
        left_out.append("nodes in contact")
    if len(history["step"]) < 2:
        return
    effort = {in_words(n): of_steps(history, n) for n in ["newton_iterations", "cuts"] if n in history}
    shown = {name: v for name, v in effort.items() if largest([v]) > 0}
    if shown:
        note = "" if "cuts" in shown else "No accepted step needed a cut."
        yield Plot("Newton iterations and cuts", history["time"], [Series(n, v) for n, v in shown.items()], "per accepted step", note,
                   steps=True, from_zero=True, whole=True)
    if "dt" in history:
        dt = of_steps(history, "dt")
        log = bool(dt.min() > 0 and dt.max() > 20 * dt.min())
        yield Plot("Step size", history["time"], [Series("dt", dt)], "dt", log=log, steps=True, from_zero=not log)


def of_steps(history, name):
    """A column about steps; the initial state, which is none, gets the value of the first step so that its line begins there."""
    values = history[name].copy()
    values[0] = values[1]
    return values


SHOWN_ELSEWHERE = re.compile(
    r"step|time|dt|newton_iterations|cuts|active|stick|slip|contact_force_[xyz]\..*|reaction_[xyz]\..*|linear_momentum_[xyz]|"
    r"angular_momentum_[xyz]|linear_momentum_mismatch|angular_momentum_mismatch|ledger_mismatch|closure_error\..*|seconds_.*|graph_rebuilds|" + "|".join(ENERGIES + WORKS), re.DOTALL)


def probe_plots(history, left_out):
    """Probes, one plot per quantity; and any column that is not known here, so that nothing in the file goes unseen."""
    groups = {}
    for name, values in history.items():
        if not SHOWN_ELSEWHERE.fullmatch(name):
            quantity, _, probe = name.partition(".")
            base, component = re.fullmatch(r"(.*?)(?:_([xyz]))?", quantity, re.DOTALL).groups()
            groups.setdefault(base, {})[" ".join(w for w in [probe, component] if w) or in_words(base)] = values
    for base, columns in groups.items():
        shown = {label: v for label, v in columns.items() if largest([v]) > 0}
        left_out += [f"{in_words(base)}: {label}" for label in columns if label not in shown]
        if shown:
            yield Plot("Probes: " + in_words(base), history["time"], [Series(label, v) for label, v in shown.items()], in_words(base))


def plots_of_history(history):
    """All plots of a history, and the names of what was left out because it is zero throughout."""
    left_out = []
    if not len(history["time"]):
        return [], left_out
    closure = {owner: group[""] for owner, group in columns_of(history, "closure_error").items() if "" in group}
    plots = [
        *vector_plots(history, "contact_force", "Contact force", "On the secondary surface.", left_out),
        *vector_plots(history, "reaction", "Reaction", "", left_out),
        *probe_plots(history, left_out),
        *ledger_plots(history, left_out),
        *momentum_plots(history, left_out),
        *(magnitude_plot(history, "Closure error of the overlaps", closure, "", left_out,
                         "Largest of a facet: its area against that of its overlaps, relative.") if closure else []),
        *course_plots(history, left_out),
    ]
    return plots, left_out


def plot_of_seconds(seconds):
    """Bars of the seconds by stage, the largest on top. `seconds` as in summary.json; 'rest' is what the stages leave of the wall clock."""
    stages = {in_words(n): s for n, s in seconds.items() if n not in ("wall", "cpu_of_rank_0")}
    note = ""
    if "wall" in seconds:
        note = f"Of {seconds['wall']:.3g} s on the wall clock."
        rest = seconds["wall"] - sum(stages.values())
        if rest > 0:
            stages["rest"] = rest
    ordered = dict(sorted(stages.items(), key=lambda item: item[1]))
    return Plot("Seconds by stage", numpy.array([]), [], "seconds", note, bars=ordered)


def figure_of(plot):
    """Draws a plot. The legend stands above the axes, so that it covers no data; its rows make the figure taller."""
    with matplotlib.rc_context():
        matplotlib.rcdefaults()
        matplotlib.rcParams.update(STYLE)
        letters = max((len(s.label) for s in plot.series), default=0)
        across = max(1, min(len(plot.series), 64 // (letters + 5)))
        rows = math.ceil(len(plot.series) / across) if len(plot.series) > 1 else 0
        figure = Figure(figsize=(SIZE[0], SIZE[1] + 0.2 * max(0, rows - 1)), constrained_layout=True)
        figure.patch.set_visible(False)
        axes = figure.add_subplot()
        axes.patch.set_visible(False)
        if plot.bars:
            draw_bars(axes, plot)
        else:
            draw_lines(axes, plot)
        if rows:
            axes.legend(loc="lower left", bbox_to_anchor=(0, 1), borderaxespad=0.2, ncol=across, handlelength=1.8, columnspacing=1.2)
        return figure


def draw_bars(axes, plot):
    bars = axes.barh(list(plot.bars), list(plot.bars.values()), color=COLOURS[0], height=0.6)
    axes.bar_label(bars, fmt="%.3g", padding=3)
    axes.margins(x=0.12)
    axes.set_xlabel(plot.y_label)
    axes.grid(visible=False, axis="y")


def draw_lines(axes, plot):
    for i, series in enumerate(plot.series):
        round_again = i // len(COLOURS)  # with more lines than colours, dashes tell them apart
        axes.plot(plot.x, series.values, color=COLOURS[i % len(COLOURS)], label=series.label,
                  linestyle=["-", "--", ":", "-."][round_again % 4] if round_again else series.style,
                  marker="o" if len(plot.x) <= FEW_ROWS and not plot.steps else None,
                  drawstyle="steps-pre" if plot.steps else "default")
    axes.set_xlabel("time")
    axes.set_ylabel(plot.y_label)
    values = numpy.concatenate([s.values for s in plot.series])
    values = values[numpy.isfinite(values)]
    if plot.log and values.size:
        # Whole decades, so that the axis has at least two labels.
        axes.set_yscale("log")
        axes.set_ylim(10.0 ** math.floor(math.log10(values.min())), 10.0 ** (math.floor(math.log10(values.max())) + 1))
    elif plot.from_zero:
        axes.set_ylim(0, 1.08 * max(values.max(initial=0), 1e-300))
    if plot.whole:
        axes.yaxis.get_major_locator().set_params(integer=True)
    for axis in [axes.xaxis, axes.yaxis]:
        axis.set_major_formatter(tick_label)
    axes.yaxis.set_minor_formatter(matplotlib.ticker.NullFormatter())


def tick_label(value, _):
    """A number on an axis, by itself: 1e-15, 3.5e7, 0.25."""
    return re.sub(r"e([+-])0*(\d)", lambda match: "e" + match[1].strip("+") + match[2], f"{value:.6g}").replace("-", "\N{MINUS SIGN}")


def svg_of(plot, key):
    """The plot as an <svg> element to stand inside a page: ids begin with `key`, colours are variables of the page
    (--series-1 ..., --grid, and currentColor for axes and text), the letters are the page's."""
    figure = figure_of(plot)
    stream = io.StringIO()
    with matplotlib.rc_context({**STYLE, "svg.hashsalt": key}):
        figure.savefig(stream, format="svg", metadata={"Date": None, "Creator": None, "Format": None, "Type": None})
    root = ElementTree.fromstring(stream.getvalue())
    for parent in list(root.iter()):
        for child in list(parent):
            if child.tag == f"{{{SVG}}}metadata":
                parent.remove(child)
    for element in root.iter():
        for name, value in list(element.attrib.items()):
            plain = name.rpartition("}")[2]  # xlink:href is href today
            del element.attrib[name]
            element.attrib[plain] = page_attribute(plain, value, key)
    for size in ["width", "height"]:
        root.attrib.pop(size, None)
    root.attrib.update({"role": "img", "aria-label": alternative_text(plot)})
    ElementTree.register_namespace("", SVG)
    return ElementTree.tostring(root, encoding="unicode")


def page_attribute(name, value, key):
    if name == "id":
        return f"{key}-{value}"
    if name == "href" and value.startswith("#"):
        return f"#{key}-{value[1:]}"
    value = re.sub(r"url\(#(.*?)\)", rf"url(#{key}-\1)", value)
    if name == "style":
        value = re.sub(r"'DejaVu Sans'(, [^;]*)?", "inherit", re.sub(r"font: ([\d.]+px) [^;]*", r"font-size: \1", value))
        colours = {AXIS: "currentColor", GRID: "var(--grid)", **{c: f"var(--series-{i})" for i, c in enumerate(COLOURS, start=1)}}
        value = re.sub(r"#[0-9a-f]{6}", lambda match: colours.get(match[0], match[0]), value)
    return value


def alternative_text(plot):
    """What the figure shows, in words, for those who cannot see it."""
    if plot.bars:
        return plot.title + ": " + ", ".join(f"{name} {value:.3g}" for name, value in reversed(plot.bars.items()))
    parts = []
    for series in plot.series:
        values = series.values[numpy.isfinite(series.values)]
        if values.size:
            parts.append(f"{series.label} from {values.min():.4g} to {values.max():.4g}, at last {values[-1]:.4g}")
    return f"{plot.title} over time: " + "; ".join(parts)
