#!/usr/bin/env bash
# Fuzzes longer than CI does: fuzz.sh [SECONDS] [TARGET...], 600 s and all targets when not given. Begins with the
# corpus in tests/fuzz/corpus and with what earlier runs found in build/fuzz_corpus; a crash stays in
# build/fuzz_found and gives exit status 1. TARGET is fuzz_NAME, or NAME alone.
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

seconds=600
if [[ ${1-} =~ ^[0-9]+$ ]]; then
    seconds=$1
    shift
fi
cmake --preset fuzz >/dev/null && cmake --build --preset fuzz --target tests/fuzz/all || exit 2

targets=()
for name in "$@"; do
    targets+=("build/fuzz/tests/fuzz/fuzz_${name#fuzz_}")
done
if ((${#targets[@]} == 0)); then
    for target in build/fuzz/tests/fuzz/fuzz_*; do
        [[ -f $target && -x $target ]] && targets+=("$target")
    done
fi

status=0
for target in "${targets[@]}"; do
    name=${target##*/}
    if [[ ! -x $target ]]; then
        echo "there is no target $name" >&2
        status=2
        continue
    fi
    grown=build/fuzz_corpus/$name found=build/fuzz_found
    mkdir -p "$grown" "$found"
    log=$found/$name.log
    if "$target" -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -print_final_stats=1 \
        -artifact_prefix="$found/${name}_" "$grown" "tests/fuzz/corpus/$name" >"$log" 2>&1; then
        echo "$name: $(sed -n 's/^stat::number_of_executed_units: *//p' "$log") runs, \
slowest $(sed -n 's/^stat::slowest_unit_time_sec: *//p' "$log") s, $(grep -c . < <(ls "$grown")) inputs found"
    else
        echo "$name: FAILED, see $log"
        tail -n 30 "$log"
        ((status)) || status=1
    fi
done
exit "$status"
