# gnuplot -c bench/silhouette.gp build/bench/silhouette.csv build/bench/silhouette.png
# Milliseconds a view against edges, both logarithmic, from the table of bench/silhouette.c (moving perspective eye).
if (ARGC != 2) {
    print "usage: gnuplot -c bench/silhouette.gp TABLE.csv PICTURE.png"
    exit status 2
}
rows(scene, subject) = sprintf("< awk -F, '$1 == \"extract\" && $2 == \"%s\" && $4 == \"%s\"' %s", scene, subject, ARG1)
set datafile separator ","
set terminal pngcairo size 900,640 font "sans,11"
set output ARG2
set logscale xy
set xlabel "edges"
set ylabel "milliseconds a view"
set key outside right noenhanced
set grid
scenes = "torus blob shaft box rough_blob"
plot for [i = 1:words(scenes)] rows(word(scenes, i), "published") using 3:5 with linespoints lt i dt 3 title word(scenes, i) . ", published", \
     for [i = 1:words(scenes)] rows(word(scenes, i), "brute") using 3:5 with linespoints lt i dt 2 title word(scenes, i) . ", flat scan", \
     for [i = 1:words(scenes)] rows(word(scenes, i), "hierarchy") using 3:5 with linespoints lt i lw 2 title word(scenes, i) . ", hierarchy"
