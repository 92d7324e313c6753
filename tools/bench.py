"""Runs benchmarks and scenes, prints counts, seconds and ratios as one table, and compares with the baseline. Run by tools/bench."""

import argparse
import json
import pathlib
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
BUILD = ROOT / "build" / ("native" if "--native" in sys.argv else "release")
BASELINE = ROOT / "tests" / "benchmarks" / "baseline.json"

# The kernel that others are compared with; of a whole iteration or run the parts are shares.
ROUTES = ("quadrature point", "whole element", "complex step", "central differences", "forward differences", "backward differences")
REFERENCE = {"pair_tangent": "pair_values"}
for material in ("neo-hookean", "mooney-rivlin", "ogden"):
    REFERENCE[f"element_residual/{material}"] = f"element_tangent/{material}/analytic"
    for route in ROUTES:
        REFERENCE[f"element_tangent/{material}/{route}"] = f"element_tangent/{material}/analytic"
UNITS = {"s": 1, "ms": 1e-3, "us": 1e-6, "ns": 1e-9}
# What Google Benchmark itself writes about a repetition; every other number is a counter of ours.
OWN_KEYS = {"family_index", "per_family_instance_index", "repetitions", "repetition_index", "threads", "iterations", "real_time",
            "cpu_time"}


def arguments():
    parser = argparse.ArgumentParser(prog="tools/bench", description=__doc__)
    parser.add_argument("--save", action="store_true", help="put the rows measured into tests/benchmarks/baseline.json; other rows stay")
    parser.add_argument("--quick", action="store_true", help="one repetition, refinement 1 only")
    parser.add_argument("--all", action="store_true", help="the long scenes too")
    parser.add_argument("--native", action="store_true", help="the kernels alone, of the preset native")
    options = parser.parse_args()
    if options.save and options.native:
        parser.error("the baseline is of the preset release")
    return options


def run(command, **options):
    done = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, **options)
    if done.returncode != 0:
        sys.exit(f"bench: {' '.join(map(str, command))} ended with exit code {done.returncode}\n{done.stdout[-2000:]}")


def row(seconds, counts, reference=None):
    """One row of the table: median seconds, spread = (greatest - least) / median, counts, and the row it is compared with."""
    median = statistics.median(seconds)
    return {"seconds": median, "spread": (max(seconds) - min(seconds)) / median if median else 0.0, "counts": counts,
            "reference": reference}


def google_benchmark(program, repetitions, *options, launcher=()):
    """All repetitions of a program's benchmarks: name -> list of Google Benchmark's records. Ends with the first error."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "out.json"
        run([*launcher, BUILD / program, f"--benchmark_out={out}", "--benchmark_out_format=json", f"--benchmark_repetitions={repetitions}",
             *options])
        records = json.loads(out.read_text())["benchmarks"]
    found = {}
    for record in records:
        if record.get("error_occurred"):
            sys.exit(f"bench: {record['name']}: {record['error_message']}")
        if record["run_type"] == "iteration":
            name = "/".join(part for part in record["name"].split("/") if part not in ("real_time", "manual_time") and ":" not in part)
            found.setdefault(name, []).append(record)
    return found


def counters(records):
    """The counts of a benchmark, which every repetition must find again; seconds and ratios are no counts."""
    each = [{k: int(v) if v == int(v) else v for k, v in record.items()
             if k not in OWN_KEYS and isinstance(v, (int, float)) and not isinstance(v, bool) and not k.startswith(("seconds", "ratio"))}
            for record in records]
    if any(counts != each[0] for counts in each):
        sys.exit(f"bench: {records[0]['name']}: counts differ from repetition to repetition: {each}")
    return each[0]


def kernels(quick):
    rows = {}
    for name, records in google_benchmark("bench_kernels", 1 if quick else 9).items():
        reference = REFERENCE.get(name) or REFERENCE.get(name.split("/")[0])
        if reference == "pair_values":
            reference = "pair_values/5"
        rows[name] = row([r["cpu_time"] * UNITS[r["time_unit"]] for r in records], counters(records), reference)
    return rows


def assembly(quick):
    """Residual and tangent of 100,000 elements on one rank, then on two against one."""
    rows = {}
    for ranks in (1, 2):
        launcher = ("mpiexec", "--oversubscribe", "-n", str(ranks)) if ranks > 1 else ()
        for name, records in sorted(google_benchmark("bench_assembly", 1 if quick else 5, launcher=launcher).items()):
            rows[f"{name}/{ranks}"] = row([r["real_time"] * UNITS[r["time_unit"]] for r in records], counters(records), f"{name}/1")
    return rows


def newton(quick):
    """The whole Newton iteration with the shares of its stages, then each stage alone against the iteration."""
    rows = {}
    found = google_benchmark("bench_newton", 1 if quick else 3, *(["--benchmark_filter=/1(/|$)"] if quick else []))
    for name, records in sorted(found.items(), key=lambda item: item[0].split("/")[1]):
        what, refinement = name.split("/")
        whole = f"newton_iteration/{refinement}"
        if what != "newton_iteration":
            rows[name] = row([r["real_time"] * UNITS[r["time_unit"]] for r in records], counters(records), whole)
            continue
        rows[name] = row([r["seconds"] for r in records], counters(records))
        stages = [k[len("seconds_"):] for k in records[0] if k.startswith("seconds_")]
        for stage in stages:
            rows[f"{name} {stage}"] = row([r[f"seconds_{stage}"] for r in records], {}, whole)
        rest = [r["seconds"] - sum(r[f"seconds_{stage}"] for stage in stages) for r in records]
        rows[f"{name} rest"] = row(rest, {}, whole)
    return rows


def counts_of(summary):
    """As in tests/support/baseline.hpp."""
    work, direct, pairs = summary["counts"], summary["direct_solver"], summary["contact"].values()
    return {"steps": summary["steps"], "cuts": summary["cuts"], "newton_iterations": summary["newton_iterations"],
            "evaluations": work["residuals"], "tangents": work["tangents"], "graphs": work["graphs"],
            "analyses": direct["analyses"], "factor_entries": int(direct["factor_entries"]),
            **{name: sum(pair[name] for pair in pairs) for name in ("searches", "pairs", "overlaps")}}


def scenes(quick, also_long):
    """Decks run through the program: seconds as it reports them, stages as shares of the whole."""
    rows = {}
    listed = json.loads((ROOT / "tests" / "benchmarks" / "scenes.json").read_text())
    for name in listed["cheap"] + (listed["all"] if also_long else []):
        summaries = []
        for _ in range(1 if quick else 3):
            with tempfile.TemporaryDirectory() as folder:
                out = pathlib.Path(folder) / "out"
                run([BUILD / "mortise", "run", ROOT / "inputs" / f"{name}.xml", "--quiet", "-o", out])
                summaries.append(json.loads((out / "summary.json").read_text()))
        counts = counts_of(summaries[0])
        if any(counts_of(summary) != counts for summary in summaries):
            sys.exit(f"bench: {name}: counts differ from run to run")
        rows[name] = row([s["seconds"]["wall"] for s in summaries], counts)
        for stage in ("search", "contact", "elements", "assembly", "linear_solve"):
            rows[f"{name} {stage}"] = row([s["seconds"][stage] for s in summaries], {}, name)
    return rows


def in_words(seconds):
    for unit, scale in (("s", 1), ("ms", 1e-3), ("us", 1e-6)):
        if seconds >= scale:
            return f"{seconds / scale:.3g} {unit}"
    return f"{seconds / 1e-9:.3g} ns"


def print_table(title, rows, baseline):
    width = max(map(len, rows)) + 2
    print(f"\n{title:<{width}}{'median':>10}{'spread':>9}{'ratio':>9}  {'to baseline':<13}counts")
    for name, r in rows.items():
        reference, before = rows.get(r["reference"]), baseline.get(name)
        ratio = f"{r['seconds'] / reference['seconds']:.3f}" if reference else "1"
        change = f"{r['seconds'] / before['seconds']:.2f}" if before and before["seconds"] else "-"
        counts = []
        for count, value in r["counts"].items():
            changed = before is not None and before["counts"].get(count) != value
            counts.append(f"{count} {value}" + (f" (baseline: {before['counts'].get(count)})" if changed else ""))
        print(f"{name:<{width}}{in_words(r['seconds']):>10}{100 * r['spread']:>7.0f} %{ratio:>9}  {change:<13}{', '.join(counts)}")


def main():
    options = arguments()
    groups = {"kernels": kernels(options.quick)} if options.native else {
              "kernels": kernels(options.quick), "assembly": assembly(options.quick), "newton_iteration": newton(options.quick),
              "scenes": scenes(options.quick, options.all)}
    baseline = json.loads(BASELINE.read_text()) if BASELINE.exists() else {}
    print("median of the repetitions; spread = (greatest - least) / median; ratio: to the tangent by hand, to the pair by value,")
    print("to the assembly on one rank, to the Newton iteration of the same refinement, to the whole run")
    for title, rows in groups.items():
        print_table(title, rows, baseline.get(title, {}))
    if options.save:
        for title, rows in groups.items():
            baseline.setdefault(title, {}).update(
                {name: {"counts": r["counts"], "seconds": float(f"{r['seconds']:.3g}"), "spread": round(r["spread"], 3)}
                 for name, r in rows.items()})
        BASELINE.write_text(json.dumps(baseline, indent=1) + "\n")
        print(f"\nsaved as {BASELINE.relative_to(ROOT)}")


main()
