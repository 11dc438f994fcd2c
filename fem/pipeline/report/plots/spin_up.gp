# {{opening}}{{#has_measured}} Points: measured, Motion/Measured spin file.{{/has_measured}}{{#has_time_constant}} Dotted:
# the time constant with which the terminal spin is approached.{{/has_time_constant}}
#@data spin_up_curves
#@one_way
load "figures/style.gnuplot"

# 1: time, then the spin of each curve
set xlabel "time (s)"
set ylabel "spin ω (rad/s)"
set xzeroaxis lt 8
set link y2 via y / (2 * pi) inverse y * 2 * pi
set y2tics nomirror; set y2label "turns per second"; set border 11
has_end = terminal == terminal # not a number where there is none
least = has_end ? terminal : 0; most = least
do for [i=1:n_curve] {
  eval find_extent(sprintf("column(%d)", i + 1))
  least = low < least ? low : least; most = larger(high, most)
}
do for [i=1:n_measured_time] {
  least = measured_omega[i] < least ? measured_omega[i] : least; most = larger(measured_omega[i], most)
}
if (most > least) {
  step = tic_step((most - least) / (2 * pi), 5)
  set y2tics ()
  set for [i=ceil(least / (2 * pi * step) - 1e-9):floor(most / (2 * pi * step) + 1e-9)] y2tics add (gprintf("%g", i * step) i * step)
}
eval find_extent("$1")
# Each end value at its own curve, away from the other's: the last curve is the paper's.
shown_spin(omega) = (omega < 0 ? "−" : "") . sprintf("%.5g rad/s", abs(omega))
if (has_end) {
  stats data using (column(n_curve + 1)) every ::n_found - 1 nooutput name "P"
  has_other = n_curve > 1 && exists("P_max")
  other = has_other ? P_max : terminal - 1
  set label shown_spin(terminal) at graph 0.99, first terminal offset 0, (terminal > other ? 0.75 : -0.75) right \
    font ",12" textcolor rgb "#0072b2"
  if (has_other) {
    set label shown_spin(other) at graph 0.99, first other offset 0, (terminal > other ? -0.75 : 0.75) right \
      font ",12" textcolor lt line_type[n_curve]
  }
}
if (has_time_constant) {
  set arrow from time_constant, graph 0 to time_constant, graph 1 nohead back lw 1 dt 3 lc rgb "#555555"
  set label sprintf("%.3g s", time_constant) at time_constant, graph (terminal < 0 ? 0.95 : 0.06) offset 0.5,0 left \
    font ",12" textcolor rgb "#555555"
}
if (most > least) set yrange [least - 0.16 * (most - least):most + 0.12 * (most - least)]
plot for [i=1:n_curve] data using 1:(column(i + 1)) with lines lt line_type[i] title curve[i], \
     data using 1:(terminal) with lines lt 8 title has_end ? "terminal spin" : "", \
     measured_time using (n_measured_time > 0 ? measured_time[$1] : NaN):(measured_omega[$1]) with points lt 7 pt 6 ps 0.7 \
       title n_measured_time > 0 ? "measured" : ""
