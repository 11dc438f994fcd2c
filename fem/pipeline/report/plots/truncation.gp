# {{#bound_scale}}What is missing in the terminal spin when the load is truncated, relative to all
# harmonics.{{/bound_scale}}{{^bound_scale}}What leaving out the harmonics beyond some number does to the terminal
# spin.{{/bound_scale}}
#@one_way
load "figures/style.gnuplot"
eval from_csv

data = "truncation.csv"
change_column = {{columns.truncation.relative_change}}
bound_column = {{columns.truncation.bound}}
has_scale = bound_scale == bound_scale
change(c) = abs(column(c)) > rounding ? abs(column(c)) : NaN # smaller ones say nothing
bound(c) = has_scale && column(c) > rounding * bound_scale ? column(c) / bound_scale : NaN
eval find_count("bound(bound_column) > 0"); has_bound = n_found > 0
eval find_extent("change(change_column) > 0 ? $1 : NaN")
set xlabel "harmonics kept"
set ylabel "|Δω / ω|"
eval set_logarithmic("y")
if (!has_scale && n_found > 0 && high <= 8) {
  set xtics 1
  set autoscale xfix; set offsets graph 0.05, graph 0.05
}
if (n_found > 0 || has_bound) {
  plot data using (change(change_column) > 0 ? $1 : NaN):(change(change_column)) with linespoints lt 1 \
         title "terminal spin, relative change", \
       data using (bound(bound_column) > 0 ? $1 : NaN):(bound(bound_column)) with lines lt 2 \
         title has_scale ? "a-priori bound, to first order" : ""
} else {
  eval plot_nothing
}
