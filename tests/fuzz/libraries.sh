#!/bin/sh
# libraries.sh FOLDER: builds the parser libraries of the readers from Debian's patched sources, instrumented for the
# fuzzer, into FOLDER/installed. run.sh loads these libraries instead of Debian's binaries, whose faults would not be
# detected and whose branches would not guide the fuzzer. Needs network access to Debian's sources.
set -eu
mkdir -p "$1/lists/partial" && cd "$1"
printf 'deb-src http://deb.debian.org/debian%s main\n' ' bookworm' '-security bookworm-security' > sources.list
apt_here() { apt-get -q -o Dir::Etc::SourceList="$PWD/sources.list" -o Dir::Etc::SourceParts=/dev/null -o Dir::State::Lists="$PWD/lists" -o APT::Sandbox::User=root "$@"; }
apt_here update
flags="-O2 -g1 -fsanitize=address,fuzzer-no-link -fno-sanitize-coverage=trace-cmp -fno-omit-frame-pointer"
mkdir -p installed

# library NAME OPTION...: builds all libraries of a source package.
library() {
  name=$1
  shift
  apt_here source --download-only "$name"
  rm -rf "$name" && mkdir "$name"
  tar xf "${name}"_*.orig.tar.* -C "$name" --strip-components=1
  tar xf "${name}"_*.debian.tar.* -C "$name"
  [ ! -e "$name/debian/patches/series" ] || grep -v '^#' "$name/debian/patches/series" | while read -r patch; do
    patch -s -d "$name" -p1 < "$name/debian/patches/$patch"
  done
  cmake -G Ninja -S "$name" -B "$name/build" -DCMAKE_BUILD_TYPE=None -DCMAKE_CXX_COMPILER=clang++-16 -DCMAKE_C_COMPILER=clang-16 \
    -DCMAKE_CXX_FLAGS="$flags" -DCMAKE_C_FLAGS="$flags" -DBUILD_SHARED_LIBS=ON -DBUILD_TESTING=OFF "$@"
  cmake --build "$name/build"
  find "$name/build" -name '*.so*' ! -type d -exec cp -P {} installed/ \;
}

library yaml-cpp -DYAML_CPP_BUILD_TESTS=OFF -DYAML_CPP_BUILD_TOOLS=OFF -DYAML_BUILD_SHARED_LIBS=ON
library tinyxml2
library muparser -DENABLE_SAMPLES=OFF -DENABLE_OPENMP=OFF
library cpp-httplib -DHTTPLIB_COMPILE=ON
for file in installed/libhttplib.so.*; do ln -sf "${file##*/}" "$(echo "$file" | sed 's/libhttplib/libcpp-httplib/')"; done # file name used by Debian
