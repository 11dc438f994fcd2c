# Scaled Jacobians of the cells: 1 is a brick, below 0.1 stresses nearby are poor.
#@data quality
height = 300
load "figures/style.gnuplot"

set xlabel "scaled Jacobian"; set ylabel "cells"
set xrange [0:1]; set yrange [0:*]
unset key
set boxwidth 0.9 relative; set style fill solid noborder
plot data using 1:2 with boxes lt 1
