# Where the energy goes: the sum of both is that of the push.
load "figures/style.gnuplot"
eval from_csv
set xlabel "t (s)"
set ylabel "energy (mJ)"
plot "path.csv" using 1:(1e3 * $14) with lines title "kinetic energy", \
     "path.csv" using 1:(1e3 * $15) with lines title "friction loss", \
     "path.csv" using 1:(1e3 * ($14 + $15)) with lines title "sum"
