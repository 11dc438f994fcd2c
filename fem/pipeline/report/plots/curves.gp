# {{caption}}{{#falls_over}} Where a case has no terminal spin, the glass falls over on the way.{{/falls_over}}
#@data sweep_{{plot}}
#@one_way
load "figures/style.gnuplot"

# A block for each curve: x, y
eval find_extent("$1")
set xlabel x_label
if (is_logarithmic) eval set_logarithmic("x")
if (!is_logarithmic) eval set_few_tics("x", low, high) # gnuplot's own may overlap
set ylabel y_label
# With the room of the style for long titles short ones would overlap.
longest(i) = i < 1 ? 0 : larger(strlen(curve[i]), longest(i - 1))
if (longest(n_curve) < 6) set key width 1
plot for [i=1:n_curve] data index i - 1 using 1:2 with @style lt i title curve[i]
