#!/bin/sh
# Installs a build and uses it as somebody who has nothing else: the smallest sampler of plugins/README.md, and one that
# `moire new` made, are built against it and run.
# Usage: install_test.sh SOURCES BUILD CMAKE GENERATOR COMPILER COMPILER_FLAGS
set -u
sources=$1 build=$2 cmake=$3 generator=$4 compiler=$5 flags=$6
scratch=$(readlink -f "$(mktemp -d)")
trap 'rm -rf "$scratch"' EXIT
unset MOIRE_PLUGIN_PATH MOIRE_DATA LD_LIBRARY_PATH
export ASAN_OPTIONS=intercept_tls_get_addr=0 # as for the other tests: sanitizer_options.cpp says why
failures=0

fail() {
  failures=$((failures + 1))
  printf 'FAILED: %s\n' "$*"
}

# expect WHAT FOUND EXPECTED
expect() { [ "$2" = "$3" ] || fail "$1
found:
$2
expected:
$3"; }

# Runs a command; its output is shown if it fails, and then nothing more can be tested.
must() {
  "$@" >"$scratch/log" 2>&1 && return
  cat "$scratch/log"
  fail "$*"
  exit 1
}

# The first block of a language under "The smallest sampler".
block() {
  awk -v fence="\`\`\`$1" '/^## /{ours = $0 == "## The smallest sampler"}
    /^```$/ && inside {exit} inside {print} ours && $0 == fence {inside = 1}' "$sources/plugins/README.md"
}

# Builds the folder $1 with nothing but the installation and a compiler.
build_outside() {
  must "$cmake" -S "$1" -B "$1/build" -G "$generator" -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_FLAGS="$flags" \
    -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_DISABLE_FIND_PACKAGE_fmt=ON -DCMAKE_DISABLE_FIND_PACKAGE_Boost=ON
  must "$cmake" --build "$1/build"
}

# Renders a few pixels with the sampler $1 of the folder $2.
use() {
  moire list samplers --plugins "$2/build" | grep -q "^  $1  *$3\$" || fail "$1 is not listed"
  expect "render with $1" "$(cd "$scratch" && moire render heightfield "$1" --plugins "$2/build" \
    --set scene.size=64 --width 24 --height 16 -o "$1.png" 2>&1; echo "exit $?")" \
    "$1.png: $1 on heightfield[size=64]
exit 0"
  [ -s "$scratch/$1.png" ] || fail "$1.png is empty"
}

moire() { "$prefix/bin/moire" "$@"; }

# All that is installed, and where.
must "$cmake" --install "$build" --prefix "$scratch/first"
prefix="$scratch/a place"
mv "$scratch/first" "$prefix" # it does not mind
version=$(sed -n 's/.*interface_version = \([0-9]*\);.*/\1/p' "$sources/framework/include/moire/plugin.h")
# Outside marks come with what this machine has installed.
expect "files" "$(cd "$prefix" && find . ! -type d ! -name 'moireTargets-*' ! -name cairo.so ! -name agg.so | sort)" "$( (
  echo ./bin/moire
  (cd "$sources/framework" && find ./include/moire -type f)
  for name in moireConfig moireConfigVersion moireTargets MoirePlugin; do echo "./lib/cmake/moire/$name.cmake"; done
  printf '%s\n' ./lib/libmoire.so "./lib/libmoire.so.$version" ./lib/moire/moire_images.so
  # As the plugins name themselves.
  cat "$sources"/plugins/*/*/*.cpp | tr -d ' \n' | grep -oE 'MOIRE_(SAMPLER|SCENE)\([a-z_]+' | sed 's/.*(//' |
    grep -vxE 'cairo|agg' | sed 's|.*|./lib/moire/plugins/&.so|'
) | sort)"
for file in "$prefix/bin/moire" "$prefix"/lib/moire/*.so "$prefix"/lib/moire/plugins/*.so; do
  found=$(ldd "$file" | sed -n 's/.*libmoire[^ ]* => //; t print; d; :print; s/ (0x.*//; p')
  [ -z "$found" ] && continue # a small plugin calls nothing in it
  expect "libmoire of $file" "$(readlink -f "$found")" "$(readlink -f "$prefix/lib/libmoire.so")"
done

# The smallest sampler, just as it is shown.
mkdir "$scratch/rooks"
block cpp >"$scratch/rooks/rooks.cpp"
block cmake >"$scratch/rooks/CMakeLists.txt"
lines=$(wc -l <"$scratch/rooks/rooks.cpp")
[ "$lines" -gt 10 ] && [ "$lines" -le 40 ] || fail "the smallest sampler has $lines lines; at most 40 are small"
build_outside "$scratch/rooks"
use rooks "$scratch/rooks" "Four points, no two in one row or column."
expect "headers of other libraries" "$("$compiler" -std=c++20 -I"$prefix/include" -M "$scratch/rooks/rooks.cpp" |
  grep -oE '/(fmt|boost|nlohmann|OpenImageIO|tbb)/[^ ]*')" ""

# The one that `moire new` makes.
must moire new sampler my_dots -o "$scratch/own plugins"
build_outside "$scratch/own plugins/my_dots"
use my_dots "$scratch/own plugins/my_dots" "One point in the middle of each pixel."

[ "$failures" -eq 0 ] && echo "all passed"
exit "$((failures > 0))"
