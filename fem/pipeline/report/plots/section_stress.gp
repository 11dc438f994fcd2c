# The loaded foot at rest, cut along the line to the orbit's centre; displacements are drawn {{magnification:g}} times larger,
# up to {{move:1e6*.2g}} µm. Largest stress of von Mises {{stress:1e-6*.3g}} MPa.
#@data section_stress
reset; unset datafile columnheaders # the picture before may have read a table parted by commas
find_limits(column) = sprintf('stats data using (%s) nooutput name "L"', column)
eval find_limits("1e3 * abs($1)"); edge = L_max
eval find_limits("1e3 * $2"); top = L_max
largest = 1e-6 * stress
below = 95 # points for the scale
height = 540 * (top + 0.2 * edge) / (2.1 * edge) + below
load "figures/style.gnuplot"

# Cells, an index each: 1, 2: place, 3, 4: displacement, 5: stress of von Mises, in SI
unset border; unset tics; unset grid; unset key
set size ratio -1
set view map; set pm3d corners2color mean
set lmargin at screen 0.02; set rmargin at screen 0.98; set tmargin at screen 0.98; set bmargin at screen real(below) / height
set xrange [-1.05 * edge:1.05 * edge]; set yrange [-0.12 * edge:top + 0.08 * edge]
low = 0; high = largest
set cbrange [low:high]
set colorbox horizontal user origin screen 0.2, screen 62. / height size screen 0.6, screen 10. / height
eval set_few_tics("cb", low, high)
set label 1 "stress of von Mises (MPa)" at screen 0.5, screen 16. / height center
set label 2 "to the orbit's centre" at -1.03 * edge,-0.09 * edge left front font ",13"
set label 3 "outside" at 1.03 * edge,-0.09 * edge right front font ",13"
splot data using (1e3 * ($1 + magnification * $3)):(1e3 * ($2 + magnification * $4)):(1e-6 * $5) with pm3d, \
      data using (1e3 * $1):(1e3 * $2):(0) with lines lw 0.4 lc rgb "#999999"
