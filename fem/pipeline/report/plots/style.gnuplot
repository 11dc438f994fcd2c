# What all figures have in common; each of them loads this file when it has set width and height.
# format = "pdf" draws the PDF instead of the SVG.
reset
unset datafile columnheaders # which reset leaves as the picture before had them
if (!exists("format")) format = "svg"
set encoding utf8
if (format eq "pdf") {
  set terminal pdfcairo noenhanced color font "Sans,10" linewidth 1 size width / 108.,height / 108.
} else {
  set terminal svg noenhanced font "sans-serif,15" linewidth 1.2 background rgb "white" size width,height
}
set termoption enhanced
set output "figures/" . name . "." . format

# Colours of Okabe and Ito, which people who see red and green alike can tell apart; line types differ in their dashes too.
set linetype 1 lc rgb "#0072b2" lw 2 dt 1 pt 7 ps 0.6          # blue
set linetype 2 lc rgb "#d55e00" lw 2 dt (9,4) pt 5 ps 0.6      # vermillion
set linetype 3 lc rgb "#009e73" lw 2 dt (9,3,2,3) pt 9 ps 0.7  # bluish green
set linetype 4 lc rgb "#cc79a7" lw 2 dt (3,3) pt 13 ps 0.7     # reddish purple
set linetype 5 lc rgb "#e69f00" lw 2 dt (14,4) pt 11 ps 0.7    # orange
set linetype 6 lc rgb "#56b4e9" lw 2 dt (5,2,2,2,2,2) pt 6 ps 0.7 # sky blue
set linetype 7 lc rgb "#000000" lw 1 dt 1 pt 2 ps 0.7
set linetype 8 lc rgb "#777777" lw 1 dt 1 pt 1 ps 0.7
set linetype cycle 8
# Light to dark at even steps of lightness, blue to yellow as in cividis.
set palette defined (0 "#00204d", 1 "#31446b", 2 "#666970", 3 "#958f78", 4 "#cbba69", 5 "#ffea46")

set minussign
set border 3 lw 0.8 lc rgb "#333333"
set tics nomirror scale 0.6
set grid lt -1 lw 0.5 lc rgb "#dddddd"
set key tmargin left horizontal reverse Left samplen 2.2 spacing 1.2 width 1 # above the plot, never on a curve
# The SVG terminal takes texts for wider than they are.
if (format eq "svg") set key width -3
if (note ne "") set label 99 note at screen 0.01, screen 0.03 left font ",11" textcolor rgb "#555555"

# Functions for all figures. Those whose name begins with "set_" or "find_" give commands for eval.
larger(a, b) = a > b ? a : b
kept(n) = n == 1 ? "first harmonic" : sprintf(n == n_all ? "all, n ≤ %d" : "n ≤ %d", n)
# Of the truncations in load.dat from the first on those that differ from all harmonics, as shown; the first harmonic always.
find_shown(first, difference) = sprintf('shown = ""; do for [n=%d:3] { if (n < n_all) { ' . \
  'stats data index 0 using (abs(column(n + 1) - $5)) nooutput name "E"; ' . \
  'if (n == 1 || E_max > %.17g) { shown = shown . " " . n } } }', first, difference)
order(i) = i > words(shown) ? 1 : int(word(shown, i)) # gnuplot looks at i = 1 where none is shown, too
length_text(mm) = mm < 0.1 ? sprintf("%.3g µm", 1e3 * mm) : sprintf("%.4g mm", mm)

# Least and largest value of an expression in the data's columns as low and high, and in how many rows it has one; before any
# range or logarithmic scale is set.
find_extent(what) = 'undefine E_*; stats data using (' . what . ') nooutput name "E"; ' . \
  'n_found = exists("E_records") ? E_records : 0; ' . \
  'low = n_found > 0 ? E_min : -1; high = n_found > 0 ? E_max : 1'

# For templates that draw a file of the results: columns parted by commas, under a line with their names.
from_csv = 'set datafile separator ","; set datafile columnheaders'

# In how many rows a condition holds, as n_found; a condition on what is not a number does not.
find_count(condition) = 'undefine E_*; stats data using (' . condition . ') nooutput name "E"; ' . \
  'n_found = exists("E_sum") ? E_sum : 0'

# The least step of 1, 2 and 5 times a power of ten that goes n times into a range at most.
tic_power(range, n) = 10. ** floor(log10(range / real(n)))
tic_factor(steps, n) = steps <= n ? 1 : steps <= 2 * n ? 2 : steps <= 5 * n ? 5 : 10
tic_step(range, n) = tic_power(range, n) * tic_factor(range / tic_power(range, n), n)
# At most five tics of a linear axis, with the decimals that tell them apart: gnuplot's own may overlap.
decimals(step) = step < 1 ? ceil(-log10(step) - 1e-9) : 0
is_easy(value) = value >= 1e-3 && value < 1e6
set_few_tics(axis, low, high) = high > low ? sprintf("set %stics %.10g; ", axis, tic_step(high - low, 4)) . \
  (is_easy(larger(abs(low), abs(high))) ? sprintf('set format %s "%%.%df"', axis, decimals(tic_step(high - low, 4))) : "") : ""

set_logarithmic(axis) = sprintf('set logscale %s; set format %s "10^{%%T}"; set m%stics 1', axis, axis, axis)
# Tics at 1, 2 and 5 times powers of ten, for a logarithmic axis that has too few powers.
set_fine_tics(axis, low, high) = high >= 100 * low ? "" : \
  sprintf('set %stics (); set for [power=%d:%d] for [digit in "1 2 5"] %stics add ', axis, floor(log10(low)), floor(log10(high)), axis) . \
  '(sprintf("%s10^{%d}", digit eq "1" ? "" : digit . "·", power) digit * 10. ** power)'

# A colour scale from low to high, called colour_label, to the right. Places are on the page: terminals differ in the room
# that they think a text needs.
set_colours = 'set rmargin at screen 0.77; set colorbox user origin screen 0.79, graph 0 size screen 0.03, graph 1; ' . \
  'set label 1 colour_label at screen 0.97, graph 0.5 rotate by 90 center; set cbrange [low:high]; ' . \
  'eval set_few_tics("cb", low, high)'

# Rows from above: row[i] at the vertical axis, and a column of numbers row_text[i] to the right.
widest_row(i) = i < 1 ? 0 : larger(strlen(row[i]), widest_row(i - 1))
left_of_rows(points) = (points * widest_row(n_row) + 15) / 540.
set_rows = 'set ytics () scale 0 font ",14"; set for [i=1:n_row] ytics add (row[i] n_row + 1 - i); ' . \
  'set yrange [0.4:n_row + 0.6]; set for [i=1:n_row] label i row_text[i] at screen 0.97, first n_row + 1 - i right font ",14"; ' . \
  'set lmargin at screen (left_of_rows(7.9) < 0.5 ? left_of_rows(7.9) : 0.5); ' . \
  'set rmargin at screen 0.80; set tmargin 5; set bmargin 4; ' . \
  'set label 90 "rad/s" at screen 0.97, graph 1 right offset 0,0.6 font ",12" textcolor rgb "#555555"; ' . \
  'unset border; set border 1; set grid x noytics; set key at screen 0.02, screen 0.985 left top vertical maxrows 3 samplen 1.6'

# A column as list[1], list[2] ... A row of data in which an expression meets a NaN has no value at all; lists do not mind.
find_list(list, what) = sprintf('array %s[n_row + 1]; stats data using (%s[int($0) + 1] = %s, 0) nooutput', list, list, what)
is_number(x) = x == x

# A number with a true minus, a dash where there is none, 0 where it is rounding.
true_minus(text) = strstrt(text, "-") == 0 ? text : \
  text[1:strstrt(text, "-") - 1] . "−" . true_minus(text[strstrt(text, "-") + 1:strlen(text)])
number_text(format, x, rounding) = !is_number(x) ? "–" : abs(x) < rounding ? "0" : true_minus(sprintf(format, x))

# Instead of a plot without a single point.
plot_nothing = 'unset logscale; unset tics; set xrange [0:1]; set yrange [0:1]; ' . \
  'set label "nothing to show" at 0.5,0.5 center; plot NaN notitle'
