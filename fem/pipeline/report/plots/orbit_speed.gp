# The speed of the hand.
load "figures/style.gnuplot"
set xlabel "t (s)"
set ylabel "v (m/s)"; set yrange [0:*]
set key width 1
plot "driven_spin_up.dat" using 1:2 with lines notitle
