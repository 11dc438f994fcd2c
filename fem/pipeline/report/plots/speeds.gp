# Speed v of the centre and ωR of the rim: both end at the same instant unless one of them ends first.
load "figures/style.gnuplot"
set xlabel "t (s)"
set ylabel "speed (m/s)"
set xzeroaxis lt 8
set key width 1
plot "path.dat" using 1:4 with lines title "v", "path.dat" using 1:($7 * radius) with lines title "ωR"
