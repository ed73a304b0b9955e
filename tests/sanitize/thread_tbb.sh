#!/bin/sh
# thread_tbb.sh FOLDER: oneTBB of Debian's source, built for the thread sanitizer into FOLDER/installed. Debian's own is not,
# and what it orders between threads would be taken for races. Needs a network for Debian's sources.
set -eu
mkdir -p "$1/lists/partial" && cd "$1"
[ -e installed/lib/cmake/TBB/TBBConfig.cmake ] && exit 0
echo "deb-src http://deb.debian.org/debian bookworm main" > sources.list
apt_here() { apt-get -q -o Dir::Etc::SourceList="$PWD/sources.list" -o Dir::Etc::SourceParts=/dev/null -o Dir::State::Lists="$PWD/lists" -o APT::Sandbox::User=root "$@"; }
apt_here update
apt_here source --download-only onetbb
rm -rf source && mkdir source && tar xf onetbb_*.orig.tar.xz -C source --strip-components=1
cmake -G Ninja -S source -B build -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_COMPILER=clang++-16 -DCMAKE_CXX_FLAGS="-O1 -g1 -fsanitize=thread" \
  -DTBB_TEST=OFF -DTBB_STRICT=OFF -DTBBMALLOC_BUILD=OFF -DCMAKE_INSTALL_PREFIX="$PWD/installed" -DCMAKE_INSTALL_LIBDIR=lib
cmake --build build
cmake --install build
