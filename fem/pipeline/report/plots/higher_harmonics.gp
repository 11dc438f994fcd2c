# What the harmonics beyond the first add to the load, relative to its mean a_0; n harmonics kept.
n_all = {{rim_load.n_all}}; is_pointwise = {{rim_load.is_pointwise}}
a_1 = {{rim_load.a_1}}; b_1 = {{rim_load.b_1}}
load "figures/style.gnuplot"

data = "figures/load.dat"
eval find_extent("abs($5 - $2)"); eval find_shown(2, 0.01 * high)
first(theta) = 1 + a_1 * cos(theta) + b_1 * sin(theta)
set xlabel "θ from the direction of travel (degrees)"; set xrange [0:360]; set xtics 90
set ylabel "(λ - λ_{1}) / a_{0}"
set xzeroaxis lt 8
set key width 0
plot for [i=1:words(shown)] data index 0 using ($1 * 180 / pi):(column(order(i) + 1) - $2) with lines lt order(i) + 1 \
       title kept(order(i)), \
     data index 1 using ($1 * 180 / pi):($2 - first($1)) with lines lt 1 title is_pointwise ? "all" : kept(n_all)
