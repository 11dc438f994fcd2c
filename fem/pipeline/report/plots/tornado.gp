height = 120 + 40 * n_row
load "figures/style.gnuplot"

# 1: place from below, 2: change when the parameter goes down, 3: when it goes up
eval find_extent("larger(abs($2), abs($3))")
set xlabel x_label
eval set_few_tics("x", -high, high)
set ytics (); set for [i=1:n_row] ytics add (row[i] i)
set yrange [0.4:n_row + 0.6]
unset border; set border 1; set grid noytics; set xzeroaxis; set yzeroaxis lt 7
set key at screen 0.98, screen 0.97 right top horizontal width 1; set tmargin 3
set style fill solid noborder
plot data using (0):1:(0):2:($1 - 0.35):($1 + 0.35) with boxxyerror lt 1 title "parameter down", \
     data using (0):1:(0):3:($1 - 0.35):($1 + 0.35) with boxxyerror lt 2 title "parameter up"
