# How large each effect is: steps from the paper's model to this study's, and what leaving out one thing of the complete
# model changes (numbers in rad/s). The error band of the terminal spin contains none of them.
#@data effects | Differences of terminal spins
#@one_way
height = 135 + 28 * n_row
load "figures/style.gnuplot"

# 1: difference, 2: 1 for a step of the model, 3: 0 where it is not defined
eval find_list("difference", "$1"); eval find_list("is_step", "$2"); eval find_list("is_defined", "$3")
array row_text[n_row + 1]
do for [i=1:n_row] {
  row_text[i] = is_number(difference[i]) || is_defined[i] == 1 ? number_text("%+.3g", difference[i], rounding) : "not defined"
}
size = '(abs($1) >= rounding ? abs($1) : NaN)'
eval find_count(size . " > 0 && $2 == 1"); has_steps = n_found > 0
eval find_count(size . " > 0 && $2 == 0"); has_others = n_found > 0
eval find_extent(size)
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
plot data using ($2 == 1 ? @size : NaN):(n_row - $0) with points lt 1 ps 1 title has_steps ? "steps of the model" : "", \
     data using ($2 == 0 ? @size : NaN):(n_row - $0) with points lt 2 ps 1 title has_others ? "one thing left out" : "", \
     data every ::0::1 using (band > 0 ? band : NaN):($0 > 0 ? n_row + 0.6 : 0.4) with lines lt 8 dt 2 title band > 0 ? "error band" : ""
