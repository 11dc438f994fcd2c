# The README's picture, from two result folders:
#   stemware run docs/cookbooks/paper.prm && stemware run docs/cookbooks/lift_off.prm && gnuplot docs/figures/answer.gp
set terminal svg size 900,420 font "sans-serif,13" background rgb "white"
set output "docs/figures/answer.svg"
set multiplot layout 1,2
set key top left reverse Left samplen 2
set grid lc rgb "#dddddd"

a0 = 2.943 / (2 * pi)
set title "Load on the table round the rim"
set xlabel "θ from the direction of travel (degrees)"; set ylabel "λ / a_0"
set xrange [0:360]; set xtics 90; set yrange [-0.5:3.3]
plot 0 lc rgb "black" lw 1 notitle, \
     "results/paper/load.dat" every 4 using ($1 * 180 / pi):($2 / a0) with lines lw 2 lc rgb "#1b6ca8" title "paper's moment, elastic foot", \
     "results/lift_off/load_lines.dat" using ($1 * 180 / pi):($2 / a0) with lines lw 2 lc rgb "#c0392b" title "moment ratio 1.3, elastic foot", \
     "results/lift_off/load.dat" every 4 using ($1 * 180 / pi):($3 / a0) with lines lw 2 dt 2 lc rgb "#e8a598" title "its first harmonic (would pull)"

set title "Torque of friction, moment ratio 1.3"
set xlabel "ω (rad/s)"; set ylabel "τ_z (mN m)"
set autoscale; set xrange [-12:2]; set xtics autofreq
set key top right noreverse Right
plot 0 lc rgb "black" lw 1 notitle, \
     "results/lift_off/torque.dat" using 1:($3 * 1e3) with lines lw 2 lc rgb "#c0392b" title "all harmonics", \
     "results/lift_off/torque.dat" using 1:($6 * 1e3) with lines lw 2 dt 2 lc rgb "#e8a598" title "first harmonic alone"
unset multiplot
