# Harmonics of the load relative to its mean a_0. What is below 10⁻¹² is rounding and not shown.{{#has_hollow}} Hollow:
# smaller than the error band, or than the last band that is known; not resolved.{{/has_hollow}}
#@data spectrum
load "figures/style.gnuplot"

# 1: n, 2: amplitude over the mean, 3: half-width of its error band, 4: 1 where it is resolved
eval find_extent("$2 > 1e-12 ? $1 : NaN"); last = n_found > 0 ? larger(1, high) : 1
eval find_extent("$2 > 1e-12 ? $2 : NaN")
set xlabel "harmonic n"; set xrange [0.5:last + 0.5]
if (last <= 10) set xtics 1
set ylabel "√(a_{n}² + b_{n}²) / a_{0}"
eval set_logarithmic("y")
set yrange [10. ** floor(log10(n_found > 0 && low < 1e-2 ? low : 1e-2)):10]
set key width 1
if (n_found > 0) {
  plot data using 1:($4 == 1 && $3 > 0 ? $2 : NaN):3 with yerrorbars lt 1 dt 1 lw 1 notitle, \
       data using 1:($4 == 1 ? $2 : NaN) with points lt 1 title has_hollow ? "resolved" : "", \
       data using 1:($4 == 1 ? NaN : $2) with points lt 1 pt 6 title has_hollow ? "not resolved" : ""
} else {
  eval plot_nothing
}
