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
if (most > least) {
  step = tic_step((most - least) / (2 * pi), 5)
  set y2tics ()
  set for [i=ceil(least / (2 * pi * step) - 1e-9):floor(most / (2 * pi * step) + 1e-9)] y2tics add (gprintf("%g", i * step) i * step)
}
eval find_extent("$1")
if (has_end) {
  set label (terminal < 0 ? "−" : "") . sprintf("%.5g rad/s", abs(terminal)) at graph 0.98, first terminal \
    offset 0, (terminal < 0 ? 0.7 : -0.7) right font ",12" textcolor rgb "#555555"
}
if (has_end && time_constant > 0 && time_constant < high) {
  set arrow from time_constant, graph 0 to time_constant, graph 1 nohead back lw 1 dt 3 lc rgb "#555555"
  set label sprintf("%.3g s", time_constant) at time_constant, graph (terminal < 0 ? 0.95 : 0.06) offset 0.5,0 left \
    font ",12" textcolor rgb "#555555"
}
plot for [i=1:n_curve] data using 1:(column(i + 1)) with lines lt line_type[i] title curve[i], \
     data using 1:(terminal) with lines lt 8 title has_end ? "terminal spin" : ""
