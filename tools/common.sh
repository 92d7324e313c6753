# shellcheck shell=bash
# Shell functions that the tools share: packages, quiet phases, configuring and building. Sourced, never run.

export LC_ALL=C.UTF-8  # sort, awk and the clock below agree on what a number is
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd -P)
log_folder="$root/build/log"

# use_preset NAME: what is configured and built from here on (CMakePresets.json), and where.
use_preset() { preset=$1 build="$root/build/$1"; }
use_preset release

say() { printf '%s\n' "$*"; }
fail() { printf '%s: %s\n' "$(basename -- "$0")" "$*" >&2; exit 1; }
seconds_since() { awk -v a="$1" -v b="$EPOCHREALTIME" 'BEGIN { printf "%.1f", b - a }'; }

# quietly NAME COMMAND...: one line with the name and the seconds it took; the output goes into a log.
# On failure: the first errors, the end of the log, and out.
quietly() {
  local name=$1 log begin=$EPOCHREALTIME status=0
  shift
  log="$log_folder/${name// /_}.log"
  mkdir -p -- "$log_folder"
  printf '%s ... ' "$name"
  "$@" >"$log" 2>&1 </dev/null || status=$?
  say "$(seconds_since "$begin") s"
  [ "$status" -eq 0 ] || show_failure "$name" "$log" "$status"
}

show_failure() {
  local name=$1 log=$2 status=$3
  {
    say "--- first errors in $log"
    grep -nE -m 10 'error:|CMake Error|^E: ' "$log" | cut -c -300 || true
    say "--- end of $log"
    tail -n 30 -- "$log" | cut -c -300
  } >&2
  fail "$name failed with exit code $status"
}

# The packages of a list that are not installed.
missing_packages() {
  local wanted
  wanted=$(sed -e 's/#.*//' -e 's/[[:space:]]//g' -e '/^$/d' -- "$1" | sort -u)
  # shellcheck disable=SC2086  # one word per package; dpkg-query complains about those it has never heard of
  comm -23 <(printf '%s\n' "$wanted") \
    <({ dpkg-query -W -f '${db:Status-Status} ${Package}\n' $wanted 2>/dev/null || true; } | sed -n 's/^installed //p' | sort -u)
}

# Installs what is missing of a list of packages, and says so before it starts.
install_packages() {
  local list=$1 missing as_root=() through=""
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    fail "no apt here: install what $list names by other means, then: cmake --preset release && cmake --build --preset release"
  fi
  missing=$(missing_packages "$list")
  [ -n "$missing" ] || return 0
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || fail "neither root nor sudo, and these Debian packages are missing: ${missing//$'\n'/ }"
    through=" through sudo"
  fi
  say "installing $(wc -l <<<"$missing") missing Debian packages with apt-get$through: ${missing//$'\n'/ }"
  if [ -n "$through" ]; then
    as_root=(sudo -n)  # from here on nobody is asked, so that nothing waits behind a log
    if [ -t 0 ]; then sudo -v; else sudo -n true; fi || fail "sudo does not allow it: install the packages as root first"
  fi
  as_root+=(env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=600)
  quietly "package lists" "${as_root[@]}" update
  # shellcheck disable=SC2086  # one word per package
  quietly "packages" "${as_root[@]}" install -y --no-install-recommends $missing
}

# As many compilers at once as there are cores and 2 GB of free memory for each.
build_jobs() {
  awk -v cores="$(nproc)" '/^MemAvailable:/ { n = int($2 / 2e6); if (n > cores) n = cores; print n < 1 ? 1 : n }' /proc/meminfo
}

# build_targets [TARGET...]: configures where that was never done (later Ninja does it by itself), then builds.
# Says nothing when nothing is to do.
build_targets() {
  local log="$log_folder/build_$preset.log" begin=$EPOCHREALTIME status=0
  # A checkout that was moved or copied brings along a build folder that points at its old place.
  if [ -f "$build/CMakeCache.txt" ] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$build/CMakeCache.txt"; then
    rm -rf -- "$build"
  fi
  if [ ! -f "$build/build.ninja" ]; then
    local launcher=()
    if command -v ccache >/dev/null; then launcher=(-DCMAKE_C_COMPILER_LAUNCHER=ccache -DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi
    quietly "configure $preset" cmake -S "$root" --preset "$preset" "${launcher[@]}"
    say "build $preset ... (a first one takes minutes; follow it in $log)"
  fi
  mkdir -p -- "$log_folder"
  ninja -C "$build" -j "$(build_jobs)" "$@" >"$log" 2>&1 </dev/null || status=$?
  [ "$status" -eq 0 ] || show_failure "build $preset" "$log" "$status"
  grep -q '^ninja: no work to do' "$log" || say "build $preset ... $(seconds_since "$begin") s"
}

# What Open MPI needs to know about this machine before it starts.
allow_mpi() {
  export OPENBLAS_NUM_THREADS=1                     # the ranks share the cores, not the threads of a library
  export OMPI_MCA_hwloc_base_binding_policy=none    # runs side by side must not all sit on the first core
  if [ "$(id -u)" -eq 0 ]; then export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1; fi
}
