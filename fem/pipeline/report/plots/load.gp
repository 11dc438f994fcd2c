# Load round the rim, seen from above and drawn outwards from the rim, the mean load as half a radius; v is the direction of
# travel, n the harmonics kept. A curve inside the rim would pull on the table.
#@data round_the_rim
side = {{rim_load.side}}; turn = {{rim_load.turn}}; mean = {{rim_load.mean}}
n_all = {{rim_load.n_all}}; is_pointwise = {{rim_load.is_pointwise}}
height = 440
load "figures/style.gnuplot"

# Block 0: azimuth, the load after 1, 2, 3 and all harmonics; block 1: azimuth, the load as it is drawn; all over the mean
eval find_shown(1, 0.01)
x(theta, load) = (1 + load / 2.) * cos(theta) # the rim has radius 1, the mean load half of that
y(theta, load) = (1 + load / 2.) * sin(theta)
stats data index 1 using 2 nooutput name "LOAD"
set size ratio -1
set lmargin at screen 0.02; set rmargin at screen 0.98; set tmargin at screen 0.98; set bmargin at screen 0.17
unset border; unset tics; unset grid
set offsets 0.1, 0.1, 0.1, 0.1
set key at screen 0.04, screen 0.015 left bottom horizontal maxrows 2 width 0
set arrow 1 from 0,0 to 0.4,0 lw 1.5 lc rgb "#333333"
set label 1 "v" at 0.46,0 left
set arrow 2 from 0,0 to 0,side * 0.3 lw 1 dt (6,4) lc rgb "#333333"
set label 6 "orbit's centre" at 0,side * 0.45 center font ",12"
set for [i=0:3] label i + 2 sprintf("%d°", 90 * i) at 0.78 * cos(pi * i / 2),0.78 * sin(pi * i / 2) center font ",12"
# The sense in which friction turns the glass at rest.
if (turn != 0) {
  arc(k) = (200 + k) * pi / 180
  do for [k=0:48:4] {
    a = turn > 0 ? arc(k) : arc(50 - k); b = turn > 0 ? arc(k + 4) : arc(46 - k)
    if (k < 48) {
      set arrow from 0.6 * cos(a),0.6 * sin(a) to 0.6 * cos(b),0.6 * sin(b) nohead lw 1.8 lc rgb "#a3467f"
    } else {
      set arrow from 0.6 * cos(a),0.6 * sin(a) to 0.6 * cos(b),0.6 * sin(b) filled lw 1.8 lc rgb "#a3467f"
    }
  }
  set label "ω" at 0.45 * cos(arc(25)),0.45 * sin(arc(25)) center textcolor rgb "#a3467f"
}
set parametric; set trange [0:2 * pi]; set samples 181
plot cos(t), sin(t) with lines lt 8 title LOAD_min > 0 ? "" : "rim", \
     data index 1 using ($2 > 0 ? cos($1) : NaN):(sin($1)) with lines lt 7 lw 5 title "under load", \
     x(t, 1), y(t, 1) with lines lt 8 dt 3 title sprintf("mean, %.3g N/m", mean), \
     for [i=1:words(shown)] data index 0 using (x($1, column(order(i) + 1))):(y($1, column(order(i) + 1))) with lines lt i + 1 \
       title kept(order(i)), \
     data index 1 using (x($1, $2)):(y($1, $2)) with lines lt 1 title is_pointwise ? "all harmonics" : kept(n_all)
