#!/usr/bin/env bash
# Claims about the pages of tools/report, checked in the page that a browser makes of them.
# usage: report_test.sh MORTISE   (the program; installs what tools/packages_long.txt lists)
set -euo pipefail
mortise=$(realpath -- "$1")
# shellcheck source=tests/tools/claims.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/claims.sh"
install_packages "$root/tools/packages_long.txt"

holds() { grep -qF -- "$2" "$1"; }
lacks() { ! grep -qE -- "$2" "$1"; }
run() { # CODE DECK OUT
  local code=0
  "$mortise" run "$2" -o "$3" --quiet >run.out 2>&1 || code=$?
  [ "$code" -eq "$1" ] || { cat run.out; fail "$2 left with exit code $code instead of $1"; }
}
# What the browser makes of a page: DIR.dom, its complaints in DIR.err.
browse() {
  timeout 120 chromium --headless --no-sandbox --disable-gpu --user-data-dir="$scratch/browser" --enable-logging=stderr --v=0 \
    --dump-dom "file://$scratch/$1/report.html" >"$1.dom" 2>"$1.err" || { cat "$1.err"; fail "the browser cannot show $1"; }
}
report() {
  "$root/tools/report" "$1" --no-pictures >/dev/null
  browse "$1"
  claim "$1: no console message" lacks "$1.err" 'CONSOLE'
  claim "$1: nothing loaded from a network" lacks <(sed 's/xmlns[:a-z]*="[^"]*"//g' "$1/report.html") 'https?://|@import'
  claim "$1: no reference to another file" lacks "$1.dom" '(src|href)="[^d#]'
  claim "$1: every id is given once" test -z "$(grep -oE ' id="[^"]*"' "$1.dom" | sort | uniq -d)"
}
figures() { grep -o '<svg ' "$1" | wc -l; }

# The runs: done; one that fails with exit code 4 after a good step; a title that is not HTML; killed, so without summary.
deck="$root/inputs/patch_test/contact.xml"
sed -e '/<ParameterList name="expected">/,$d' -e 's/-1e4\*t/-1e4*t - 1e12*max(t-0.5,0)/' \
  -e 's|name="step"   type="double" value="0.5"/>|&<Parameter name="smallest step" type="double" value="0.2"/>|' "$deck" >fails.xml
say '</ParameterList>' >>fails.xml
sed -e 's/name="title" type="string" value="[^"]*"/name="title" type="string" value="\&lt;b\&gt;\&amp;ü"/' \
  -e 's/upper on lower/a \&lt;i\&gt; \&amp; $b$ ü/' -e 's/value="36000000"/value="36000100"/' "$deck" >title.xml
run 0 "$deck" "done"
run 4 fails.xml fails
run 7 title.xml title
cp -r "done" killed
rm killed/summary.json
head -c -20 done/history.csv >killed/history.csv
cp -r "done" one_row
rm one_row/summary.json
head -n 2 done/history.csv >one_row/history.csv

report done
claim "done: outcome" holds done.dom '<strong>done (exit code 0)</strong> · 2 steps to t = 1, 0 cuts, 6 Newton iterations'
claim "done: three expected values are met" test "$(grep -c '<td class="met">met' done.dom)" -eq 3
claim "done: a figure per group that is not zero" test "$(figures done.dom)" -eq 11
claim "done: zero groups are named" holds done.dom 'linear momentum; angular momentum'
claim "done: no log" lacks done.dom 'End of the log'
cp done/report.html first.html
"$root/tools/report" done --no-pictures >/dev/null
claim "done: the same page again, to the byte" cmp first.html done/report.html

report fails
claim "fails: outcome" holds fails.dom 'no step converged at the smallest dt (exit code 4)'
claim "fails: cause from the summary" holds fails.dom '<p>step 2, t = 0.75, dt = 0.25: no step converged'
claim "fails: end of the log" holds fails.dom 'next:  nothing, the smallest step is reached'

report title
claim "title: escaped" holds title.dom '<h1>&lt;b&gt;&amp;ü</h1>'
claim "title: name of a pair escaped" holds title.dom 'Contact force: a &lt;i&gt; &amp; $b$ ü'
claim "title: outcome" holds title.dom 'an expected value is missed (exit code 7)'
claim "title: missed" holds title.dom '<td class="missed">MISSED'

report killed
claim "killed: outcome" holds killed.dom 'interrupted: there is no summary.json</strong> · 1 step to t = 0.5'
claim "killed: the broken line" holds killed.dom 'The last line of history.csv is unfinished'
report one_row
claim "one row: outcome" holds one_row.dom 'no step accepted'
claim "one row: figures" test "$(figures one_row.dom)" -ge 3

claim "usage" exit_code 1 --unknown "$root/tools/report" done --unknown
claim "no folder" exit_code 5 nowhere "$root/tools/report" nowhere
mkdir empty
claim "not a run" exit_code 5 empty "$root/tools/report" empty
sed -i '3s/0.5/half/' killed/history.csv
claim "history that is no table" exit_code 5 'killed/history.csv: line 3: ' "$root/tools/report" killed
claim "page that cannot be written" exit_code 5 nowhere "$root/tools/report" done --no-pictures -o nowhere/page.html

all_claims_hold
