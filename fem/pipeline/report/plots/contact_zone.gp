# The faces of the contact zone, seen from above.
#@data contact_zone
height = 540
load "figures/style.gnuplot"

set size ratio -1
set xlabel "x (mm)"; set ylabel "y (mm)"
eval find_extent("larger(abs($1), abs($2))"); reach = larger(1, 1.05 * high)
set xrange [-reach:reach]; set yrange [-reach:reach]
unset key
plot data with lines lt 1 lw 0.8
