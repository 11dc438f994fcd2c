# {{caption}}
#@data {{plot}}
load "figures/style.gnuplot"

# The value under each moment balance
least = 1e300; most = -1e300
do for [i=1:n_curve] {
  eval find_extent(sprintf("column(%d)", i))
  least = low < least ? low : least; most = larger(high, most)
}
set xlabel x_label
set lmargin at screen left_of_rows(7.6); set rmargin at screen 0.95
set key width 0
set yrange [0.5:n_row + 0.5]
set ytics (); set for [i=1:n_row] ytics add (row[i] n_row + 1 - i)
set grid x y
eval set_few_tics("x", least, most)
plot for [i=1:n_curve] data using (column(i)):(n_row - $0) with points lt i title curve[i]
