# The speed of the hand.
#@one_way
load "figures/style.gnuplot"
eval from_csv
set xlabel "t (s)"
set ylabel "v (m/s)"; set yrange [0:*]
set key width 1
plot "driven_spin_up.csv" using 1:2 with lines notitle
