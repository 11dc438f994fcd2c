# From the paper's terminal spin to that of this study, one step of the model after the other; the numbers are the
# differences in rad/s, from top to bottom.
height = 135 + 32 * n_row
load "figures/style.gnuplot"

# 1: place from below, 2: spin before, 3: spin, 4: half-width of its error band, 5: kind of bar, 6: line to the next
eval find_extent("$3 - $4"); least = low
eval find_extent("$3 + $4"); most = high
margin = most > least ? 0.08 * larger(most - least, 1e-3 * abs(most)) : abs(most) > 0 ? 8e-5 * abs(most) : 1
kind = 'faster slower "faster, formally" "slower, formally"'
bars = ""; formal_bars = ""
do for [k=1:4] {
  eval find_count(sprintf("$5 == %d", k))
  if (n_found > 0 && k < 3) { bars = bars . " " . k }
  if (n_found > 0 && k > 2) { formal_bars = formal_bars . " " . k }
}
eval find_count("$4 > 0"); has_bands = n_found > 0
set xlabel "terminal spin (rad/s)"
set xrange [least - margin:most + margin]
eval set_few_tics("x", least - margin, most + margin)
eval set_rows
kind_in(list, i) = i > words(list) ? 0 : int(word(list, i)) # gnuplot looks at i = 1 of an empty list too
plot for [i=1:words(bars)] data using ($5 == kind_in(bars, i) ? $3 : NaN):1:2:3:($1 - 0.32):($1 + 0.32) with boxxyerror \
       lt (kind_in(bars, i) == 1 ? 1 : 5) dt 1 lw 1 fs solid 0.85 border title word(kind, kind_in(bars, i)), \
     for [i=1:words(formal_bars)] data using ($5 == kind_in(formal_bars, i) ? $3 : NaN):1:2:3:($1 - 0.32):($1 + 0.32) \
       with boxxyerror lt (kind_in(formal_bars, i) == 3 ? 1 : 5) dt 1 lw 1 fs pattern 5 border \
       title word(kind, kind_in(formal_bars, i)), \
     data using 3:1:(0):6 with vectors nohead lt 8 lw 1 notitle, \
     data using ($4 > 0 ? $3 : NaN):1:4 with xerrorbars lt 7 lw 1.5 ps 0 title has_bands ? "error band" : "", \
     data using ($5 == 0 ? $3 : NaN):1 with points lt 7 pt 7 ps 1.1 notitle
