below = 95 # points for the scale
height = 540 * (top + 0.2 * edge) / (2.1 * edge) + below
load "figures/style.gnuplot"

# Cells, an index each: 1, 2: place (mm), 3, 4: where it goes, enlarged, 5: stress of von Mises (MPa)
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
splot data using 3:4:5 with pm3d, data using 1:2:(0) with lines lw 0.4 lc rgb "#999999"
