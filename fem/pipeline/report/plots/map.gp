height = 380
load "figures/style.gnuplot"

# 1: x, 2: y, 3: value, 4 to 7: bounds of the cell, left, right, lower, upper
eval find_extent("$4"); x_low = low; eval find_extent("$5"); x_high = high
eval find_extent("$6"); y_low = low; eval find_extent("$7"); y_high = high
eval find_extent("$3"); margin = low < high ? 0 : larger(1e-6 * abs(low), 1e-300)
colour_low = low - margin; colour_high = high + margin
if (x_logarithmic) set logscale x
if (y_logarithmic) set logscale y
# Contour lines first: the table of their points would heed the formats of the axes.
step = tic_step(colour_high - colour_low, 4) # as the scale has it
set contour base; unset surface; set cntrparam levels incremental step * ceil(colour_low / step), step, colour_high
set table $contours
splot data using 1:2:3 notitle
unset table
set xlabel x_label; set xrange [x_low:x_high]
set ylabel y_label; set yrange [y_low:y_high]
if (x_logarithmic) eval set_logarithmic("x"); eval set_fine_tics("x", x_low, x_high)
if (y_logarithmic) eval set_logarithmic("y"); eval set_fine_tics("y", y_low, y_high)
low = colour_low; high = colour_high
eval set_colours
unset grid; unset key; set border 15; set tics out
set style fill solid noborder
plot data using 1:2:4:5:6:7:3 with boxxyerror lc palette, \
     $contours using 1:2 with lines lc rgb "#ffffff" lw 1.2 dt 1
