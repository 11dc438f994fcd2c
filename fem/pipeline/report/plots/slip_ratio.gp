# The slip ratio on the way to the stop.
at_stop = {{slide.final_slip_ratio}}
load "figures/style.gnuplot"
eval from_csv
set xlabel "t (s)"
set ylabel "ωR/v"
plot "path.csv" using 1:8 with lines title "ωR/v", \
     "path.csv" using 1:(at_stop) with lines lt 8 title at_stop == at_stop ? "at the stop" : ""
