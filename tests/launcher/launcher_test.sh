#!/bin/sh
# Tests of ./moire. Usage: launcher_test.sh SOURCE_FOLDER. Every case has a small project of its own, in a path with a space.
set -u
source=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failures=0

# expect WHAT FOUND EXPECTED
expect() {
  [ "$2" = "$3" ] && return
  failures=$((failures + 1))
  printf 'FAILED: %s: %s\nfound:    %s\nexpected: %s\n' "$case" "$1" "$2" "$3"
}

# A checkout whose "compiler" is cp, so that it can be broken by taking a source away.
make_project() {
  project=$(readlink -f "$scratch")/$1/a\ folder
  mkdir -p "$project/framework" "$project/plugins" "$project/tests"
  cp "$source/moire" "$source/CMakePresets.json" "$project"
  cat >"$project/CMakeLists.txt" <<'CMAKE'
cmake_minimum_required(VERSION 3.25)
project(small LANGUAGES NONE)
add_subdirectory(framework)
add_subdirectory(plugins)
if(MOIRE_TESTS)
  enable_testing()
  add_subdirectory(tests)
endif()
CMAKE
  cat >"$project/framework/CMakeLists.txt" <<'CMAKE'
set(program ${PROJECT_BINARY_DIR}/bin/moire)
add_custom_command(OUTPUT ${program} DEPENDS main COMMENT "Building the program"
                   COMMAND cp ${CMAKE_CURRENT_SOURCE_DIR}/main ${program})
add_custom_target(program ALL DEPENDS ${program})
CMAKE
  : >"$project/plugins/CMakeLists.txt"
  cat >"$project/tests/CMakeLists.txt" <<'CMAKE'
add_custom_target(tests ALL COMMAND cp ${CMAKE_CURRENT_SOURCE_DIR}/a_test ${PROJECT_BINARY_DIR})
add_test(NAME a_test COMMAND ${PROJECT_BINARY_DIR}/a_test)
CMAKE
  mkdir -p "$project/build/release/bin"
  write_program 'pwd; printf "<%s>" "$@"; exit 7'
  printf '#!/bin/sh\nexit 0\n' >"$project/tests/a_test"
  chmod +x "$project/tests/a_test"
}

# Clocks of file systems tick every few milliseconds: a source must not look as old as what was built from the last one.
write_program() {
  printf '#!/bin/sh\n%s\n' "$1" >"$project/framework/main"
  chmod +x "$project/framework/main"
  while [ -e "$project/build/release/bin/moire" ] && ! [ "$project/framework/main" -nt "$project/build/release/bin/moire" ]; do
    touch "$project/framework/main"
  done
}

# A PATH with the ordinary tools, but no compiler, no apt-get and no sudo; `id` says user $1.
make_machine() {
  machine=$scratch/machine$1
  mkdir "$machine"
  for tool in sh cat chmod cmake cp dirname env flock grep mkdir ninja nproc pkg-config readlink sed sort; do
    ln -s "$(command -v "$tool")" "$machine/$tool"
  done
  printf '#!/bin/sh\necho %s\n' "$1" >"$machine/id"
  chmod +x "$machine/id"
}

# launch COMMAND...: its `output`, `messages` and `code`.
launch() {
  output=$("$@" 2>"$scratch/messages")
  code=$?
  messages=$(cat "$scratch/messages")
}

case='arguments, folder and exit code are passed through a link from elsewhere'
make_project link
ln -s "$project/moire" "$scratch/linked"
cd "$scratch" || exit 1
launch ./linked run 'two words' '' '*'
expect output "$output" "$(pwd)
<run><two words><><*>"
expect code "$code" 7
expect messages "$messages" "moire: configuring build/release
moire: building, about 1 min
moire: built 1 of 1"

case='nothing is said and nothing is done when all is up to date'
launch ./linked
expect messages "$messages" ''
expect code "$code" 7

case='what is stale is built'
write_program 'exit 5'
launch ./linked
expect code "$code" 5

case='standard input reaches the program'
write_program cat
expect output "$(echo words | ./linked 2>/dev/null)" words

case='a build that fails shows the output of the compiler'
rm "$project/framework/main"
launch ./linked
expect code "$code" 2
expect messages "$messages" "ninja: error: '$project/framework/main', needed by 'bin/moire', missing and no known rule to make it
moire: build/release: cannot be built (the compiler's output is above)"

case='a checkout that was moved is configured anew'
write_program 'exit 3'
mv "$project" "$scratch/moved"
launch "$scratch/moved/moire"
expect code "$code" 3
expect messages "$messages" "moire: configuring build/release
moire: building, about 1 min
moire: built 1 of 1"

case='test builds and runs the tests, run leaves them alone'
make_project tested
launch "$project/moire" test
expect code "$code" 0
expect "last lines" "$(printf '%s\n' "$output" | grep 'tests passed')" '100% tests passed, 0 tests failed out of 1'
rm "$project/tests/a_test"
launch "$project/moire"
expect code "$code" 7
launch "$project/moire" test
expect code "$code" 2

case='a preset that is not there is refused'
launch "$project/moire" test --preset asn
expect code "$code" 2
expect messages "$messages" \
  'moire: test --preset: there is no such preset ("asn"); one of these would do: release debug asan tsan'

case='two launchers at once do not disturb each other'
make_project twice
"$project/moire" >"$scratch/first" 2>&1 &
launch "$project/moire"
expect "code of the second" "$code" 7
wait $!
expect "code of the first" $? 7

case='without apt-get, what is missing is named'
make_project bare
make_machine 1000
launch env PATH="$machine" "$project/moire"
expect code "$code" 2
expect messages "$messages" "moire: missing, and there is no apt-get here to install it:
  g++                  compiles the program
moire: install these (Debian's names), then call again"

case='without root and sudo, the command for root is named'
printf '#!/bin/sh\nexit 1\n' >"$machine/apt-get"
chmod +x "$machine/apt-get"
launch env PATH="$machine" "$project/moire"
expect code "$code" 2
expect messages "$messages" "moire: missing, and only root may install it (there is no sudo here):
  g++                  compiles the program
moire: as root, apt-get install --no-install-recommends g++"

case='what is missing is installed, and only that'
make_machine 0
printf '#!/bin/sh\necho "$@" >>"%s"\n: >"%s/c++"; chmod +x "%s/c++"\n' "$scratch/calls" "$machine" "$machine" \
  >"$machine/apt-get"
chmod +x "$machine/apt-get"
launch env PATH="$machine" "$project/moire"
expect code "$code" 7
expect calls "$(cat "$scratch/calls")" "-qq -y -o DPkg::Lock::Timeout=600 update
-qq -y -o DPkg::Lock::Timeout=600 install --no-install-recommends g++"
rm "$scratch/calls"
launch env PATH="$machine" "$project/moire"
expect "calls when all is there" "$(cat "$scratch/calls" 2>/dev/null)" ''

case='an installation that fails shows what apt-get said'
rm "$machine/c++"
printf '#!/bin/sh\necho "E: no network"; exit 1\n' >"$machine/apt-get"
launch env PATH="$machine" "$project/moire"
expect code "$code" 2
expect messages "$messages" \
  "moire: missing, so apt-get installs it and what it needs (on a bare machine this takes some minutes):
  g++                  compiles the program
moire: apt-get update: failed for some source; going on with the lists that are there
E: no network
E: no network
moire: apt-get could not install g++ (its output is above)"

[ "$failures" = 0 ] && echo "all cases of the launcher hold"
exit "$failures"
