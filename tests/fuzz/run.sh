#!/bin/sh
# Gives every reader damaged text for so many seconds each, begun from the shipped files, small ones of the tests and what
# earlier runs have found (corpus/ in the build folder). `tests/fuzz/run.sh SECONDS [READER...]`, with RUNS=10000000 before it for
# no more than so many texts each; a find ends it with its input in finds/. `cmake --preset fuzz && cmake --build build-fuzz`
# before it, and `tests/fuzz/libraries.sh build-fuzz/libraries` for libraries that are watched too.
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
  # Many in one file, lines of "==" between them; HTTP ends its lines with carriage returns.
  case $reader in
    call) awk -v to="$corpus" 'BEGIN { RS = "==\n"; ORS = "" } { print > (to "/call-" NR) }' tests/fuzz/corpus/call/calls.txt ;;
    door) awk -v to="$corpus" 'BEGIN { RS = "==\n"; ORS = "" } { gsub("\n", "\r\n"); print > (to "/request-" NR) }' tests/fuzz/corpus/door/requests.txt ;;
    *) [ ! -d tests/fuzz/corpus/$reader ] || cp tests/fuzz/corpus/$reader/* "$corpus" ;;
  esac
  leaks=1
  case $reader in
    call | door | lines) leaks=0 ;; # threads of the server hold memory between texts, and each look for leaks finds none
  esac
  program=files
  case $reader in call | door | lines | project) program=workbench ;; esac
  # To keep how often each part of the source was reached (entropic) takes half of the fastest readers' time; of the slow
  # ones it prefers texts that take little of it.
  entropic=0
  case $reader in cell | selection | verify | call | door | lines) entropic=1 ;; esac
  length=4096
  [ $reader != lines ] || length=128 # one or a few: hundreds of lines in a text are answered one by one
  echo "== $reader"
  # Frames that are gone are not watched, which is a third faster; the tests under the sanitizers watch them. To keep where each
  # block of memory was asked for takes half of the cell's time: a find that needs it is run once more without these options.
  ASAN_OPTIONS=detect_leaks=$leaks:detect_stack_use_after_return=0:malloc_context_size=0 TUBEPLAN_READER=$reader LD_LIBRARY_PATH=$out/libraries/installed $out/tests/fuzz/fuzz_$program "$corpus" -detect_leaks=$leaks -max_total_time="$seconds" -runs="${RUNS:--1}" -timeout=20 -rss_limit_mb=4096 \
    -max_len=$length -entropic=$entropic -entropic_scale_per_exec_time=$entropic -print_final_stats=1 -verbosity=0 -artifact_prefix=$out/finds/$reader- 2>&1 | grep -E "ERROR|SUMMARY|stat::number_of|runtime error|Test unit" || true
  rm -rf /dev/shm/tubeplan-fuzz-$$
done
