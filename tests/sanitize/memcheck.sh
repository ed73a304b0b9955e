#!/bin/sh
# memcheck.sh TUBEPLAN FOLDER [STEP...]: the steps of the demo on a small list under valgrind's memcheck: invalid reads and
# writes, decisions on what was never written, memory lost for good. Ends with 1 where there is any.
set -eu
program=$(realpath "$1") out=$2
cells=$(realpath "$(dirname "$0")/../../app/cells")
shift 2
steps=${*:-map pose simulate calibrate plan verify score identify compare diagnose campaign}
mkdir -p "$out"
cd "$out"
found=0
for step in $steps; do
  case $step in
    map) words="map $cells/mockup.yaml" ;;
    pose) words="pose $cells/bench.yaml --joints=10,90,-20,5 --load 20" ;;
    simulate) words="simulate $cells/bench.yaml --design bench --readings 30 --seed 2 --hide joint-offset@theta3:0.1 --out made" ;;
    calibrate) words="plan $cells/mockup.yaml --tubes spread:2 --touches auto --truth $cells/mockup-true.yaml --seed 1 --out touched" ;;
    plan) words="plan $cells/mockup.yaml --tubes spread:4 --seed 1 --out planned" ;;
    verify) words="verify $cells/mockup.yaml planned" ;;
    score) words="score $cells/mockup.yaml --truth $cells/mockup-true.yaml --tubes spread:2 --seed 1" ;;
    identify) words="identify $cells/bench.yaml made/measurements.csv --out found.yaml" ;;
    compare) words="compare $cells/bench.yaml made/measurements.csv" ;;
    diagnose) words="diagnose $cells/bench.yaml made/measurements.csv --effects 1" ;;
    campaign) words="campaign $cells/mockup.yaml --runs 2 --holes 3 --tubes spread:6 --out many" ;;
  esac
  code=0
  valgrind -q --error-exitcode=99 --leak-check=full --errors-for-leak-kinds=definite --undef-value-errors=yes \
    --suppressions="$(dirname "$cells")/../tests/sanitize/memcheck.supp" --log-file="$step.log" "$program" $words > "$step.txt" 2>&1 || code=$?
  echo "$step: exit code $code, $(grep -c '^==[0-9]*== [A-Z]' "$step.log" || true) findings"
  [ "$code" -ne 99 ] || found=1
done
exit $found
