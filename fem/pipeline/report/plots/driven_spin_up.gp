# The spin under the hand's own speed, beside that at constant speed.
#@one_way
load "figures/style.gnuplot"
eval from_csv
set xlabel "t (s)"
set ylabel "ω (rad/s)"
set xzeroaxis lt 8
plot "driven_spin_up.csv" using 1:4 with lines title "v(t)", "spin_up.csv" using 1:2 with lines title "constant v"
