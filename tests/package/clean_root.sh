#!/bin/sh
# clean_root.sh PACKAGE.deb ROOT [SECONDS]: tests the package in a clean Debian bookworm root, as a new user would
# install it. ROOT is created with debootstrap if absent; the script needs root rights and network access to Debian's
# packages. It installs the package with apt, plans the demo, opens the report and a served page, runs the Python
# examples and the notebook, and links the C++ example. Prints the time from `apt install` to the first picture; fails
# above SECONDS (60).
set -eu
package=$(realpath "$1") root=$2 limit=${3:-60}
source=$(realpath "$(dirname "$0")/../..")
cells=/usr/share/tubeplan/cells

[ -e "$root/etc/debian_version" ] || debootstrap --variant=minbase bookworm "$root" http://deb.debian.org/debian
root=$(realpath "$root")
inside() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }
server=
leave() {
  [ -z "$server" ] || kill "$server" 2> /dev/null || true
  umount "$root/dev/shm" "$root/proc" 2> /dev/null || true
}
trap leave EXIT
mount -t proc proc "$root/proc"
mkdir -p "$root/dev/shm" && mount -t tmpfs tmpfs "$root/dev/shm"
printf '#!/bin/sh\nexit 101\n' > "$root/usr/sbin/policy-rc.d" && chmod +x "$root/usr/sbin/policy-rc.d"
cp /etc/resolv.conf "$root/etc/resolv.conf"
cp "$package" "$root/root/tubeplan.deb"
rm -rf "$root/root/demo" "$root/root/tubeplan"
inside apt-get update -qq
inside apt-get purge -qq -y tubeplan > /dev/null 2>&1 || true

echo "== installed and planned"
begun=$(date +%s.%N)
inside apt-get install -qq -y --no-install-recommends /root/tubeplan.deb > "$root/root/apt.log" 2>&1
installed=$(date +%s.%N)
inside tubeplan plan $cells/mockup.yaml --tubes spread:60 --touches auto --truth $cells/mockup-true.yaml --seed 1 --out /root/demo
shown=$(date +%s.%N)
grep -q 'The arm from the side' "$root/root/demo/report.html"
inside tubeplan verify $cells/mockup.yaml /root/demo
inside tubeplan --version

echo "== the page"
inside tubeplan serve $cells/bench.yaml --port 0 --state /root/state > "$root/root/serve.log" 2>&1 &
server=$!
for _ in $(seq 50); do grep -q http "$root/root/serve.log" && break; sleep 0.2; done
address=$(grep -o 'http://[^ ]*' "$root/root/serve.log" | head -1)
curl -fsS "$address" | grep -ci '<script' > /dev/null
curl -fsS "${address}api/state" | grep -o '"version":"[^"]*"'
kill "$server" && wait "$server" || true
server=

echo "== from Python"
inside apt-get install -qq -y --no-install-recommends python3-numpy python3-pandas > /dev/null 2>&1
mkdir -p "$root/root/tubeplan"
cp -r "$source/app" "$source/docs" "$source/tests" "$root/root/tubeplan/"
for test in arrays documents; do
  inside python3 /root/tubeplan/tests/python/${test}_test.py /usr/bin/tubeplan /root/tubeplan > "$root/root/python.log" 2>&1 || { cat "$root/root/python.log"; exit 1; }
  grep -E "^(Ran|OK)" "$root/root/python.log"
done

echo "== linked from C++"
# The package does not depend on a compiler. packages.txt lists the dependencies of the libraries' development files.
inside apt-get install -qq -y --no-install-recommends g++ cmake make pkg-config libeigen3-dev libfmt-dev libtbb-dev libompl-dev \
  libfcl-dev coinor-libipopt-dev libmuparser-dev libboost-serialization-dev libboost-filesystem-dev libboost-system-dev > /dev/null 2>&1
inside cmake -S /root/tubeplan/tests/package/example -B /root/example -D CMAKE_BUILD_TYPE=Release > /dev/null
inside cmake --build /root/example > /dev/null
[ "$(inside /root/example/sag)" = -0.002000 ] && echo "sag of the example: -0.002000 m"

seconds() { echo "$2 - $1" | bc; }
echo "apt install $(seconds "$begun" "$installed") s, plan and report $(seconds "$installed" "$shown") s: $(seconds "$begun" "$shown") s to the first picture"
[ "$(echo "$(seconds "$begun" "$shown") < $limit" | bc)" = 1 ]
