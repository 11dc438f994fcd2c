# The path of the centre with its sideways part enlarged; y is to the left of the push.
load "figures/style.gnuplot"
eval from_csv
set xlabel "x (mm)"
set ylabel "y (mm)"
set xzeroaxis lt 8
plot "path.csv" using (1e3 * $2):(1e3 * $3) with lines notitle
