# Friction's torque against the spin, n harmonics kept; points: the terminal spins, where friction's, the lean and the
# fingers' torque add up to zero.{{#spin_unit}} Beyond ω = ±v/R = ±{{spin_unit:.3g}} rad/s part of the rim slides backwards.{{/spin_unit}}
#@one_way
load "figures/style.gnuplot"
eval from_csv

# torque.csv: the spin, columns 3 and 9, 10, ...: friction's torque of all harmonics and of harmonics[i]
data = "torque.csv"
eval find_extent("$1")
set xlabel "spin ω (rad/s)"; set xrange [low:high]
set ylabel "torque τ_{z} (mN m)"
set xzeroaxis lt 8
if (spin_unit > 0) {
  do for [sense in "−1 +1"] {
    at = sense eq "+1" ? spin_unit : -spin_unit
    if (at >= low && at <= high) {
      set arrow from at, graph 0 to at, graph 1 nohead back lw 1 dt 3 lc rgb "#555555"
      set label sense[1:strlen(sense) - 1] . "v/R" at at, graph 0.96 offset 0.5,0 left font ",12" textcolor rgb "#555555"
    }
  }
}
plot data using 1:(1e3 * $3) with lines lt 1 title kept(n_all), \
     for [i=1:n_harmonics] data using 1:(1e3 * column(8 + i)) with lines lt i + 1 title kept(harmonics[i]), \
     for [i=1:n_terminal] data every ::0::0 using (terminal[i]):(0) with points lt terminal_type[i] notitle
