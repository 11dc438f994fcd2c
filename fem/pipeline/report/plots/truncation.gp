# What leaving out the harmonics beyond some number does to the terminal spin.
#@one_way
load "figures/style.gnuplot"
eval from_csv

data = "truncation.csv"
change_column = {{columns.truncation.relative_change}}
change(c) = abs(column(c)) > rounding ? abs(column(c)) : NaN # smaller ones say nothing
eval find_extent("change(change_column) > 0 ? $1 : NaN")
set xlabel "harmonics kept"
set ylabel "|Δω / ω|"
eval set_logarithmic("y")
if (n_found > 0 && high <= 8) {
  set xtics 1
  set autoscale xfix; set offsets graph 0.05, graph 0.05
}
if (n_found > 0) {
  plot data using (change(change_column) > 0 ? $1 : NaN):(change(change_column)) with linespoints lt 1 \
         title "terminal spin, relative change"
} else {
  eval plot_nothing
}
