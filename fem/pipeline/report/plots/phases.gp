# Torque of friction by the place of the mark of the {{marked}}, at rest and at the mean spin in the long run; over a
# whole turn this repeats.
#@one_way
load "figures/style.gnuplot"
eval from_csv

# phases.csv: 1 and 2: marks of the glass and of the table, 3: torque at rest, 4: at the mean spin
data = "phases.csv"
of_glass = marked eq "glass"
set xlabel "θ from the direction of travel (degrees)"
set ylabel "torque τ_{z} (mN m)"
set xzeroaxis lt 8
set key width 0
plot data using (column(of_glass ? 1 : 2) * 180 / pi):(1e3 * $3) with points title "at rest", \
     data using (column(of_glass ? 1 : 2) * 180 / pi):(1e3 * $4) with points title "at the mean spin"
