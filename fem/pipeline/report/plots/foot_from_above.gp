# Where the foot presses on the table before it spins, seen from above, through the glass. Distances from the rim, the thin
# circle, are drawn {{magnification:g}} times larger; v is the direction of travel.
colour_label = "pressure (" . unit . ")"
height = 430
load "figures/style.gnuplot"

# The pressure of the footprint: azimuth (degrees), distance from the rim (µm), pressure; seen from above
data = "figures/footprint.dat"
drawn(distance) = radius + magnification * 1e-3 * distance
unset border; unset tics; unset grid; unset key
set lmargin at screen 0.02; set bmargin at screen 0.02; set tmargin at screen 0.98
set size ratio -1
half = larger(1.05 * edge, 1.2 * radius)
set xrange [-half:half]; set yrange [-half:half]
set view map
low = 0; high = largest
eval set_colours
# In a view of three dimensions places are those of the screen.
set rmargin at screen 0.78
set colorbox user origin screen 0.80, screen 0.10 size screen 0.03, screen 0.80
set label 1 colour_label at screen 0.97, screen 0.5 rotate by 90 center
set object 1 circle at 0,0 size edge back fs empty border lc rgb "#4a8fc0" lw 1.5
set object 2 circle at 0,0 size radius front fs empty border lc rgb "#777777" lw 0.6
set arrow from 0,0 to 0.45 * radius,0 front lw 2 lc rgb "#333333"
set label "v" at 0.48 * radius,0 left front
# The orbit's centre lies to the left of the motion where the orbit runs counter-clockwise seen from above.
set arrow from 0,0 to 0,side * 0.36 * radius front lw 1 dt (6,4) lc rgb "#333333"
set label "to the orbit's centre,\n" . length_text(orbit_radius) . " from here" at 0,side * (side > 0 ? 0.54 : 0.44) * radius \
  center front font ",13"
if (is_grid) {
  splot data using (drawn($2) * cos($1 * pi / 180)):(drawn($2) * sin($1 * pi / 180)):3 with pm3d
} else {
  splot data using (drawn($2) * cos($1 * pi / 180)):(drawn($2) * sin($1 * pi / 180)):3 with points pt 5 ps 0.5 lc palette
}
