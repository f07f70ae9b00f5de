#!/bin/sh
# test_host.sh [HOST] [FOLDER]
#
# Puts transparency.h into the engine of examples/host by docs/host_transparency.diff, its dynamic transparency by
# docs/host_dynamic.diff, and oit_buffers.h by docs/host_oit.diff, each in a copy, and holds what docs/integration.md says of them: how many lines change; that frames
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

# apply NAME DIFF: the engine with a diff of docs/ in $work/NAME, and the program $work/NAME.out
apply() {
    mkdir -p "$work/$1"
    cp examples/host/*.[ch] "$work/$1/"
    added=$(grep -v '^+++' "$2" | grep -c '^+')
    taken=$(grep -v '^---' "$2" | grep -c '^-')
    echo "test_host: $2 adds or changes $added lines, $taken of them in place of others"
    check "$1: at most 60 lines change" [ "$added" -le 60 ]
    check "$1: no more lines go than come" [ "$taken" -le "$added" ]
    check "$1: the diff applies" patch -s -p3 -d "$work/$1" <"$2"
    check "$1: the engine builds with the header" build "$1"
}

# put_in NAME DIFF EXPRESSION: builds and runs the engine with a header
put_in() {
    name=$1
    apply "$1" "$2"
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

# Dynamic transparency: soldiers behind the wall and the trees are seen through holes in what is before them.
apply seen docs/host_dynamic.diff
check 'seen: the state cache is right' draw "$work/seen.out" seen
check 'seen, quiet place: the state cache is right' draw "$work/seen.out" seen_quiet --quiet-place
for target in normal id depth picture; do
    check "seen, quiet place: $target is what it was, bit for bit" same before_quiet.$target seen_quiet.$target
done
# soldiers PREFIX: samples that show one of the eight soldiers, whose numbers are the last eight that there are
soldiers() {
    od -An -v -tu2 -w2 "$work/$1.id" | awk '{ count[$1]++; if ($1 > most) most = $1 }
        END { for (id = most - 7; id <= most; id++) sum += count[id]; print sum + 0 }'
}
before=$(soldiers before) seen=$(soldiers seen)
echo "test_host: soldiers are seen in $before samples without, in $seen with dynamic transparency"
check 'seen: more than twice as much of the soldiers' [ "$seen" -gt $((2 * before)) ]
changed=$(differing before.normal seen.normal 0)
check 'seen: normals change where there are holes, and nowhere else' [ "$changed" -gt 1000 -a "$changed" -lt 60000 ]

echo "test_host: $passed passed, $failed failed"
[ "$failed" -eq 0 ]
