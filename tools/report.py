"""Writes one self-contained HTML page about a run from the files in its folder. Run by tools/report."""

import argparse
import base64
import fcntl
import json
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import jinja2
import netCDF4

import plots

USAGE, FILES = 1, 5  # exit codes, as those of mortise itself
LOG_LINES = 40
PICTURE_TRIES = 4
RUN_FILES = ["summary.json", "history.csv", "manifest.txt"]  # one of them makes a folder the folder of a run
OUTCOMES = {
    0: "done", 1: "wrong command line", 2: "error in the deck", 3: "error in a mesh", 4: "no step converged at the smallest dt",
    5: "input or output failed", 6: "resources ran out", 7: "an expected value is missed", 8: "a tangent disagrees",
    9: "the auditor rejects a step", 70: "internal error", 130: "stopped by SIGINT (Ctrl-C)", 143: "stopped by SIGTERM",
}


class Parser(argparse.ArgumentParser):
    def error(self, message):
        stop(USAGE, f"{message} (tools/report --help)")


def stop(code, message):
    print("tools/report: " + " ".join(message.split()), file=sys.stderr)
    sys.exit(code)


def arguments():
    parser = Parser(prog="tools/report", description=__doc__)
    parser.add_argument("folder", metavar="DIR", type=Path)
    parser.add_argument("-o", dest="page", metavar="PAGE.html", type=Path)
    parser.add_argument("--no-pictures", action="store_true")
    parser.add_argument("--picture-program", help=argparse.SUPPRESS)
    return parser.parse_args()


def text_of(file):
    """The text of a file, '' where there is none; a byte that is no UTF-8 shows as such."""
    return file.read_text(encoding="utf-8", errors="replace") if file.is_file() else ""


def read_summary(file):
    """summary.json, or None where the run left none."""
    if not file.is_file():
        return None
    try:
        summary = json.loads(text_of(file))
        summary["exit_code"], summary["steps"], summary["seconds"]  # what the page cannot do without
        return summary
    except (ValueError, TypeError, KeyError) as error:
        stop(FILES, f"{file}: not the summary of a run: {error!r}")


def read_frames(file):
    """Title and times of the frames of an Exodus file; ('', []) where it cannot be read, as after a crash."""
    try:
        with netCDF4.Dataset(file) as results:
            times = [float(t) for t in results["time_whole"][:].filled()]
            # A title cut at 80 bytes may end within a character.
            return str(getattr(results, "title", "")).strip("\0 \ufffd"), times
    except (OSError, IndexError, AttributeError):
        return "", []


def is_running(folder):
    """A run keeps its folder locked until it ends."""
    descriptor = os.open(folder, os.O_RDONLY)
    try:
        fcntl.flock(descriptor, fcntl.LOCK_SH | fcntl.LOCK_NB)
        return False
    except BlockingIOError:
        return True
    except OSError:  # a file system without locks
        return False
    finally:
        os.close(descriptor)


def outcome_of(summary, history, running):
    """How the run ended: (words, one of good, bad, stopped, figures of the run)."""
    if summary is None:
        steps = int(history["step"][-1]) if history and len(history["step"]) else 0
        figures = f"{counted(steps, 'step')} to t = {history['time'][-1]:g}" if steps else "no step accepted"
        return ("still running" if running else "interrupted: there is no summary.json"), "stopped", figures
    code = summary["exit_code"]
    kind = "good" if code == 0 else "stopped" if code in (130, 143) else "bad"
    figures = [counted(summary["steps"], "step") + (f" to t = {summary['end_time']:g}" if "end_time" in summary else "")]
    figures += [counted(summary[n], word) for n, word in [("cuts", "cut"), ("newton_iterations", "Newton iteration")] if n in summary]
    if "wall" in summary["seconds"]:
        figures.append(f"{summary['seconds']['wall']:.3g} s")
    return f"{OUTCOMES.get(code, 'unknown exit code')} (exit code {code})", kind, ", ".join(figures)


def counted(number, word):
    return f"{number} {word}" if number == 1 else f"{number} {word}s"


def expectations_of(summary):
    """Rows of the table of expected values, with the part of the tolerance that was used up."""
    rows = []
    for e in (summary or {}).get("expected", []):
        found = e.get("found")
        used = None
        if found is not None and e["tolerance"] > 0:
            # Forces are compared by magnitude (the sign depends on the side): take the nearer reading where the run says met.
            off = min(abs(found - e["expected"]), abs(abs(found) - abs(e["expected"])) if e["met"] else float("inf"))
            used = f"{100 * off / e['tolerance']:.3g} %"
        rows.append({**e, "used": used})
    return rows


def counts_of(summary):
    """[(name, value)] of all that the summary holds and the page shows nowhere else; nested names are joined."""
    shown = {"exit_code", "cause", "seconds", "expected"}

    def flat(prefix, value):
        if isinstance(value, dict):
            for name, inner in value.items():
                yield from flat([*prefix, name], inner)
        elif isinstance(value, list):
            yield " › ".join(prefix), ", ".join(map(str, value))
        else:
            yield " › ".join(prefix), f"{value:.6g}" if isinstance(value, float) else value

    return [(name.replace("_", " "), value) for key, inner in (summary or {}).items() if key not in shown for name, value in flat([key], inner)]


def seconds_of(summary, history):
    """Seconds by stage; those of the history's last row where the run left no summary."""
    if summary is not None:
        return summary["seconds"]
    if history and len(history["step"]):
        return {n.removeprefix("seconds_"): float(v[-1]) for n, v in history.items() if n.startswith("seconds_")}
    return {}


def colour_range(results, times, chosen):
    """Option that gives all pictures the same colours: from 0 to the greatest von Mises stress of the chosen frames. [] without one."""
    try:
        with netCDF4.Dataset(results) as data:
            names = [str(name).strip() for name in netCDF4.chartostring(data["name_nod_var"][:])]
            stress = data[f"vals_nod_var{names.index('von_mises') + 1}"]
            greatest = max(float(stress[times.index(time)].max()) for time in chosen)
    except (OSError, IndexError, ValueError):
        return []
    return ["--range", f"0,{greatest!r}"] if greatest > 0 else []


def make_picture(program, results, time, colours, file):
    """Why there is no picture, '' where there is one. Tried again, as a virtual display that starts while another ends may fail."""
    failure = ""
    for _ in range(PICTURE_TRIES):
        file.unlink(missing_ok=True)
        try:
            done = subprocess.run([program, str(results), "-o", str(file), "--time", repr(time), *colours], stdin=subprocess.DEVNULL,
                                  capture_output=True, text=True, errors="replace", timeout=300)
        except (OSError, subprocess.TimeoutExpired) as error:
            return str(error)
        if done.returncode == 0 and file.is_file():
            return ""
        failure = " ".join(done.stderr.strip().splitlines()[-1:])
    return failure or f"exit code {done.returncode}"


def pictures_of(program, results, times):
    """PNG data of the first, middle and last frame, with their times; and the reason where there is none."""
    chosen = sorted({times[0], times[len(times) // 2], times[-1]})
    found = []
    colours = colour_range(results, times, chosen)
    with tempfile.TemporaryDirectory() as scratch:
        for time in chosen:
            file = Path(scratch, "frame.png")
            failure = make_picture(program, results, time, colours, file)
            if failure:
                return found, f"tools/picture failed at t = {time:g}: {failure}"
            found.append((time, base64.b64encode(file.read_bytes()).decode("ascii")))
    return found, ""


def deck_of(manifest):
    match = re.search(r"^deck (.+)$", manifest, re.MULTILINE)
    return match[1] if match else ""


def main():
    options = arguments()
    folder = options.folder
    if not folder.is_dir():
        stop(FILES, f"{folder}: no such folder")
    if not any((folder / name).is_file() for name in RUN_FILES):
        stop(FILES, f"{folder}: not the folder of a run: none of {', '.join(RUN_FILES)} is there")
    history, unfinished, history_file = None, False, folder / "history.csv"
    try:
        if history_file.is_file():
            history, unfinished = plots.read_history(history_file)
    except plots.HistoryError as error:
        stop(FILES, f"{history_file}: {error}")
    summary = read_summary(folder / "summary.json")
    manifest = text_of(folder / "manifest.txt")
    title, times = read_frames(folder / "results.e")
    deck = deck_of(manifest)

    outcome, kind, figures = outcome_of(summary, history, is_running(folder))
    drawn, left_out = plots.plots_of_history(history) if history else ([], [])
    if seconds := seconds_of(summary, history):
        drawn.append(plots.plot_of_seconds(seconds))

    pictures, no_pictures = [], "results.e has no frames that can be read."
    if times and options.no_pictures:
        no_pictures = "None were asked for (--no-pictures)."
    elif times and not options.picture_program:
        no_pictures = "ParaView is not installed; the first call of tools/picture installs it, and the next report has pictures."
    elif times:
        pictures, no_pictures = pictures_of(options.picture_program, folder / "results.e", times)
        if no_pictures:
            print("tools/report: " + no_pictures, file=sys.stderr)

    shows_log = summary is None or summary["exit_code"] not in (0, 7)
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(Path(__file__).parent), autoescape=True, trim_blocks=True,
                                     lstrip_blocks=True, undefined=jinja2.StrictUndefined)
    page = environment.get_template("report.html.j2").render(
        title=title or Path(deck).stem or folder.resolve().name, deck=deck, outcome=outcome, kind=kind, figures=figures,
        cause=(summary or {}).get("cause", ""), expectations=expectations_of(summary),
        plots=[(p, jinja2.utils.markupsafe.Markup(plots.svg_of(p, f"plot-{i}"))) for i, p in enumerate(drawn, start=1)],
        left_out=left_out, unfinished=unfinished, has_history=history is not None, counts=counts_of(summary), manifest=manifest,
        pictures=pictures, no_pictures=no_pictures, results=folder / "results.e",
        log=text_of(folder / "run.log").splitlines()[-LOG_LINES:] if shows_log else [],
        colours=plots.COLOURS, dark_colours=plots.DARK_COLOURS)
    file = options.page or folder / "report.html"
    file.write_text(page, encoding="utf-8")
    print(file)


if __name__ == "__main__":
    try:
        main()
    except OSError as failure:
        stop(FILES, f"{failure.filename or ''}: {failure.strerror or failure}")
