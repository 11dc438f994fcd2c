# {{caption}}.{{#falls_over}} Where a case has no terminal spin, the glass falls over on the way.{{/falls_over}}
#@data sweep_{{plot}}
#@one_way
height = 380
load "figures/style.gnuplot"

# 1: x, 2: y, 3: value; a line of the grid each. Cells meet half-way between their values on the axis.
middle(a, b, is_logarithmic) = is_logarithmic ? sqrt(a * b) : (a + b) / 2
beyond(edge, bound, is_logarithmic) = is_logarithmic ? edge * edge / bound : 2 * edge - bound
to_nine_digits(bound) = sprintf("%.9g", bound) + 0 # rounding at an end of an axis would choose other tics
x_middle(i) = middle(x_at[i], x_at[i + 1], x_logarithmic); y_middle(j) = middle(y_at[j], y_at[j + 1], y_logarithmic)
x_bound(i) = to_nine_digits(i == 0 ? beyond(x_at[1], x_middle(1), x_logarithmic) : \
  i == n_x_at ? beyond(x_at[n_x_at], x_middle(n_x_at - 1), x_logarithmic) : x_middle(i))
y_bound(j) = to_nine_digits(j == 0 ? beyond(y_at[1], y_middle(1), y_logarithmic) : \
  j == n_y_at ? beyond(y_at[n_y_at], y_middle(n_y_at - 1), y_logarithmic) : y_middle(j))
x_low = x_bound(0); x_high = x_bound(n_x_at); y_low = y_bound(0); y_high = y_bound(n_y_at)
eval find_extent("$3"); margin = low < high ? 0 : larger(1e-6 * abs(low), 1e-300)
colour_low = low - margin; colour_high = high + margin
if (x_logarithmic) set logscale x
if (y_logarithmic) set logscale y
set xlabel x_label; set xrange [x_low:x_high]
set ylabel y_label; set yrange [y_low:y_high]
if (x_logarithmic) eval set_logarithmic("x"); eval set_fine_tics("x", x_low, x_high)
if (y_logarithmic) eval set_logarithmic("y"); eval set_fine_tics("y", y_low, y_high)
# Tics of a linear axis: at its values if they are few.
if (!x_logarithmic && n_x_at <= 6) set xtics (); set for [i=1:n_x_at] xtics add (sprintf("%.4g", x_at[i]) x_at[i])
if (!x_logarithmic && n_x_at > 6) eval set_few_tics("x", x_low, x_high)
if (!y_logarithmic && n_y_at <= 6) set ytics (); set for [i=1:n_y_at] ytics add (sprintf("%.4g", y_at[i]) y_at[i])
if (!y_logarithmic && n_y_at > 6) eval set_few_tics("y", y_low, y_high)
low = colour_low; high = colour_high
# Both signs: zero is white.
if (low < 0 && high > 0) high = larger(-low, high); low = -high; set palette defined (-1 "#2166ac", 0 "#f7f7f7", 1 "#b2182b")
eval set_colours
unset grid; unset key; set border 15; set tics out
set style fill solid noborder
i(row) = int(row) % n_x_at; j(row) = int(row) / n_x_at
plot data using 1:2:(x_bound(i($0))):(x_bound(i($0) + 1)):(y_bound(j($0))):(y_bound(j($0) + 1)):3 with boxxyerror lc palette
