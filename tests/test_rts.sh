#!/bin/sh
# test_rts.sh [RTS [FOLDER]]
#
# Tests the battlefield program from outside: every scene becomes a picture, frames of a sequence differ, the same command
# gives the same bytes, wrong usage is told in one line and leaves nothing behind, and without a display it says so.
set -u
LC_ALL=C
export LC_ALL
rts=${1:-build/rts}
scratch=${2:-build/test_rts}
top=$(cd "$(dirname "$0")/.." && pwd) || exit 1
kaykit=${GLASSINE_MODELS:-$top/../shared/models}/kaykit
passed=0 failed=0

case $rts in
/*) ;;
*) rts=$PWD/$rts ;;
esac
rm -rf "$scratch"
mkdir -p "$scratch/out" && cd "$scratch" || exit 1

# check WHAT CONDITION...
check() {
    what=$1
    shift
    if "$@"; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        printf 'FAILED: %s\n' "$what"
        if [ -s stderr ]; then sed 's/^/    stderr: /' stderr | head -n 5; fi
    fi
}

run() {
    timeout 120 "$rts" "$@" >stdout 2>stderr </dev/null
    status=$?
}

is_png() {
    [ "$(head -c 8 "$1" | od -An -tx1 | tr -d ' \n')" = 89504e470d0a1a0a ] && [ "$(wc -c <"$1")" -gt 1000 ]
}

differ() {
    ! cmp -s "$1" "$2"
}

small='--size 320x200 --quality 1'

# drawn WHAT NAME OPTION...: becomes out/NAME.png
drawn() {
    what=$1 name=$2
    shift 2
    run $small "$@" -o "out/$name.png"
    check "$what: exit status 0" [ "$status" -eq 0 ]
    check "$what: a picture" is_png "out/$name.png"
}

# refused WHAT STATUS OPTION...: one line on stderr, nothing written
refused() {
    what=$1 wanted=$2
    shift 2
    run "$@"
    check "$what: exit status $wanted" [ "$status" -eq "$wanted" ]
    check "$what: one line" [ "$(grep -c '^rts: ' stderr)-$(wc -l <stderr)" = 1-1 ]
}

for scene in battlefield abstract walkthrough; do
    drawn "$scene" $scene --scene $scene
done
drawn 'the same again' again --scene battlefield
check 'the same command gives the same bytes' cmp -s out/battlefield.png out/again.png
drawn 'OpenGL ES' gles --scene abstract --gles

# Every method and knob makes a picture of its own.
for method in one-mask dither exact sequence published; do
    drawn "--method $method" $method --scene abstract --method $method
done
drawn '--method off' off --scene abstract --method off
for method in one-mask dither exact sequence published; do
    check "--method $method shows what off does not" differ out/off.png out/$method.png
done
check 'dithered is not blended' differ out/one-mask.png out/dither.png
check 'published is not the sequence' differ out/sequence.png out/published.png
drawn '--mask-width' narrow --scene abstract --mask-width 0
drawn '--alpha-target' clear --scene abstract --alpha-target 0
drawn '--fade' faded --scene abstract --fade 1
drawn '--active' active --scene abstract --active --light 160,100,40,20
for knob in narrow clear active; do
    check "$knob: another picture" differ out/one-mask.png out/$knob.png
done
check 'all faded out: as if off' cmp -s out/off.png out/faded.png
for shape in circle ellipse hull; do
    drawn "--shape $shape" $shape --scene abstract --shape $shape --method sequence
    check "$shape: another picture than of outlines" differ out/sequence.png out/$shape.png
done
check 'a circle is no ellipse' differ out/circle.png out/ellipse.png
check 'an ellipse is no hull' differ out/ellipse.png out/hull.png
drawn '--shape of exact' exact_hull --scene abstract --shape hull --method exact
check 'a hull of exact' differ out/exact.png out/exact_hull.png
refused '--shape of one mask' 1 --scene abstract --shape circle -o out/x.png
drawn '--layers 1' layer --scene abstract --layers 1 --method sequence
drawn '--occluders each' each --scene abstract --occluders each --method sequence
drawn '--combine product' product --scene abstract --combine product --method sequence
for knob in layer each product; do
    check "$knob: another picture" differ out/sequence.png out/$knob.png
done
run $small --scene abstract --frames 3 --turn 30 -o out/turn.png
check 'frames: exit status 0' [ "$status" -eq 0 ]
check 'frames: three of them' [ "$(ls out/turn_0001.png out/turn_0002.png out/turn_0003.png 2>/dev/null | wc -l)" -eq 3 ]
check 'frames: the eye has moved' differ out/turn_0001.png out/turn_0003.png
drawn 'another time' later --time 9
check 'units have moved' differ out/battlefield.png out/later.png
run $small --explain -o out/explained.png
check 'explain: the driver' grep -q '"driver": "' stdout
check 'explain: the passes' grep -q '"pass": "scene"' stdout
if [ -d "$kaykit" ]; then
    drawn 'KayKit' kaykit --kaykit "$kaykit"
    check 'KayKit: another picture' differ out/battlefield.png out/kaykit.png
else
    echo "test_rts.sh: no models in $kaykit: left out"
fi

ls out >before
refused 'an unknown option' 2 --nonsense -o out/x.png
refused 'an unknown scene' 2 --scene moon -o out/x.png
refused 'a size that is none' 2 --size 3x -o out/x.png
refused 'a missing value' 2 -o
refused 'an unknown method' 2 --method magic -o out/x.png
refused 'a divisor that is none' 2 --mask-divisor 3 -o out/x.png
refused 'half a light' 2 --light 1,2 -o out/x.png
refused 'no such folder' 1 -o out/none/x.png
refused 'no such models' 1 --kaykit out/none -o out/x.png
refused 'a number out of range' 2 --quality 9 -o out/x.png
run --help
check 'help' [ "$status" -eq 0 ]
env -u DISPLAY -u WAYLAND_DISPLAY timeout 60 "$rts" >stdout 2>stderr
check 'no display: exit status 1' [ $? -eq 1 ]
check 'no display: one line that says what to do' grep -q '^rts: no window.*-o OUT.png' stderr
ls out >after
check 'nothing is left behind' cmp -s before after

echo "test_rts.sh: $passed passed, $failed failed"
[ "$failed" -eq 0 ]
