# Distance of the points from the circle, upwards positive; the lines are at the scatter, {{scatter:1e6*.2g}} µm. Points
# that follow a curve instead of scattering say that the land is no circle: take a smaller Glass/Land width.
load "figures/style.gnuplot"

# As in rim_circle.gp
data = "figures/rim_circle.dat"
eval find_count("$4 < 1"); has_less = n_found > 0
eval find_extent("1e3 * $1")
set xlabel "r (mm)"
set ylabel "distance (µm)"
plot data using ($4 < 1 ? NaN : 1e3 * $1):(1e6 * $3) with points lt 2 title "points", \
     data using ($4 < 1 ? 1e3 * $1 : NaN):(1e6 * $3) with points lt 2 pt 6 title has_less ? "points that count less" : "", \
     for [i=-1:1] data using (1e3 * $1):(1e6 * i * scatter) with lines lt 1 notitle
