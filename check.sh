#!/usr/bin/env bash
# Everything that must hold before a change lands. People and CI run this one script.
#
#   ./check.sh            all of the below
#   ./check.sh format     rustfmt
#   ./check.sh lint       clippy and docs, warnings are errors
#   ./check.sh test       the tests of the workspace
#   ./check.sh devices    core on every device target; the firmware under QEMU, its digests
#                         against tests/golden.csv, its instructions against
#                         embedded/instructions.csv
#   ./check.sh speed      lanes against the plain loop, alone and in runs: the compiler still makes
#                         vectors of them
set -euo pipefail
cd "$(dirname "$0")"

# A Cortex-M4F and a Cortex-M0.
m4=thumbv7em-none-eabihf
m0=thumbv6m-none-eabi
targets="$m4 $m0 riscv32imac-unknown-none-elf wasm32-unknown-unknown aarch64-unknown-none"

say() { printf '\n== %s\n' "$*"; }
fail() { printf 'check.sh: %s\n' "$*" >&2; exit 1; }

format() {
  say "format"
  cargo fmt --all --check
  (cd embedded && cargo fmt --check)
}

lint() {
  say "clippy and docs"
  cargo clippy --workspace --all-targets -- -D warnings
  # A user may take core with any of its features.
  for features in "" std fixed heapless micromath; do
    cargo clippy -p motes-core --no-default-features --features "$features" -- -D warnings
  done
  RUSTDOCFLAGS="-D warnings" cargo doc --workspace --no-deps --quiet
}

# Builds the tests behind the checks that follow: the library is one unit, and takes one core.
build_tests() {
  say "tests are being built meanwhile"
  build_log=$(mktemp)
  cargo test --release --no-run >"$build_log" 2>&1 &
  build=$!
  trap 'kill "$build" 2>/dev/null || true; rm -f "$build_log"' EXIT
}

await_tests() {
  say "waiting for the tests to be built"
  wait "$build" || { cat "$build_log"; fail "the tests do not build"; }
}

tests() {
  say "tests"
  # As the README has it: all of the workspace.
  cargo test --release
}

# Says what to install; never skips.
need_device_tools() {
  local installed missing=""
  installed=$(rustc --print sysroot)/lib/rustlib
  for target in $targets; do
    [ -d "$installed/$target" ] || missing="$missing $target"
  done
  [ -z "$missing" ] || fail "targets are missing: run rustup target add$missing"
  command -v qemu-system-arm >/dev/null ||
    fail "qemu-system-arm is missing: on Debian run apt-get install qemu-system-arm"
}

devices() {
  need_device_tools
  say "core on device targets"
  for target in $targets; do
    # Not in release: that part of target/ is locked while the tests are being built.
    cargo check -p motes-core --target "$target"
  done
  say "firmware: links only if no panic can be reached"
  (
    cd embedded
    cargo clippy --release -- -D warnings
    cargo build --release
    # The others do not fit into the memory of its board.
    cargo build --release --target $m0 --bin wall --bin wall_steps
    # The same where arithmetic that overflows panics; another profile, hence another folder.
    export CARGO_PROFILE_RELEASE_OVERFLOW_CHECKS=true CARGO_TARGET_DIR=target/overflow-checks
    cargo build --release
    cargo build --release --target $m0 --bin wall --bin wall_steps
  )
  say "firmware under QEMU"
  local output
  output=$(emulate $m4 motes-firmware)
  printf '%s\n' "$output"
  # The first word of a line is a row of the table; all rows of these sizes must be there.
  golden ',(225|64|96),' "$output"
  output=$(emulate $m0 wall)
  printf '%s\n' "$output"
  golden '^wall-day,96,(q15.16|f32),' "$output"
  output=$(emulate $m4 restart)
  printf '%s\n' "$output"
  golden '^wall-day,96,q15.16,' "$output"
  echo "the devices have the digests of the host"
  say "instructions of a step under QEMU"
  output=$(
    steps $m4 instructions
    steps $m4 wall_steps
    steps $m0 wall_steps
  )
  printf '%s\n' "$output"
  # Another compiler may need a few more; a tenth more is a change for the worse.
  awk -F, '
    { key = $1 "," $2 "," $3 "," $4 "," $5 }
    FNR == NR { longest[key] = $7; next }
    !(key in longest) || !($7 <= 1.1 * longest[key]) { print "too many: " $0; bad = 1 }
    { delete longest[key] }
    END { for (key in longest) { print "missing: " key; bad = 1 } exit bad }
  ' <(tail -n +2 embedded/instructions.csv) - <<<"$output" ||
    fail "a step takes over 10 % more instructions than in embedded/instructions.csv"
  echo "no step takes over 10 % more instructions than before"
}

# Compares rows of the table of digests with those that a device has printed.
golden() {
  diff <(grep -E "$1" tests/golden.csv | sort) <(cut -d' ' -f1 <<<"$2" | sort) ||
    fail "the device's digests (>) are not those of tests/golden.csv (<)"
}

# Counts instructions with a program, target by target.
steps() {
  emulate "$1" "$2" -icount shift=6 | sed "s/^/$1,/"
}

# Runs a program of embedded/ for a target under QEMU.
emulate() {
  local board=mps2-an386 elf=embedded/target/$1/release/$2
  [ "$1" != $m0 ] || board=microbit
  shift 2
  timeout 900 qemu-system-arm -M $board -nographic \
    -semihosting-config enable=on,target=native "$@" -kernel "$elf"
}

speed() {
  say "speed of lanes over the plain loop"
  cargo bench --bench pairs -- --ratio
  cargo bench --bench runs
}

case "${1:-all}" in
  format) format ;;
  lint) lint ;;
  test) tests ;;
  devices) devices ;;
  speed) speed ;;
  all)
    need_device_tools
    format
    build_tests
    lint
    devices
    await_tests
    tests
    speed
    say "all good"
    ;;
  *) fail "unknown part '$1': format, lint, test, devices, speed, or none for all" ;;
esac
