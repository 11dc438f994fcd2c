load "figures/style.gnuplot"

# As in rim_circle.gp
data = "figures/rim_circle.dat"
eval find_count("$4 < 1"); has_less = n_found > 0
eval find_extent("$1")
set xlabel "r (mm)"
set ylabel "distance (µm)"
plot data using ($4 < 1 ? NaN : $1):3 with points lt 2 title "points", \
     data using ($4 < 1 ? $1 : NaN):3 with points lt 2 pt 6 title has_less ? "points that count less" : "", \
     for [i=-1:1] data using 1:(i * scatter) with lines lt 1 notitle
