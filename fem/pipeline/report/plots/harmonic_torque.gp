# Above: torque of friction against the spin, of all harmonics of the load and of the first alone. Below: their difference
# Δτ_z, what the harmonics beyond the first add.
#@data harmonic_torque
#@one_way
height = 430
load "figures/style.gnuplot"

# 1: spin, 2: torque of all harmonics, 3: of the first
eval find_extent("larger(abs($2), abs($3))"); torque = high
eval find_extent("abs($2 - $3)"); difference = high
is_zero = !(difference > 1e-9 * torque) # rounding would fill the lower panel with noise
scale = torque >= 1e-4 ? 1e3 : 1e6
fine_scale = is_zero ? 1e6 : difference >= 1e-4 ? 1e3 : difference >= 1e-7 ? 1e6 : 1e9
unit(scale) = scale == 1e3 ? "mN m" : scale == 1e6 ? "µN m" : "nN m"
set multiplot
set lmargin at screen 0.16; set rmargin at screen 0.96
set xzeroaxis lt 8
set tmargin at screen 0.9; set bmargin at screen 0.53
set format x ""
set ylabel "τ_{z} (" . unit(scale) . ")"
plot data using 1:($2 * scale) with lines lt 1 title "all harmonics", \
     data using 1:($3 * scale) with lines lt 2 title "first harmonic"
if (note ne "") unset label 99 # once for both
set tmargin at screen 0.47; set bmargin at screen 0.17
set format x
set xlabel "spin ω (rad/s)"
set ylabel "Δτ_{z} (" . unit(fine_scale) . ")"
if (is_zero) set yrange [-1:1]
plot data using 1:(is_zero ? 0 : ($2 - $3) * fine_scale) with lines lt 3 notitle
unset multiplot
