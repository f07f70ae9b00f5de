#!/bin/sh
# test_illustrate.sh [ILLUSTRATE [FOLDER]]
#
# Tests the main program from outside: what it says and how it ends for broken files and wrong usage, that a failed run
# leaves nothing behind, and that every built-in model and every model in ../shared/models (or $GLASSINE_MODELS)
# becomes a picture. By default tests build/illustrate in a folder below build/. SECONDS_EACH: the longest that
# one run may take, by default 60.
set -u
LC_ALL=C
export LC_ALL
illustrate=${1:-build/illustrate}
scratch=${2:-build/test_illustrate}
limit=${SECONDS_EACH:-60}
top=$(cd "$(dirname "$0")/.." && pwd) || exit 1
models=${GLASSINE_MODELS:-$top/../shared/models}
passed=0 failed=0

case $illustrate in
/*) ;;
*) illustrate=$PWD/$illustrate ;;
esac
if [ ! -x "$illustrate" ]; then
    echo "test_illustrate.sh: no program at $illustrate" >&2
    exit 1
fi
case $models in
/*) ;;
*) models=$PWD/$models ;;
esac
rm -rf "$scratch"
mkdir -p "$scratch/in" "$scratch/out" && cd "$scratch" || exit 1

pass() {
    passed=$((passed + 1))
}

fail() {
    failed=$((failed + 1))
    printf 'FAILED: %s\n' "$1"
    if [ -s stderr ]; then sed 's/^/    stderr: /' stderr | head -n 5; fi
}

# check WHAT CONDITION...: one test.
check() {
    what=$1
    shift
    if "$@"; then pass; else fail "$what"; fi
}

run() {
    timeout "$limit" "$illustrate" "$@" >stdout 2>stderr </dev/null
    status=$?
}

one_line_on_stderr() {
    [ "$(wc -l <stderr)" -eq 1 ] && grep -q '^illustrate: ' stderr
}

nothing_left() {
    [ -z "$(ls -A out)" ]
}

# refuses STATUS TEXT ARGUMENTS...: ends with the status, one line that holds the text, and nothing in out/.
refuses() {
    expected=$1 text=$2
    shift 2
    run "$@"
    name="illustrate $*"
    if [ "$status" -ne "$expected" ]; then
        fail "$name: status $status, not $expected"
    elif ! one_line_on_stderr; then
        fail "$name: not one line on stderr"
    elif ! grep -q -e "$text" stderr; then
        fail "$name: the line does not say: $text"
    elif ! nothing_left; then
        fail "$name: left $(ls -A out | head -n 3) behind"
        rm -rf out && mkdir out
    else
        pass
    fi
}

# draws WIDTH HEIGHT ARGUMENTS...: a picture of that size comes out that is not blank, and nothing beside it.
draws() {
    width=$1 height=$2
    shift 2
    run --size "${width}x$height" --quality 1 -o out/picture.png "$@"
    name="illustrate $*"
    if [ "$status" -ne 0 ]; then
        fail "$name: status $status"
    elif [ "$(ls -A out)" != picture.png ]; then
        fail "$name: in the folder of the picture is: $(ls -A out | head -n 3)"
    elif [ "$(png_size out/picture.png)" != "$width $height" ]; then
        fail "$name: the picture is $(png_size out/picture.png), not $width $height"
    elif cmp -s out/picture.png blank.png; then
        fail "$name: the picture is blank"
    else
        pass
    fi
    rm -rf out && mkdir out
}

# Width and height from the header; nothing for a file that is no PNG.
png_size() {
    [ "$(head -c 8 "$1" | od -An -tx1 | tr -d ' \n')" = 89504e470d0a1a0a ] || return 0
    tail -c +17 "$1" | head -c 8 | od -An -tu1 | awk '{print $1 * 16777216 + $2 * 65536 + $3 * 256 + $4, \
        $5 * 16777216 + $6 * 65536 + $7 * 256 + $8}'
}

# The four bytes of a number, the lowest first.
little32() {
    for shift in 0 8 16 24; do
        printf "\\$(printf '%03o' $((($1 >> shift) & 255)))"
    done
}

zeros() {
    head -c "$1" /dev/zero
}

# pixel FILE X Y: red, green and blue of a picture that this program has written (8 bits a channel, RGB or RGBA).
pixel() {
    python3 - "$@" <<'END'
import struct, sys, zlib
data, at, packed = open(sys.argv[1], "rb").read(), 8, b""
x, y = int(sys.argv[2]), int(sys.argv[3])
while at < len(data):
    length, kind = struct.unpack(">I4s", data[at:at + 8])
    if kind == b"IHDR":
        width, height, depth, color = struct.unpack(">IIBB", data[at + 8:at + 18])
    if kind == b"IDAT":
        packed += data[at + 8:at + 8 + length]
    at += 12 + length
n = 4 if color == 6 else 3
raw, above = zlib.decompress(packed), bytes(width * n)
for line in range(y + 1):
    start = line * (width * n + 1)
    how, row = raw[start], bytearray(raw[start + 1:start + 1 + width * n])
    for i in range(width * n):
        a, b, c = row[i - n] if i >= n else 0, above[i], above[i - n] if i >= n else 0
        near = min((abs(b - c), 0, a), (abs(a - c), 1, b), (abs(a + b - 2 * c), 2, c))[2]
        row[i] = row[i] + (0, a, b, (a + b) // 2, near)[how] & 255
    above = row
print(*above[n * x:n * x + 3])
END
}

# sheet NAME DEPTH SIDE: an upright square in an OBJ, as seen from the front; uses and counts `corners`.
corners=0
sheet() {
    printf 'o %s\nv -%s %s -%s\nv %s %s -%s\nv %s %s %s\nv -%s %s %s\n' "$1" "$3" "$2" "$3" "$3" "$2" "$3" "$3" "$2" "$3" \
        "$3" "$2" "$3"
    printf 'f %d %d %d %d\n' $((corners + 1)) $((corners + 2)) $((corners + 3)) $((corners + 4))
    corners=$((corners + 4))
}

# glb JSON BYTES [CLAIMED]: a GLB file on stdout; BYTES are the octal escapes of its binary chunk, a multiple of four.
glb() {
    text=$1
    while [ $((${#text} % 4)) -ne 0 ]; do text="$text "; done
    binary_length=$(printf "$2" | wc -c)
    total=$((12 + 8 + ${#text} + 8 + binary_length))
    printf 'glTF' && little32 2 && little32 "${3:-$total}"
    little32 ${#text} && printf 'JSON%s' "$text"
    little32 "$binary_length" && printf 'BIN\000' && printf "$2"
}

# ---- files: good ones to spoil, and bad ones -----------------------------------------------------------------

one='\000\000\200\077' nil='\000\000\000\000' nan='\000\000\300\177'
# One triangle: three corners, then three indices of two bytes and two bytes to fill up.
triangle="$nil$nil$nil$one$nil$nil$nil$one$nil\000\000\001\000\002\000\000\000"
nan_triangle="$nan$nan$nan$nan$nil$nil$nil$nan$nil\000\000\001\000\002\000\000\000"
far_triangle="$nil$nil$nil$one$nil$nil$nil$one$nil\000\000\001\000\377\377\000\000"
json='{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"name":"one","mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"buffers":[{"byteLength":44}],
"bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":6}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},
{"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}]}'
variant() {
    printf '%s' "$json" | sed "$1"
}

glb "$json" "$triangle" >in/good.glb
printf 'v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n' >in/edge_on.obj
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 1\nf 1 2 3\nf 1 2 4\n' >in/one_nan.obj
glb "$(variant 's/"name":"one"/"name":"one, two"/')" "$triangle" >in/comma.glb
printf 'o first\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\no second\nv 0 0 1\nv 1 0 1\nv 0 1 1\nf 4 5 6\n' >in/two.obj

: >in/empty.glb
: >in/empty.obj
: >in/empty.stl
mkdir in/folder.obj
head -c 100 in/good.glb >in/short.glb
head -c 10 in/good.glb >in/tiny.glb
echo 'This is no model at all.' >in/text.glb
echo 'This is no model at all.' >in/text.stl
echo 'This is no model at all.' >in/text.ply
echo 'This is no model at all.' >in/text.obj
echo 'This is no model at all.' >in/text.gltf
glb "$json" "$triangle" 2147483648 >in/claims_2g.glb
glb "$(variant 's/"byteLength":44/"byteLength":2147483648/')" "$triangle" >in/buffer_2g.glb
glb "$(variant 's/5126,"count":3/5126,"count":2147483647/')" "$triangle" >in/accessor_2g.glb
glb "$(variant 's/5123,"count":3/5123,"count":4294967295/')" "$triangle" >in/indices_4g.glb
glb "$(variant 's/"mesh":0/"mesh":0,"children":[0]/')" "$triangle" >in/cycle.glb
glb "$(variant 's/"mesh":0/"mesh":7/')" "$triangle" >in/no_such_mesh.glb
glb "$(variant 's/"bufferView":0/"bufferView":9/')" "$triangle" >in/no_such_view.glb
glb "$(variant 's/"nodes":\[0\]/"nodes":[]/')" "$triangle" >in/no_nodes.glb
glb "$json" "$nan_triangle" >in/all_nan.glb
glb "$json" "$far_triangle" >in/far_index.glb
{ awk 'BEGIN { for (i = 0; i < 200000; i++) printf "[" }'; } >in/nested.gltf
{ zeros 80 && little32 4294967295 && zeros 50; } >in/huge.stl
{ zeros 80 && little32 100 && zeros 50; } >in/short.stl
{ zeros 80 && little32 0; } >in/none.stl
{ zeros 80 && little32 2 && zeros 100; } >in/points.stl
printf 'solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0' >in/short_text.stl
printf 'solid x\nendsolid x\n' >in/none_text.stl
ply() {
    printf 'ply\nformat %s 1.0\nelement vertex %s\nproperty float x\nproperty float y\nproperty float z\n' "$1" "$2"
    printf 'element face %s\nproperty list uchar int vertex_indices\nend_header\n' "$3"
}
{ ply ascii 4000000000 1 && printf '0 0 0\n3 0 0 0\n'; } >in/huge.ply
{ ply binary_little_endian 2147483647 4294967295 && zeros 100; } >in/huge_binary.ply
{ ply ascii 1e400 1 && printf '0 0 0\n'; } >in/endless.ply
{ ply ascii 3 0 && printf '0 0 0\n1 0 0\n0 1 0\n'; } >in/points.ply
{ ply ascii 3 5 && printf '0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n'; } >in/short.ply
{ ply binary_little_endian 3 1000 && zeros 10000; } >in/short_binary.ply
{ ply ascii 3 1 && printf '0 0 0\n1 0 0\n0 1 0\n3 0 1 99\n'; } >in/far_index.ply
{ ply ascii 3 1 && printf '0 0 0\n1 0 0\n0 1 0\n2000000000 0 1 2\n'; } >in/huge_face.ply
printf 'ply\nformat ascii 1.0\nelement vertex 3\n' >in/no_end.ply
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\n' >in/no_faces.obj
printf 'v 0 0 0\nv 1 0 0\nl 1 2\n' >in/lines.obj
printf 'v nan nan nan\nv nan 0 0\nv 0 nan 0\nf 1 2 3\n' >in/all_nan.obj
printf 'v inf 0 0\nv 1 0 -inf\nv 0 inf 0\nf 1 2 3\n' >in/infinite.obj
printf 'v 0 0 0\nv 1 0 0\nf 1 2 999999999\nf -9 -8 -7\n' >in/far_index.obj
printf 'ISO-10303-21;\nHEADER;\nENDSEC;\n' >in/disguised.obj
printf 'ISO-10303-21;\nHEADER;\nENDSEC;\n' >in/part.step
printf 'ISO-10303-21;\nHEADER;\nENDSEC;\n' >in/part.STP
printf '%-72sS%7d\n' 'an IGES file' 1 >in/part.igs
printf '%-72sS%7d\n' 'an IGES file' 1 >in/disguised.dxf
echo 1 2 3 >in/points.xyz
echo 1 2 3 >in/no_extension
mkfifo in/pipe.obj

# ---- a blank picture, to tell others from --------------------------------------------------------------------

# A triangle seen from its edge covers no pixel, and no lines are drawn.
run in/edge_on.obj --size 64x48 --quality 1 --view 0,0 --lines none -o blank.png
check 'a picture without anything in it' [ "$status" -eq 0 ]
check 'a blank picture is a small file' [ "$(wc -c <blank.png)" -lt 2000 ]

# ---- broken files --------------------------------------------------------------------------------------------

broken() {
    refuses 1 "$2" "in/$1" -o out/picture.png
}
broken missing.obj 'in/missing.obj: No such file'
broken empty.glb 'is empty'
broken empty.obj 'is empty'
broken empty.stl 'is empty'
broken folder.obj 'is a folder'
broken pipe.obj 'is not a regular file'
broken short.glb 'cut short'
broken tiny.glb 'not a GLB'
broken text.glb 'not a GLB'
broken text.stl 'not an STL'
broken text.ply 'not a PLY'
broken text.obj 'in/text.obj: '
broken text.gltf 'in/text.gltf: '
broken claims_2g.glb '2147483648 bytes'
broken accessor_2g.glb 'in/accessor_2g.glb: '
broken indices_4g.glb 'in/indices_4g.glb: '
broken cycle.glb 'in/cycle.glb: '
broken no_such_mesh.glb 'in/no_such_mesh.glb: '
broken no_such_view.glb 'in/no_such_view.glb: '
broken no_nodes.glb 'no triangles'
broken all_nan.glb 'without NaN or infinite'
broken far_index.glb 'in/far_index.glb: '
broken nested.gltf 'in/nested.gltf: '
broken huge.stl '4294967295 triangles'
broken short.stl 'cut short'
broken none.stl 'in/none.stl: '
broken short_text.stl 'cut short'
broken none_text.stl 'in/none_text.stl: '
broken huge.ply 'cut short'
broken huge_binary.ply 'cut short'
broken endless.ply 'cut short'
broken points.ply 'in/points.ply: '
broken short.ply 'cut short'
broken short_binary.ply 'cut short'
broken far_index.ply 'in/far_index.ply: '
broken huge_face.ply 'in/huge_face.ply: '
broken no_end.ply 'header has no end'
broken no_faces.obj 'in/no_faces.obj: '
broken lines.obj 'in/lines.obj: '
broken all_nan.obj 'without NaN or infinite'
broken infinite.obj 'without NaN or infinite'
broken far_index.obj 'in/far_index.obj: '
broken part.step 'tessellate to glTF first'
broken part.STP 'tessellate to glTF first'
broken disguised.obj 'tessellate to glTF first'
broken part.igs 'tessellate to glTF first'
broken disguised.dxf 'tessellate to glTF first'
broken points.xyz 'no known kind'
broken no_extension 'no known kind'
for kind in obj glb gltf stl ply 3ds fbx dae x blend 3mf off dxf lwo ms3d md2 ifc; do
    head -c 5000 "$illustrate" >"in/program.$kind"
    broken "program.$kind" "in/program.$kind: "
done
refuses 1 'in/empty.obj: is empty' model:mug in/empty.obj -o out/picture.png

# Who may read everything cannot test that; another user can, where there is a way to be one.
nobody() {
    setpriv --reuid=65534 --regid=65534 --clear-groups "$@"
}
cp in/good.glb in/closed.glb
chmod 000 in/closed.glb
if [ "$(id -u)" -ne 0 ]; then
    broken closed.glb 'Permission denied'
elif command -v setpriv >/dev/null && nobody test -x "$illustrate" -a -r in; then
    nobody "$illustrate" in/closed.glb --list >stdout 2>stderr
    check 'a file that may not be read' [ $? -eq 1 ]
    check 'a file that may not be read: one line' one_line_on_stderr
    check 'a file that may not be read: what the line says' grep -q 'in/closed.glb: Permission denied' stderr
    nobody "$illustrate" in/good.glb -o out/picture.png >stdout 2>stderr
    check 'a folder that may not be written' [ $? -eq 1 ]
    check 'a folder that may not be written: what the line says' grep -q 'folder out: Permission denied' stderr
else
    echo 'skipped: files that may not be read, as root may read all'
fi

# ---- wrong usage ---------------------------------------------------------------------------------------------

wrong() {
    text=$1
    shift
    refuses 2 "$text" "$@"
}
wrong 'no model'
wrong 'no -o' model:mug
wrong 'no model' -o out/picture.png
wrong 'a value is missing' model:mug -o
wrong 'is it --opaque' model:mug --opaqe x -o out/picture.png
wrong 'no such option' model:mug --zzzzzzzzz -o out/picture.png
wrong 'no such option' model:mug -x -o out/picture.png
wrong 'takes no value' model:mug --ortho=yes -o out/picture.png
wrong 'is it model:gearbox' model:gerbox -o out/picture.png
wrong 'ends with .png' model:mug -o out/picture.jpg
for size in '' 5 5x x5 0x5 5x0 -5x5 +5x5 5x5x5 16385x1 1x16385 1e3x10 0x10x10 5.0x5 ' 5x5' 99999999999999999999x1; do
    wrong 'WxH' model:mug -o out/picture.png --size "$size"
done
for view in '' 10 '10,' ,10 a,b nan,0 inf,0 0,91 0,-91 0x10,0 10,20,30 '1 0,0' 1e999,0; do
    wrong 'AZIMUTH,ELEVATION' model:mug -o out/picture.png --view "$view"
done
for quality in '' 0 9 2x 1.5 -1 nan; do
    wrong 'from 1 to 8' model:mug -o out/picture.png --quality "$quality"
done
for k in '' -1 nan inf 2x 1001; do
    wrong 'from 0 to 1000' model:mug -o out/picture.png --k "$k"
done
for n in '' 0 5 -1 2.5 x; do
    wrong 'from 1 to 4' model:mug -o out/picture.png --alpha-quality "$n"
done
for weights in '' 1 '1,' 2,0 0,2 -1,0 nan,nan; do
    wrong 'OPAQUE,BACKGROUND' model:mug -o out/picture.png --weights "$weights"
done
for background in '' red fff fffffff gggggg '#' 0xffffff; do
    wrong 'RRGGBB' model:mug -o out/picture.png --background "$background"
done
wrong 'there are auto, hodges, lines, opaque, glass, smart and curvature' model:mug -o out/picture.png --style nice
wrong 'cool-to-warm and flat' model:mug -o out/picture.png --shade dark
wrong 'over, normalised and published' model:mug -o out/picture.png --blend under
wrong 'auto, implicit, explicit and published' model:mug -o out/picture.png --interior none
wrong 'layers:N with a whole number from 1 to 8' model:mug -o out/picture.png --interior layers:9
wrong 'layers:N with a whole number from 1 to 8' model:mug -o out/picture.png --interior layers:
for law in '' thin constant: adaptive:0 adaptive:1.5 adaptive:x constant:0.3:2; do
    wrong 'not constant or adaptive' model:mug -o out/picture.png --glass "$law"
done
for law in '' thin constant: angle:0 adaptive:1.5 distance:x; do
    wrong 'not given, constant, adaptive' model:mug -o out/picture.png --law "$law"
done
for n in '' 501 -1 2.5 x 0x10 '1 ' 99999999999999999999; do
    wrong 'from 0 to 500' model:mug -o out/picture.png --iterations "$n"
done
for n in '' -1 501 x nan inf 1e999 0x1p3; do
    wrong 'from 0 to 500' model:mug -o out/picture.png --halo "$n"
done
wrong 'no silhouettes for --law distance' model:mug -o out/picture.png --law distance --iterations 0
wrong 'mutual, murray, one-sided and carnecky' model:mug -o out/picture.png --neighbours both
for word in '' apparent none:1 suggestive: suggestive:0 suggestive:x suggestive:1e7; do
    wrong 'none, suggestive and suggestive:LEAST' model:mug -o out/picture.png --contours "$word"
done
for word in '' dull convex, ,deep; do
    wrong 'not known; there are convex, curved, front, deep and a FILE.png' model:mug -o out/picture.png --transfer "$word"
done
: >in/empty.png
echo 'This is no picture at all.' >in/text.png
printf '\211PNG\r\n\032\n' >in/cut.png
printf '\211PNG\r\n\032\n\000\000\000\015IHDR\000\000\001\000\000\000\000\001\010\002\000\000\000\000\000\000\000' >in/no_pixels.png
printf '\211PNG\r\n\032\n\000\000\000\015IHDR\000\000\100\000\000\000\100\000\010\006\000\000\000\000\000\000\000' >in/huge.png
mkdir in/table.png
mkfifo in/pipe.png
for table in 'missing cannot be read: No such file' 'empty not an image' 'text not an image' 'cut not an image' \
    'no_pixels cut short or broken' 'huge 16384 x 16384 pixels' 'table is not a regular file' 'pipe is not a regular file'; do
    refuses 1 "in/${table%% *}.png: ${table#* }" model:mug -o out/picture.png --transfer "in/${table%% *}.png"
done
rmdir in/table.png
for style in hodges opaque glass smart curvature; do
    wrong 'an SVG has lines alone' model:mug -o out/picture.svg --style "$style"
done
wrong 'no such part' model:mug -o out/picture.png --group spoon
wrong 'names no part' model:mug -o out/picture.png --group ,
wrong 'not a positive number' model:mug -o out/picture.png --group-distance 0
wrong 'not a number from 0 to 1' model:mug -o out/picture.png --enter 1.5
wrong 'y and z' model:mug -o out/picture.png --up x
wrong 'not known' model:mug -o out/picture.png --lines wrinkles
wrong 'not known' model:mug -o out/picture.png --lines ''
wrong 'not known' model:mug -o out/picture.png --lines silhouettes,
wrong 'another kind' model:mug -o out/picture.png --lines none,creases
wrong 'another way to weigh' model:mug -o out/picture.png --lines outer,light
wrong 'an SVG has lines alone' model:mug -o out/picture.svg --lines light
wrong 'an SVG has lines alone' model:mug -o out/picture.svg --lines perspective
wrong 'an SVG has lines alone' model:mug -o out/picture.svg --style hodges
wrong 'an SVG has lines alone' model:mug -o out/picture.svg --explain
wrong 'number of pixels' model:mug -o out/picture.png --lines silhouettes:
wrong 'number of pixels' model:mug -o out/picture.png --lines silhouettes:0
wrong 'number of pixels' model:mug -o out/picture.png --lines silhouettes:2px
wrong 'nearest: mug/box' model:mug -o out/picture.png --hide bux
wrong 'nearest: gearbox/housing, ' model:gearbox -o out/picture.png --transparent gearbox/hosing
wrong 'nearest: gearbox/shaft_in, ' model:gearbox -o out/picture.png --transparent shaft_im
wrong 'no such part' model:mug -o out/picture.png --opaque 'z*'
wrong 'names no part' model:mug -o out/picture.png --hide ''
wrong 'nothing to draw' model:mug -o out/picture.png --hide '*'
refuses 1 'folder out/nowhere' model:mug -o out/nowhere/picture.png
mkdir in/folder.png
refuses 1 'is a folder' model:mug -o in/folder.png

# ---- what works ----------------------------------------------------------------------------------------------

run --help
check '--help' [ "$status" -eq 0 ]
for option in output style size view ortho transparent opaque hide list lines shade background k blend weights \
    interior group group-distance enter quality up gles explain verbose version law iterations halo transfer glass neighbours contours; do
    check "--help names --$option" grep -q -e "--$option" stdout
done
run --version
check '--version' [ "$status" -eq 0 ]
check '--version: what it says' grep -q '^illustrate [0-9]' stdout
run model:gearbox --list
check '--list' [ "$status" -eq 0 ]
check '--list: a path' grep -q '  gearbox/shaft_in/gear_3$' stdout
check '--list: bolts share a mesh' grep -q ' 28  closed   gearbox/housing/bolt_front_1$' stdout
run in/two.obj --list
check '--list: parts of a file' [ "$(grep -c -e '  first$' -e '  second$' stdout)" -eq 2 ]
check '--list: one triangle is open' grep -q ' 1       1  open     first$' stdout
run in/two.obj in/good.glb --list
check 'parts of several files have the name of their file' grep -q '  two/second$' stdout
check 'and those of a GLB, too' grep -q '  good/one$' stdout
run in/two.obj in/two.obj --list
check 'a name that is there twice gets a number' grep -q '  two/first#2$' stdout
run in/comma.glb --list
check 'no comma in the name of a part' grep -q '  one_ two$' stdout
if [ -e /dev/full ]; then
    "$illustrate" model:mug --list >/dev/full 2>stderr
    check 'standard output that is full' [ $? -eq 1 ]
fi

draws 64 48 in/good.glb
draws 64 48 in/buffer_2g.glb # what is used of the buffer is there
draws 64 48 in/one_nan.obj
run in/one_nan.obj --size 64x48 -o out/picture.png
check 'a triangle with NaN is left out, and said so' grep -q '1 triangles with NaN' stderr
rm -f out/*
draws 1 1 model:mug --background 000000
draws 97 53 model:crank
draws 64 48 model:mug in/two.obj
draws 64 48 -- in/two.obj
draws 64 48 --view=-400.5,-90 --ortho model:mug
for extra in '--style hodges' '--style lines' '--style opaque' '--lines all:3' '--lines none' '--shade flat' \
    '--background none' '--background #102030' '--k 2' '--blend over' '--blend normalised' '--blend published' \
    '--weights 0.7,0.3' \
    '--interior implicit' '--interior explicit' '--interior layers:3' '--group mug,box' '--enter 0.5' '--interior published' '--gles' '--hide box' '--opaque mug' \
    '--transparent mug/box' '--hide b?x --opaque *y'; do
    set -f
    draws 64 48 model:mug $extra
    set +f
done
run model:mug --size 64x48 --explain -o out/picture.png
check '--explain' [ "$status" -eq 0 ]
check '--explain writes JSON' python3 -m json.tool stdout parsed
printf 'o caf\351 "\\"\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >in/latin1.obj
# Glass shows all layers of nested parts: more in a pixel than a shell alone has, and another picture; the way out is named
# where the context is too old.
run model:shells --size 64x48 --quality 1 --style glass --explain -o out/glass.png
check '--style glass' [ "$status" -eq 0 ]
check '--style glass finds the layers' grep -q '"glass": .*"deepest": \([6-9]\|[1-9][0-9]\)' stdout
run model:shells --size 64x48 --quality 1 --style hodges -o out/hodges.png
check '--style glass differs from hodges' sh -c '! cmp -s out/glass.png out/hodges.png'
run model:shells --size 64x48 --quality 1 --style glass --glass adaptive -o out/adaptive.png
check '--glass adaptive' [ "$status" -eq 0 ]
check '--glass adaptive differs from constant' sh -c '! cmp -s out/glass.png out/adaptive.png'
run model:torus_knot --transparent torus_knot --size 64x48 --quality 1 --style glass -o out/glass.png
run model:torus_knot --transparent torus_knot --size 64x48 --quality 1 --style glass --glass constant:0.3 -o out/constant.png
check '--glass constant:0.3 is the default' cmp -s out/glass.png out/constant.png
run model:torus_knot --transparent torus_knot --size 64x48 --quality 1 --style glass --glass constant:0.6 -o out/constant.png
check '--glass constant takes an opacity' sh -c '! cmp -s out/glass.png out/constant.png'
run model:torus_knot --transparent torus_knot --size 64x48 --quality 1 --style glass --glass adaptive -o out/adaptive.png
run model:torus_knot --transparent torus_knot --size 64x48 --quality 1 --style glass --glass adaptive:0.2 -o out/constant.png
check '--glass adaptive takes an opacity' sh -c '! cmp -s out/adaptive.png out/constant.png'
rm -f out/adaptive.png out/constant.png
run model:shells --size 64x48 --quality 1 --style glass --gles -o out/gles.png
check '--style glass --gles' [ "$status" -eq 0 ]
rm -f out/glass.png out/hodges.png out/gles.png
timeout "$limit" env MESA_GL_VERSION_OVERRIDE=3.3 MESA_GLSL_VERSION_OVERRIDE=330 \
    "$illustrate" model:shells --size 64x48 --style glass -o out/old.png >stdout 2>stderr </dev/null
if [ $? -ne 0 ]; then # a driver that does not heed the override draws it
    check '--style glass on an old context says what needs less' grep -q 'style hodges needs less' stderr
    check '--style glass on an old context says one line' one_line_on_stderr
    check '--style glass on an old context leaves nothing' [ ! -e out/old.png ]
fi
# Smart transparency and curvature, of single surfaces too; each option makes another picture.
for style in smart curvature; do
    run model:stream_surface --size 64x48 --quality 1 --style "$style" --explain -o "out/$style.png"
    check "--style $style" [ "$status" -eq 0 ]
    check "--style $style says nothing" [ ! -s stderr ]
    check "--style $style says so" grep -q "\"style\": \"$style\"" stdout
    check "--style $style makes a single surface transparent" grep -q '"deepest": [2-9]' stdout
    for law in given constant angle variation distance adaptive:0.9; do
        run model:stream_surface --size 64x48 --quality 1 --style "$style" --law "$law" --transfer convex -o out/law.png
        check "--style $style --law $law" [ "$status" -eq 0 ]
        check "--style $style --law $law differs" sh -c '! cmp -s out/law.png "out/$0.png"' "$style"
    done
done
run model:stream_surface --size 64x48 --quality 1 --style smart --law adaptive:0.6 --iterations 20 --halo 5 -o out/law.png
check '--style smart: defaults' cmp -s out/law.png out/smart.png
run model:stream_surface --size 64x48 --quality 1 --style curvature --transfer convex,deep -o out/law.png
check '--style curvature: defaults' cmp -s out/law.png out/curvature.png
for option in '--iterations 5' '--iterations 0' '--halo 0' '--halo 0.3' '--halo 12' '--lines all' '--neighbours one-sided' \
    '--neighbours carnecky' '--neighbours murray'; do
    run model:stream_surface --size 64x48 --quality 1 --style smart $option -o out/law.png
    check "--style smart $option" [ "$status" -eq 0 ]
    check "--style smart $option differs" sh -c '! cmp -s out/law.png out/smart.png'
done
for words in curved front curved,front deep; do
    run model:stream_surface --size 64x48 --quality 1 --style curvature --transfer "$words" -o out/law.png
    check "--transfer $words" [ "$status" -eq 0 ]
    check "--transfer $words differs" sh -c '! cmp -s out/law.png out/curvature.png'
done
for style in smart curvature; do
    run model:mug --size 64x48 --quality 1 --style "$style" -o out/law.png
    run model:mug --size 64x48 --quality 1 --style "$style" --contours suggestive -o out/lined.png
    check "--style $style --contours suggestive" [ "$status" -eq 0 ]
    check "--style $style --contours suggestive differs" sh -c '! cmp -s out/law.png out/lined.png'
    run model:mug --size 64x48 --quality 1 --style "$style" --contours none -o out/lined_too.png
    check "--style $style --contours none is the default" cmp -s out/law.png out/lined_too.png
    run model:mug --size 64x48 --quality 1 --style "$style" --contours suggestive:1 -o out/lined_too.png
    check "--style $style --contours suggestive:1 is suggestive" cmp -s out/lined.png out/lined_too.png
    run model:mug --size 64x48 --quality 1 --style "$style" --contours suggestive:0.1 -o out/lined_too.png
    check "--style $style --contours suggestive:0.1 has faint ones" sh -c '! cmp -s out/lined.png out/lined_too.png'
done
rm -f out/lined.png out/lined_too.png
run model:mug --size 1x8 --style opaque --background 800000 --view 0,89 -o out/table.png
run model:stream_surface --size 64x48 --quality 1 --style curvature --transfer out/table.png -o out/law.png
check '--transfer FILE.png' [ "$status" -eq 0 ]
check '--transfer FILE.png differs' sh -c '! cmp -s out/law.png out/curvature.png'
run model:stream_surface --size 16x16 --style curvature --transfer out/none.png -o out/picture.png
check '--transfer of no file fails' [ "$status" -eq 1 ]
check '--transfer of no file says so' grep -q 'none.png: cannot be read' stderr
cp in/latin1.obj in/table.png
run model:stream_surface --size 16x16 --style curvature --transfer in/table.png -o out/picture.png
check '--transfer of no image fails' [ "$status" -eq 1 ]
check '--transfer of no image says so' grep -q 'not an image' stderr
run model:klein_bottle --size 32x32 --quality 1 --style smart --gles -o out/gles.png
check '--style smart --gles' [ "$status" -eq 0 ]
rm -f out/smart.png out/curvature.png out/law.png out/gles.png out/table.png in/table.png
for passes in 'smart store link law smart compose' 'curvature store link law curvature compose' 'glass store compose'; do
    style=${passes%% *}
    run model:squares --size 32x32 --quality 1 --style "$style" --explain -o out/picture.png
    named=$(sed -n 's/.*"pass": "\([a-z]*\)".*/\1/p' stdout | tr '\n' ' ')
    check "--explain --style $style names its passes: $named" [ "$named" = "${passes#* } " ]
done
run model:squares --size 32x32 --quality 1 --style smart --iterations 0 --explain -o out/picture.png
check '--iterations 0: the law alone' [ "$(grep -c '"pass": "smart"' stdout)" -eq 0 ]
run model:squares --size 32x32 --quality 1 --style curvature --law distance --explain -o out/picture.png
check '--law distance finds silhouettes first' [ "$(grep -c '"pass": "smart"' stdout)" -eq 1 ]

# A surface that rolls up is smart of itself; not where something else is wished, or there are two, or the context is old.
for model in stream_surface klein_bottle; do
    run "model:$model" --size 32x32 --quality 1 --explain -o out/picture.png
    check "--style auto of $model" grep -q '"style": "smart"' stdout
done
cp out/picture.png bottle.png
run model:klein_bottle --size 32x32 --quality 1 --style smart -o out/picture.png
check '--style auto draws what smart draws' cmp -s out/picture.png bottle.png
for other in 'opaque model:klein_bottle --opaque klein_bottle' 'hodges model:klein_bottle model:squares' \
    'opaque model:torus_knot' 'opaque in/good.glb'; do
    run ${other#* } --size 32x32 --quality 1 --explain -o out/picture.png
    check "--style auto of ${other#* } is ${other%% *}" grep -q "\"style\": \"${other%% *}\"" stdout
done
timeout "$limit" env MESA_GL_VERSION_OVERRIDE=3.3 MESA_GLSL_VERSION_OVERRIDE=330 \
    "$illustrate" model:klein_bottle --size 32x32 --quality 1 --explain -o out/picture.png >stdout 2>stderr </dev/null
check '--style auto on an old context draws' [ $? -eq 0 ]
check '--style auto on an old context says nothing' [ ! -s stderr ]
rm -f out/* bottle.png

# What is in front hides a surface, and does not end it: beside an opaque part a sheet is as it is elsewhere.
{ sheet glass 0 10 && sheet plug -1 2; } >in/plug.obj
front='--up z --view 0,0 --ortho --size 200x200 --quality 1'
for style in smart curvature; do
    run in/plug.obj $front --style "$style" --law constant --transparent glass --opaque plug -o out/picture.png
    check "--style $style: no rim around what is in front" \
        [ "$(pixel out/picture.png 81 100)" = "$(pixel out/picture.png 60 60)" ]
    check "--style $style: and what is in front is seen" \
        [ "$(pixel out/picture.png 84 100)" != "$(pixel out/picture.png 60 60)" ]
done

# A black line behind two sheets of opacity 0.3 takes 0.49 of the paper's white from what is seen there without it.
corners=0
{ sheet first -4 10 && sheet second -2 10 && sheet last 0 2; } >in/lines.obj
for style in smart 'smart --gles' glass; do
    law='--law constant:0.3'
    [ "$style" != glass ] || law='--glass constant:0.3'
    run in/lines.obj $front --style $style $law --transparent '*' --lines boundaries:6 -o out/picture.png
    set -- $(pixel out/picture.png 60 60) $(pixel out/picture.png 82 100)
    for channel in 1 2 3; do
        check "--style $style: a line behind two sheets: $*" [ $(($1 - $4)) -ge 124 -a $(($1 - $4)) -le 126 ]
        shift
        set -- "$@" x
    done
done

# More fragments than a block of Mesa's software driver holds: smaller tiles, and the same picture but for where they meet.
corners=0
for depth in 0 1 2 3 4 5; do sheet "s$depth" "$depth" 10; done >in/deep.obj
run in/deep.obj --up z --view 0,0 --ortho --size 1200x1200 --quality 1 --style smart --law constant --iterations 1 --halo 0 \
    --transparent '*' --explain -o out/picture.png
check 'more fragments than a block holds' [ "$status" -eq 0 ]
check 'more fragments than a block holds: nothing is said' [ ! -s stderr ]
check 'they are drawn in tiles' grep -q '"tiles": [1-9]' stdout
check 'alike in all of them' [ "$(pixel out/picture.png 300 300)" = "$(pixel out/picture.png 900 700)" ]
rm -f out/*
run in/latin1.obj --transparent '*' --size 16x16 --explain -o out/picture.png
check '--explain writes JSON for any name' python3 -m json.tool stdout parsed
rm -f out/*
run model:mug --size 64x48 --verbose -o out/picture.png
check '--verbose says by which platform' grep -q 'platform' stderr
cp out/picture.png before.png
run in/empty.obj -o out/picture.png
check 'a failed run leaves an older picture as it was' cmp -s out/picture.png before.png
run model:mug --hide box --size 64x48 -o out/picture.png
check 'a picture takes the place of an older one' [ "$status" -eq 0 ]
check 'without the box it is another' sh -c '! cmp -s out/picture.png before.png'
ln -s picture.png out/link.png
run model:mug --size 64x48 -o out/link.png
check 'a link stays a link' [ -L out/link.png ]
check 'and what it points to is the picture' cmp -s out/picture.png before.png
rm -f out/*
run model:mug --size 16x16 -o /dev/null
check 'a device stays a device' [ "$status" -eq 0 -a -c /dev/null ]

# ---- options that change the picture, and scenes that do not -------------------------------------------------

# differs ARGUMENTS...: from the picture of model:crank by itself
run model:crank --size 96x72 -o plain.png
differs() {
    run model:crank --size 96x72 -o other.png "$@"
    check "another picture by $*" sh -c '! cmp -s plain.png other.png'
}
differs --k 2
differs --blend normalised
differs --blend normalised --weights 0.2,0.9
differs --interior explicit
differs --shade flat
differs --lines none
differs --lines silhouettes:3
differs --lines thick-thin
differs --lines outer
differs --lines perspective
differs --lines light
differs --lines phantom
differs --lines hidden --style lines
differs --ortho
differs --view 80,5
differs --quality 1
differs --style lines
differs --style opaque
differs --background 808080
differs --opaque cylinder
differs --hide shaft
differs --transparent shaft

run model:torus_knot --size 96x72 -o plain.png
run model:torus_knot --size 96x72 --lines smooth -o other.png
check 'another picture by --lines smooth' sh -c '! cmp -s plain.png other.png'

# ---- SVG -------------------------------------------------------------------------------------------------------

# svg_has COUNT PATTERN: so many lines of out.svg, which has to be XML, match
svg_has() {
    check "out.svg is XML ($2)" python3 -c 'import xml.dom.minidom; xml.dom.minidom.parse("out.svg")'
    check "out.svg has $1 of $2" [ "$(grep -c "$2" out.svg)" -eq "$1" ]
}
run model:crank -o out.svg
check 'SVG' [ "$status" -eq 0 ]
svg_has "$(run model:crank --list && grep -c / stdout)" 'class="part"'
svg_has 0 'dasharray'
check 'SVG has lines' [ "$(grep -c '<path' out.svg)" -gt 5 ]
paths=$(grep -c '<path' out.svg)
run model:crank --lines hidden -o out.svg
check 'hidden lines are more' [ "$(grep -c '<path' out.svg)" -gt "$paths" ]
check 'and dashed' [ "$(grep -c 'class="hidden".*dasharray' out.svg)" -gt 10 ]
run model:crank --lines phantom -o out.svg
svg_has 1 'class="part".*dasharray'
check 'what is in a phantom is seen' [ "$(grep -c '<path' out.svg)" -gt "$paths" ]
run model:crank --lines none --background none -o out.svg
svg_has 0 '<path'
svg_has 0 '<rect'
run model:crank --lines outer:2 -o out.svg
check 'outer lines are twice as wide' grep -q '<path.*stroke-width="4"' out.svg
run in/latin1.obj -o out.svg
svg_has 1 '<title>caf&#233;</title>'
rm -f out.svg

# A box around a pyramid, all coordinates small whole numbers plus the offset: exact in floats.
box_at() {
    awk -v o="$1" 'BEGIN {
        split("0 0 0 4 0 0 4 4 0 0 4 0 0 0 4 4 0 4 4 4 4 0 4 4 1 1 1 3 1 1 3 3 1 1 3 1 2 2 3", c, " ")
        print "o case"
        for (i = 1; i <= 13; i++) printf "v %d %d %d\n", c[3*i-2] + o, c[3*i-1] + o, c[3*i] + o
        print "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8"
        print "o core\nf 9 12 11 10\nf 9 10 13\nf 10 11 13\nf 11 12 13\nf 12 9 13"
    }'
}
mkdir -p near_here far_away
box_at 0 >near_here/box.obj
box_at 1000000 >far_away/box.obj
run near_here/box.obj --size 160x120 -o near.png
run far_away/box.obj --size 160x120 -o far.png
check 'a scene a million units away looks the same' cmp -s near.png far.png
run near_here/box.obj --size 160x120 --explain -o near.png
check 'what encloses something is transparent' grep -q '"transparent": \["case"\]' stdout
run near_here/box.obj --size 160x120 --explain --transparent core -o near.png
check 'and stays so when another part is asked for' grep -q '"transparent": \["case", "core"\]' stdout

# ---- every model ---------------------------------------------------------------------------------------------

for name in mug crank gearbox torus_knot shells squares cylinders cube_and_sphere klein_bottle stream_surface dirty_open dirty_doubled dirty_degenerate dirty_nonmanifold \
    dirty_flipped; do
    draws 64 48 "model:$name"
done
if [ -d "$models" ]; then
    find "$models" -type f | sort >files
    while IFS= read -r file; do
        case $file in
        *.glb | *.gltf | *.obj | *.ply | *.stl | *.STL | *.3ds) draws 64 48 "$file" ;;
        esac
    done <files
else
    echo "skipped: real models, as there is no $models"
fi

cd / && rm -rf "$OLDPWD"
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ]
