# The spin under the hand's own speed, beside that at constant speed.
load "figures/style.gnuplot"
set xlabel "t (s)"
set ylabel "ω (rad/s)"
set xzeroaxis lt 8
plot "driven_spin_up.dat" using 1:4 with lines title "v(t)", "spin_up.dat" using 1:2 with lines title "constant v"
