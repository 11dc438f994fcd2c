# From the paper's terminal spin to that of this study, one step of the model after the other; the numbers are the
# differences in rad/s, from top to bottom.
#@data waterfall | From the paper's model to this study's
#@one_way
height = 135 + 32 * n_row
load "figures/style.gnuplot"

# 1: spin, 2: its difference to that of the row above, NaN in the first row and the last, 3: half-width of its error band,
# 4: 1 where it is formal
eval find_list("spin", "$1"); eval find_list("difference", "$2"); eval find_list("known_band", "$3"); eval find_list("formal", "$4")
array before[n_row + 1]; array band[n_row + 1]; array bar[n_row + 1]; array to_next[n_row + 1]; array row_text[n_row + 1]
n_found = 0; has_bands = 0; bars = ""; formal_bars = ""
kind = 'faster slower "faster, formally" "slower, formally"'
do for [i=1:n_row] {
  is_total = i == 1 || i == n_row
  row_text[i] = number_text(is_total ? "%.6g" : "%+.3g", is_total ? spin[i] : difference[i], rounding)
  before[i] = spin[i] - difference[i]
  band[i] = is_number(known_band[i]) ? known_band[i] : 0
  bar[i] = is_number(difference[i]) ? (abs(spin[i]) > abs(before[i]) ? 1 : 2) + 2 * formal[i] : 0
  to_next[i] = i < n_row && is_number(spin[i]) && is_number(spin[i + 1]) ? -1 : 0
  if (is_number(spin[i])) {
    least = n_found == 0 || spin[i] - band[i] < least ? spin[i] - band[i] : least
    most = n_found == 0 ? spin[i] + band[i] : larger(spin[i] + band[i], most)
    n_found = n_found + 1; has_bands = has_bands || band[i] > 0
  }
}
if (n_found == 0) { least = -1; most = 1 }
do for [k=1:4] {
  is_there = 0
  do for [i=1:n_row] { is_there = is_there || bar[i] == k }
  if (is_there && k < 3) { bars = bars . " " . k }
  if (is_there && k > 2) { formal_bars = formal_bars . " " . k }
}
margin = most > least ? 0.08 * larger(most - least, 1e-3 * abs(most)) : abs(most) > 0 ? 8e-5 * abs(most) : 1
set xlabel "terminal spin (rad/s)"
set xrange [least - margin:most + margin]
eval set_few_tics("x", least - margin, most + margin)
eval set_rows
kind_in(list, i) = i > words(list) ? 0 : int(word(list, i)) # gnuplot looks at i = 1 of an empty list too
r(row) = int(row) + 1
y(row) = n_row - row
plot for [i=1:words(bars)] data using (bar[r($0)] == kind_in(bars, i) ? spin[r($0)] : NaN):(y($0)):(before[r($0)]):(spin[r($0)]):(y($0) - 0.32):(y($0) + 0.32) with boxxyerror \
       lt (kind_in(bars, i) == 1 ? 1 : 5) dt 1 lw 1 fs solid 0.85 border title word(kind, kind_in(bars, i)), \
     for [i=1:words(formal_bars)] data using (bar[r($0)] == kind_in(formal_bars, i) ? spin[r($0)] : NaN):(y($0)):(before[r($0)]):(spin[r($0)]):(y($0) - 0.32):(y($0) + 0.32) \
       with boxxyerror lt (kind_in(formal_bars, i) == 3 ? 1 : 5) dt 1 lw 1 fs pattern 5 border \
       title word(kind, kind_in(formal_bars, i)), \
     data using (spin[r($0)]):(y($0)):(0):(to_next[r($0)]) with vectors nohead lt 8 lw 1 notitle, \
     data using (band[r($0)] > 0 ? spin[r($0)] : NaN):(y($0)):(band[r($0)]) with xerrorbars lt 7 lw 1.5 ps 0 title has_bands ? "error band" : "", \
     data using (bar[r($0)] == 0 ? spin[r($0)] : NaN):(y($0)) with points lt 7 pt 7 ps 1.1 notitle
