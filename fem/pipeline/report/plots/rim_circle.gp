# The points of the land and the circle through them: the crown.
#@data rim_points
load "figures/style.gnuplot"

# Points of the land: 1: radius, 2: height, 3: distance from the circle (m), 4: weight
circle(r) = abs(r - radius) <= crown ? 1e3 * crown * (1 - sqrt(1 - ((r - radius) / crown) ** 2)) : NaN
eval find_count("$4 < 1"); has_less = n_found > 0
eval find_extent("1e3 * $1")
set xlabel "r (mm)"
set ylabel "height (µm)"
set samples 101
plot sample [t=low:high] "+" using (t):(circle(t)) with lines lt 1 title "circle", \
     data using ($4 < 1 ? NaN : 1e3 * $1):(1e6 * $2) with points lt 2 title "points", \
     data using ($4 < 1 ? 1e3 * $1 : NaN):(1e6 * $2) with points lt 2 pt 6 title has_less ? "points that count less" : ""
