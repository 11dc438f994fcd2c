# The load per length of the rim, λ(θ)/R: what a strip of the table feels before the glass spins.
side = {{rim_load.side}}; mean = {{rim_load.mean}}; n_all = {{rim_load.n_all}}
load "figures/style.gnuplot"

data = "figures/load.dat"
set xlabel "θ from the direction of travel (degrees)"; set xrange [0:360]
set xlabel offset 0,-0.9; set bmargin 5
set ylabel "λ / R (N/m)"
set xzeroaxis lt 8
# The orbit's centre lies to the left of the direction of travel where the orbit runs counter-clockwise.
left = side > 0 ? "orbit's centre" : "outside"; right = side > 0 ? "outside" : "orbit's centre"
set xtics ("0\nfront" 0, "90\n" . left 90, "180\nback" 180, "270\n" . right 270, "360\nfront" 360)
plot data index 1 using ($1 * 180 / pi):($2 * mean) with lines lt 1 title n_all > 1 ? "all harmonics" : "first harmonic", \
     data index 0 using ($1 * 180 / pi):(n_all > 1 ? $2 * mean : NaN) with lines lt 2 title n_all > 1 ? "first harmonic" : "", \
     data index 0 using ($1 * 180 / pi):(mean) with lines lt 8 title "mean"
