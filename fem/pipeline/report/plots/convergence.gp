# Relative distance from the limit; bars reach up to the error band.{{#has_triangle}} The triangle has the slope of the first
# quantity's observed order.{{/has_triangle}}
#@data plot_of_{{axis}}
load "figures/style.gnuplot"

# A block for each curve: 1: size, 2: error, 3: half-width of its band; then the triangle. A bar that points downwards is a
# band that was too narrow.
set xlabel x_label
if (is_logarithmic) eval set_logarithmic("x")
set ylabel "relative error"
eval set_logarithmic("y")
set xtics () format "%g"; set for [i=1:n_size] xtics add (sprintf("%g", size[i]) size[i])
set autoscale xfix; set offsets graph 0.05, graph 0.05
plot for [i=1:n_curve] data index i - 1 using 1:2:2:3 with yerrorbars lt i dt 1 lw 1 ps 0 notitle, \
     for [i=1:n_curve] data index i - 1 using 1:2 with linespoints lt i title curve[i], \
     for [i=1:n_triangle] data index n_curve using 1:2 with lines lt 8 title n_triangle > 0 ? triangle[i] : ""
