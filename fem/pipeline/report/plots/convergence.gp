# Distance of the terminal spin from its limit on each axis, relative, by level; 0 is the study's own level. Levels that agree
# with the limit to the tolerance of the solver are not drawn.
load "figures/style.gnuplot"
eval from_csv

data = "converge.csv" # 1: axis, 2: level
distance(i) = abs(column(spin_column) - limit[i])
error(i) = strcol(1) eq axis[i] && distance(i) > rounding ? distance(i) / abs(limit[i]) : NaN
set xlabel "level, finer to the right"
set ylabel "relative error"
eval set_logarithmic("y")
set xtics 1
set autoscale xfix; set offsets graph 0.05, graph 0.05
any(x) = x > 0 ? x : 0
eval find_count("any(error(1)) + any(error(n_curve)) + any(error(n_curve > 1 ? 2 : 1)) > 0")
if (n_found > 0) {
  plot for [i=1:n_curve] data using (error(i) > 0 ? $2 : NaN):(error(i)) with linespoints lt i title curve[i]
} else {
  eval plot_nothing
}
