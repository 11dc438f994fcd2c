# How large each effect is: steps from the paper's model to this study's, and what leaving out one thing of the complete
# model changes (numbers in rad/s). The error band of the terminal spin contains none of them.
height = 135 + 28 * n_row
load "figures/style.gnuplot"

# 1: place from below, 2: size of the difference, 3: 1 for a step of the model
eval find_count("$3 == 1 && $2 > 0"); has_steps = n_found > 0
eval find_count("$3 == 0 && $2 > 0"); has_others = n_found > 0
eval find_extent("$2")
least = band > 0 && (band < low || n_found == 0) ? band : low
high = larger(high, band)
if (n_found > 0 || band > 0) {
  low = 10. ** floor(log10(least) - 0.2); high = 10. ** ceil(log10(high) + 0.2)
} else {
  low = 0.1; high = 10
}
decades = ceil(log10(high / low) / 4. - 1e-9)
set xlabel "|difference of terminal spins| (rad/s)"
eval set_logarithmic("x")
set xrange [low:high]
eval set_fine_tics("x", low, high)
if (decades > 1) set xtics 10. ** decades
eval set_rows
plot data using ($3 == 1 ? $2 : NaN):1 with points lt 1 ps 1 title has_steps ? "steps of the model" : "", \
     data using ($3 == 0 ? $2 : NaN):1 with points lt 2 ps 1 title has_others ? "one thing left out" : "", \
     data every ::0::1 using (band > 0 ? band : NaN):($0 > 0 ? n_row + 0.6 : 0.4) with lines lt 8 dt 2 title band > 0 ? "error band" : ""
