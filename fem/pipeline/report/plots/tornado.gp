# Change of the {{what}} by one standard deviation of each parameter, from a linear fit of the samples
#@data sweep_{{plot}}
#@one_way
height = 120 + 40 * n_row
load "figures/style.gnuplot"

# 1: change when a parameter goes up, from below
eval find_extent("abs($1)")
set xlabel x_label
eval set_few_tics("x", -high, high)
set ytics (); set for [i=1:n_row] ytics add (row[i] i)
set yrange [0.4:n_row + 0.6]
unset border; set border 1; set grid noytics; set xzeroaxis; set yzeroaxis lt 7
set key at screen 0.98, screen 0.97 right top horizontal width 1; set tmargin 3
set style fill solid noborder
plot data using (0):($0 + 1):(0):(-$1):($0 + 0.65):($0 + 1.35) with boxxyerror lt 1 title "parameter down", \
     data using (0):($0 + 1):(0):1:($0 + 0.65):($0 + 1.35) with boxxyerror lt 2 title "parameter up"
