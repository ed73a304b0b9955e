#!/bin/sh
# Fuzzes every reader for SECONDS: `tests/fuzz/run.sh SECONDS [READER...]`. Inputs are mutated from the shipped files,
# small test files and the inputs of earlier runs (corpus/ in the build folder). RUNS=10000000 in the environment limits
# the number of inputs per reader. A failure ends the reader's run, with the failing input in finds/. Build first with
# `cmake --preset fuzz && cmake --build build-fuzz`; `tests/fuzz/libraries.sh build-fuzz/libraries` also instruments the
# libraries.
set -eu
cd "$(dirname "$0")/../.."
seconds=${1:?seconds for each reader}
shift
readers=${*:-arm cell measurements foreign urdf hole-map work-list selection formula campaign obj ply stl project cache plan verify tally yaml-edit call door lines}
out=build-fuzz
mkdir -p $out/finds
for reader in $readers; do
  corpus=$out/corpus/$reader
  mkdir -p "$corpus"
  case $reader in
    arm) cp app/cells/*-arm.yaml "$corpus" ;;
    cell | yaml-edit) cp app/cells/*.yaml "$corpus" ;;
    urdf) cp tests/app/urdf/*.urdf "$corpus" ;;
    hole-map) cp app/cells/sheets/*.csv "$corpus" 2> /dev/null || true ;;
    verify) cp tests/fuzz/corpus/plan/* "$corpus" ;;
  esac
  # These corpus files hold many inputs, separated by lines "=="; lines of HTTP requests end with CR LF.
  case $reader in
    call) awk -v to="$corpus" 'BEGIN { RS = "==\n"; ORS = "" } { print > (to "/call-" NR) }' tests/fuzz/corpus/call/calls.txt ;;
    door) awk -v to="$corpus" 'BEGIN { RS = "==\n"; ORS = "" } { gsub("\n", "\r\n"); print > (to "/request-" NR) }' tests/fuzz/corpus/door/requests.txt ;;
    *) [ ! -d tests/fuzz/corpus/$reader ] || cp tests/fuzz/corpus/$reader/* "$corpus" ;;
  esac
  leaks=1
  case $reader in
    call | door | lines) leaks=0 ;; # server threads hold memory between inputs, so that every leak check is in vain
  esac
  program=files
  case $reader in call | door | lines | project) program=workbench ;; esac
  # Entropic scheduling counts how often each code branch is reached, which takes half of the fastest readers' time. For
  # slow readers, it prefers inputs that run quickly.
  entropic=0
  case $reader in cell | selection | verify | call | door | lines) entropic=1 ;; esac
  length=4096
  [ $reader != lines ] || length=128 # a few lines only, because the lines of an input are answered one by one
  echo "== $reader"
  # Use after return is not detected here, which is a third faster; the tests under the sanitizers detect it. Allocation
  # stacks would take half of the cell reader's time; to see them, repeat a failing input without these options.
  ASAN_OPTIONS=detect_leaks=$leaks:detect_stack_use_after_return=0:malloc_context_size=0 TUBEPLAN_READER=$reader LD_LIBRARY_PATH=$out/libraries/installed $out/tests/fuzz/fuzz_$program "$corpus" -detect_leaks=$leaks -max_total_time="$seconds" -runs="${RUNS:--1}" -timeout=20 -rss_limit_mb=4096 \
    -max_len=$length -entropic=$entropic -entropic_scale_per_exec_time=$entropic -print_final_stats=1 -verbosity=0 -artifact_prefix=$out/finds/$reader- 2>&1 | grep -E "ERROR|SUMMARY|stat::number_of|runtime error|Test unit" || true
  rm -rf /dev/shm/tubeplan-fuzz-$$
done
