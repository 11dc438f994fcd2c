# {{state}}. Pressure of the foot on the table, unrolled: along the rim and across it, R the contact radius.{{#measures}}
# Largest pressure {{most:.3g}} {{unit}} at θ = {{azimuth:.0f}}°, mean {{mean:.3g}} {{unit}}; the contact is
# {{#narrowest}}{{narrowest:.3g}} µm to {{/narrowest}}{{widest:.3g}} µm wide{{^has_edge}}, where 99 % of the load
# lie{{/has_edge}}.{{/measures}}
#@data pressure_{{plot}}
colour_label = "pressure (" . unit . ")"
load "figures/style.gnuplot"

# 1: azimuth (degrees), 2: distance from the rim (µm), 3: pressure
eval find_extent("$3 >= 0 ? $2 : NaN")
margin = n_found > 0 ? larger(0.05 * (high - low), high - low < 1 ? 1 : 0) : 0
set xlabel "θ from the direction of travel (degrees)"; set xrange [0:360]; set xtics 90
set ylabel "r - R (µm)"; set yrange [low - margin:high + margin]
unset key
low = 0; high = largest
eval set_colours
if (is_grid) {
  # In a view of three dimensions places are those of the screen.
  set lmargin at screen 0.19; set bmargin at screen 0.22; set tmargin at screen 0.95; set border 15; unset grid
  set colorbox user origin screen 0.79, screen 0.22 size screen 0.03, screen 0.73
  set label 1 colour_label at screen 0.97, screen 0.58 rotate by 90 center
  set view map; set pm3d corners2color mean
  splot data using 1:2:3 with pm3d
} else {
  plot data using 1:2:3 with points pt 5 ps 0.4 lc palette
}
