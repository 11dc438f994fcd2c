# How far ω(t) of fewer harmonics is from that of all.
#@one_way
load "figures/style.gnuplot"
eval from_csv

# spin_up.csv: time, then the spin with harmonics[i], the last of which are all
data = "spin_up.csv"
difference(i) = abs(column(i + 1) - column(n_harmonics + 1))
shown = ""
do for [i=1:n_harmonics - 1] {
  eval find_count(sprintf("difference(%d) > rounding", i))
  if (n_found > 0 && words(shown) < 6) { shown = shown . " " . i }
}
set xlabel "t (s)"
set ylabel "|ω_{n} - ω_{all}| (rad/s)"
eval set_logarithmic("y")
if (shown ne "") {
  place(k) = word(shown, k) + 0
  drawn(i) = difference(i) > rounding ? difference(i) : NaN
  plot for [k=1:words(shown)] data using (drawn(place(k)) > 0 ? $1 : NaN):(drawn(place(k))) with lines lt k + 1 \
    title kept(harmonics[place(k)]) # all harmonics have the first line type
} else {
  eval plot_nothing
}
