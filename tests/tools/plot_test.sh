#!/usr/bin/env bash
# Claims about tools/plot: every figure is drawn from runs and from files of theirs, and mistakes end with one line and a code.
# usage: plot_test.sh MORTISE   (the program)
set -euo pipefail
mortise=$(realpath -- "$1")
# shellcheck source=tests/tools/claims.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/claims.sh"

is_png() { [ "$(head -c 4 "$1" | tail -c 3)" = PNG ] && [ "$(stat -c %s "$1")" -gt 10000 ]; }
plot() { "$root/tools/plot" "$@" >/dev/null; }

# one second of the brick, in steps of three sizes
for dt in 0.05 0.025 0.0125; do
  sed -e "s/value=\"0.03125\"/value=\"$dt\"/; s/value=\"67.5\"/value=\"1\"/; /name=\"stops\"/d; /name=\"expected\"/,\$d" \
    "$root/inputs/spinning_bar/flipping_brick.xml" >"brick_$dt.xml"
  echo '</ParameterList>' >>"brick_$dt.xml"
  "$mortise" run "brick_$dt.xml" -o "brick_$dt" --quiet >/dev/null
done

for figure in energies total momenta ledger path; do
  plot "$figure" long=brick_0.05 brick_0.025/history.csv -o "$figure.png"
  claim "$figure: a picture" is_png "$figure.png"
done
plot error brick=brick_0.05 brick=brick_0.025 --reference brick_0.0125 -o error.png
claim "error: a picture" is_png error.png
claim "an unknown figure" exit_code 1 "invalid choice" "$root/tools/plot" enrgies brick_0.05 -o out.png
claim "no such run" exit_code 5 "nowhere" "$root/tools/plot" energies nowhere -o out.png
claim "no reference" exit_code 1 "--reference" "$root/tools/plot" error brick_0.05 -o out.png
claim "no such column" exit_code 5 "position_x.tip" "$root/tools/plot" path brick_0.05 --path position_x.tip,position_y.pole -o out.png
claim "no rows" exit_code 5 "no row" "$root/tools/plot" energies brick_0.05 --from 2 -o out.png
claim "an unknown kind of file" exit_code 5 "out.xyz" "$root/tools/plot" total brick_0.05 -o out.xyz

all_claims_hold
