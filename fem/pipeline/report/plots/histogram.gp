# Distribution of the samples: {{what}}
#@data sweep_{{samples}}
#@one_way
load "figures/style.gnuplot"

# Samples: 1: an entry, 2: the quantity; about the square root of their number of intervals
eval find_extent("$2")
n_bins = larger(5, n_found > 3600 ? 60 : ceil(sqrt(n_found)))
bin_width = (high - low) / n_bins
middle(value) = low + bin_width * ((value < high ? floor((value - low) / bin_width) : n_bins - 1) + 0.5)
set xlabel x_label; set xrange [low - bin_width:high + bin_width]
eval set_few_tics("x", low, high)
set ylabel "samples"; set yrange [0:*]
set boxwidth bin_width
set style fill solid 0.6
plot data using (middle($2)):(1) smooth frequency with boxes lt 1 notitle
