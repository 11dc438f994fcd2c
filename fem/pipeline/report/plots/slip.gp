# Slip and friction round the rim, seen from above, v to the right. Grey: how fast each place slips over the table. Coloured:
# the friction on it, blue where it turns the glass clockwise, orange where it turns it counter-clockwise. What is longer on
# one side than on the other turns the glass; at the terminal spin both sides are in balance.
#@data slip
#@one_way
height = n_title > 1 ? 320 : 400
load "figures/style.gnuplot"

# A block for each state: 1: azimuth, 2, 3: slip over v, 4, 5: friction over that of the mean load
turns(theta, x, y) = y * cos(theta) - x * sin(theta) # its torque, positive: counter-clockwise
unset border; unset tics; unset grid; unset key
set size ratio -1
reach = 1.72
set xrange [-reach:reach]; set yrange [-reach:reach]
set tmargin at screen 0.92; set bmargin at screen 0.02
set arrow 1 from -0.25,1.5 to 0.2,1.5 lw 1.5 lc rgb "#333333"
set label 1 "v" at 0.27,1.5 left
set multiplot
do for [i=1:n_title] {
  set lmargin at screen (i - 1.) / n_title + 0.01; set rmargin at screen real(i) / n_title - 0.01
  set label 2 title[i] at screen (i - 0.5) / n_title, screen 0.96 center font ",14"
  set parametric; set trange [0:2 * pi]; set samples 181
  plot cos(t), sin(t) with lines lt 8 lw 1.4 notitle, \
       data index i - 1 using (cos($1)):(sin($1)):(0.42 * $2):(0.42 * $3) with vectors head size screen 0.008,25 lw 0.9 dt 1 lc rgb "#999999", \
       data index i - 1 using (turns($1, $4, $5) < 0 ? cos($1) : NaN):(sin($1)):(0.5 * $4):(0.5 * $5) with vectors head size screen 0.011,22 filled \
         lw 1.5 dt 1 lc rgb "#0072b2", \
       data index i - 1 using (turns($1, $4, $5) >= 0 ? cos($1) : NaN):(sin($1)):(0.5 * $4):(0.5 * $5) with vectors head size screen 0.011,22 filled \
         lw 1.5 dt 1 lc rgb "#d55e00"
  if (i == 1 && note ne "") { unset label 99 }
}
unset multiplot
