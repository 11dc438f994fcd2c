# The path seen from above, with the outline of the body and a mark that turns with it.
load "figures/style.gnuplot"
eval from_csv

data = "path.csv"
set xlabel "x (mm)"
set ylabel "y (mm)"
set size ratio -1
set samples 74
# From the centre to the mark, and round.
across(t) = t < 0 ? 0 : 1e3 * radius
mark_x(i, t) = 1e3 * x_at[i] + across(t) * cos(yaw_at[i] + t)
mark_y(i, t) = 1e3 * y_at[i] + across(t) * sin(yaw_at[i] + t)
plot for [i=1:n_x_at] [t=-pi / 36:2 * pi] "+" using (mark_x(i, t)):(mark_y(i, t)) \
       with lines lt 7 title i == 1 ? "outline and mark" : "", \
     data using (1e3 * $2):(1e3 * $3) with lines lt 1 title "path of the centre"
