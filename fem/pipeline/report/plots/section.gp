# Section of the foot with its cells, whose edges are drawn straight.
#@data section
line = 0.075 * edge # between two lines of lengths
height = 540 * (top + 3.9 * line) / (1.4 * edge)
load "figures/style.gnuplot"

# The cells, lengths in mm
unset border; unset tics; unset grid; unset key
set lmargin 0; set rmargin 0; set tmargin 0; set bmargin 0
set size ratio -1
set xrange [-0.06 * edge:1.34 * edge]; set yrange [-2.6 * line:top + 1.3 * line]
thin = 'nohead lw 0.6 lc rgb "#777777"'
set arrow from -0.05 * edge,0 to 1.1 * edge,0 @thin dt 1
set arrow from 0,-2.4 * line to 0,top + line @thin dt (12,4,2,4)
set arrow from radius,0 to radius,-1.1 * line @thin dt 1
set arrow from edge,0 to edge,-2.1 * line @thin dt 1
set arrow from stem,top to 1.14 * edge,top @thin dt (2,4)
both = 'heads size screen 0.008,20 filled front lw 0.8 lc rgb "#333333"'
set arrow from 0,-line to radius,-line @both
set label "R = " . length_text(radius) at radius / 2,-0.62 * line center front font ",13"
set arrow from 0,-2 * line to edge,-2 * line @both
set label "foot " . length_text(edge) at radius / 2,-1.62 * line center front font ",13"
set arrow from 1.12 * edge,0 to 1.12 * edge,top @both
set label length_text(top) at 1.135 * edge,top / 2 left front font ",13"
set arrow from radius,0 to radius,thickness @both
set label length_text(thickness) at radius,thickness + 0.5 * line center front font ",13"
set label "cut, held" at 0.03 * edge,top + 0.55 * line left front font ",13"
set arrow from 0,top to stem,top nohead front lw 3 lc rgb "#333333"
set label "table" at 1.03 * edge,-0.5 * line left font ",13"
if (crown > 0) set label "crown " . length_text(crown) at edge + 0.4 * line,-1.9 * line left font ",13"
set style fill solid 1.0 border lc rgb "#4a8fc0"
plot data with filledcurves closed fc rgb "#dcebf7" lw 0.5
