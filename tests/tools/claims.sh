# What the tests of tools begin with: a scratch folder to work in, and claims that are counted. Sourced, not run.
# shellcheck source=tools/common.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/../../tools/common.sh"
allow_mpi
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
cd -- "$scratch"

failures=0
claim() { # NAME COMMAND...: the command succeeds
  local name=$1
  shift
  if "$@"; then say "ok: $name"; else say "FAILED: $name ($*)"; failures=$((failures + 1)); fi
}
exit_code() { # CODE WORD COMMAND...: that code, and one line of message with the word
  local wanted=$1 word=$2 code=0
  shift 2
  "$@" >/dev/null 2>message || code=$?
  [ "$code" -eq "$wanted" ] && [ "$(wc -l <message)" -eq 1 ] && grep -qF -- "$word" message
}
all_claims_hold() { [ "$failures" -eq 0 ] || fail "$failures claims do not hold"; }
