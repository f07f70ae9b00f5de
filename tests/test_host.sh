#!/bin/sh
# test_host.sh [HOST] [FOLDER]
#
# Puts transparency.h into the engine of examples/host by docs/host_transparency.diff, and oit_buffers.h by
# docs/host_oit.diff, each in a copy, and holds what docs/integration.md says of them: how many lines change; that frames
# without machines are, in all of the engine's targets, what they were; that frames with machines show the hulls' insides;
# that the engine's state cache finds nothing changed, and would find it. Run it from the top of the repository; HOST, by
# default build/host, is the engine without the headers.
set -u
host=${1:-build/host} work=${2:-build/test_host}
passed=0 failed=0
LC_ALL=C
export LC_ALL

check() {
    what=$1
    shift
    if "$@"; then
        passed=$((passed + 1))
    else
        echo "test_host: failed: $what"
        failed=$((failed + 1))
    fi
}

# build NAME: compiles the engine in $work/NAME into $work/NAME.out
build() {
    "${CC:-cc}" -std=c11 -O2 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -I. -Iexamples \
        -isystem build/glad/include "$work/$1"/*.c build/libexamples.a -lassimp -lEGL -lm -o "$work/$1.out"
}

# draw PROGRAM PREFIX [OPTION...]: two frames, with the state cache checked, the targets into PREFIX.*
draw() {
    program=$1 prefix=$2
    shift 2
    "$program" --check --frames 2 --size 320x200 --dump "$work/$prefix" "$@" "$work/$prefix.png" >"$work/$prefix.log" 2>&1
}

same() {
    cmp -s "$work/$1" "$work/$2"
}

# differing A B MOST: how many bytes of two files of one size differ by more than MOST
differing() {
    cmp -l "$work/$1" "$work/$2" | awk -v most="$3" '
        function value(octal) { return int(octal / 100) * 64 + int(octal / 10) % 10 * 8 + octal % 10 }
        { d = value($2) - value($3); if (d > most || -d > most) count++ }
        END { print count + 0 }'
}

# careless NAME EXPRESSION: the engine in $work/NAME with one careless line, so that the check of its state cache is seen to
# find something
careless() {
    mkdir -p "$work/$1_careless"
    cp "$work/$1"/* "$work/$1_careless/"
    sed "$2" "$work/$1/renderer.c" >"$work/$1_careless/renderer.c"
    check "$1: the careless engine builds" build "$1_careless"
    check "$1: a state that is not put back is found" \
        sh -c '"$1" --check --size 64x40 "$2" >"$3" 2>&1; [ $? -eq 2 ] && grep -q "behind the cache" "$3"' - \
        "$work/$1_careless.out" "$work/careless.png" "$work/careless.log"
}

# put_in NAME DIFF EXPRESSION: builds and runs the engine with a header
put_in() {
    name=$1 diff=$2
    mkdir -p "$work/$name"
    cp examples/host/*.[ch] "$work/$name/"
    added=$(grep -v '^+++' "$diff" | grep -c '^+')
    taken=$(grep -v '^---' "$diff" | grep -c '^-')
    echo "test_host: $diff adds or changes $added lines, $taken of them in place of others"
    check "$name: at most 60 lines change" [ "$added" -le 60 ]
    check "$name: no more lines go than come" [ "$taken" -le "$added" ]
    check "$name: the diff applies" patch -s -p3 -d "$work/$name" <"$diff"
    check "$name: the engine builds with the header" build "$name"
    careless "$name" "$3"
    check "$name: the state cache is right" draw "$work/$name.out" "$name"
    check "$name, quiet place: the state cache is right" draw "$work/$name.out" "${name}_quiet" --quiet-place
    for target in normal id depth; do
        check "$name, quiet place: $target is what it was, bit for bit" same before_quiet.$target "${name}_quiet.$target"
    done
    # The picture is rounded to 8 bits before it is scaled down, not after: at most 1/255.
    check "$name, quiet place: the picture is what it was, to 1/255" \
        [ "$(differing before_quiet.picture "${name}_quiet.picture" 1)" -eq 0 ]
    changed=$(differing before.picture "$name.picture" 16)
    echo "test_host: $name: with machines $changed of 256000 bytes of the picture differ by more than 16"
    check "$name, with machines: hulls became glass" [ "$changed" -gt 2000 ]
    # Glass is written into one target and the depth; where no hull is, ids are what they were.
    check "$name, with machines: the depth holds the hulls, as before" same before.depth "$name.depth"
    check "$name, with machines: ids of hulls alone are gone" [ "$(differing before.id "$name.id" 0)" -lt 20000 ]
}

rm -rf "$work"
mkdir -p "$work"
check 'before: the state cache is right' draw "$host" before
check 'before, quiet place: the state cache is right' draw "$host" before_quiet --quiet-place
put_in transparency docs/host_transparency.diff 's/{\.reversed_z = 1}/{.reversed_z = 1, .state = TR_STATE_LEAVE_DIRTY}/'
put_in oit docs/host_oit.diff 's/{\.reversed_z = 1}/{.reversed_z = 1, .state = OIT_STATE_LEAVE_DIRTY}/'

echo "test_host: $passed passed, $failed failed"
[ "$failed" -eq 0 ]
