# Speed v of the centre and ωR of the rim: both end at the same instant unless one of them ends first.
radius = {{slide.body.outer_radius}}
load "figures/style.gnuplot"
eval from_csv
set xlabel "t (s)"
set ylabel "speed (m/s)"
set xzeroaxis lt 8
set key width 1
plot "path.csv" using 1:4 with lines title "v", "path.csv" using 1:($7 * radius) with lines title "ωR"
