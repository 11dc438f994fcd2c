# The cells at the rim{{#crown}} with the rounding of its crown{{/crown}}, above the table.
height = 297
load "figures/style.gnuplot"

# The cells of the section, lengths in mm, lifted by the crown
data = "figures/section.dat"
lift(r) = crown > 0 ? (r - radius) ** 2 / (2 * crown) : 0
reach = 3 * larger(larger(radius - inner, outer - radius), 3e-4 * radius) # three times the loaded band, to both sides of it
unset border; unset tics; unset grid; unset key
set lmargin 0; set rmargin 0; set tmargin 0; set bmargin 0
set size ratio -1
set xrange [radius - reach:radius + reach]; set yrange [-0.4 * reach:0.7 * reach]
set arrow from radius - reach,0 to radius + reach,0 nohead lw 0.6 dt 1 lc rgb "#777777"
set arrow from radius,-0.2 * reach to radius,0.65 * reach nohead lw 0.6 dt (12,4,2,4) lc rgb "#777777"
set arrow from inner,0 to outer,0 nohead front lw 4 lc rgb "#d55e00"
set arrow from inner,-0.16 * reach to outer,-0.16 * reach heads size screen 0.008,20 filled front lw 0.8 lc rgb "#333333"
set label "under load " . length_text(outer - inner) at radius,-0.28 * reach center front font ",13"
set label "table" at radius - 0.98 * reach,-0.07 * reach left font ",13"
set style fill solid 1.0 border lc rgb "#4a8fc0"
plot data using 1:($2 + lift($1)) with filledcurves closed fc rgb "#dcebf7" lw 0.5
