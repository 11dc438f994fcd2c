#pragma once

namespace stemware::pipeline
{

/// figures/style.gnuplot: what all plots have in common. Colours are those of Okabe and Ito, which people
/// who see red and green alike can tell apart; line types differ in their dashes too.
inline constexpr char gnuplot_style[] = R"gp(# What all figures have in common; each of them loads this file.
# format = "pdf" draws the PDF instead of the SVG. The figure sets name, width and height, and reads data.
reset
if (!exists("format")) format = "svg"
set encoding utf8
if (format eq "pdf") {
  set terminal pdfcairo noenhanced color font "Sans,10" linewidth 1 size width / 108.,height / 108.
} else {
  set terminal svg noenhanced font "sans-serif,15" linewidth 1.2 background rgb "white" size width,height
}
set termoption enhanced
set output "figures/" . name . "." . format
data = "figures/" . name . ".dat"

set linetype 1 lc rgb "#0072b2" lw 2 dt 1 pt 7 ps 0.6          # blue
set linetype 2 lc rgb "#d55e00" lw 2 dt (9,4) pt 5 ps 0.6      # vermillion
set linetype 3 lc rgb "#009e73" lw 2 dt (9,3,2,3) pt 9 ps 0.7  # bluish green
set linetype 4 lc rgb "#cc79a7" lw 2 dt (3,3) pt 13 ps 0.7     # reddish purple
set linetype 5 lc rgb "#e69f00" lw 2 dt (14,4) pt 11 ps 0.7    # orange
set linetype 6 lc rgb "#56b4e9" lw 2 dt (5,2,2,2,2,2) pt 6 ps 0.7 # sky blue
set linetype 7 lc rgb "#000000" lw 1 dt 1 pt 2 ps 0.7
set linetype 8 lc rgb "#777777" lw 1 dt 1 pt 1 ps 0.7
set linetype cycle 8
# Light to dark at even steps of lightness, blue to yellow as in cividis.
set palette defined (0 "#00204d", 1 "#31446b", 2 "#666970", 3 "#958f78", 4 "#cbba69", 5 "#ffea46")

set minussign
set border 3 lw 0.8 lc rgb "#333333"
set tics nomirror scale 0.6
set grid lt -1 lw 0.5 lc rgb "#dddddd"
set key tmargin left horizontal reverse Left samplen 2.2 spacing 1.2 width 1 # above the plot, never on a curve
# The SVG terminal takes texts for wider than they are.
if (format eq "svg") set key width -3
)gp";

} // namespace stemware::pipeline
