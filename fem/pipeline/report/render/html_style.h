#pragma once

namespace stemware::pipeline
{

/// The style sheet of all reports: one column that fits a phone, a screen and a sheet of paper, light or dark
/// as the reader's system is. Pictures keep their white ground in the dark.
inline constexpr char html_style[] = R"css(
:root { color-scheme: light dark; --ink: #1c1e21; --soft: #5b6067; --ground: #ffffff; --panel: #f3f5f7; --line: #d5d9de; --accent: #0072b2; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e6e8ea; --soft: #a3a9b1; --ground: #16181b; --panel: #212529; --line: #3a4047; --accent: #6cbcec; }
}
* { box-sizing: border-box; }
html { -webkit-text-size-adjust: 100%; }
body { margin: 0 auto; padding: 1.5rem 1rem 3rem; max-width: 62rem; color: var(--ink); background: var(--ground);
       font: 1rem/1.55 system-ui, -apple-system, "Segoe UI", "DejaVu Sans", sans-serif; overflow-wrap: break-word; }
h1 { font-size: 1.6rem; line-height: 1.25; margin: 0 0 1rem; }
h2 { font-size: 1.2rem; line-height: 1.3; margin: 2.2rem 0 .6rem; }
p { margin: .6rem 0; max-width: 46rem; }
a { color: var(--accent); }
sub, sup { line-height: 0; font-size: .75em; }
.answer { font-size: 1.12rem; max-width: none; padding: .9rem 1.1rem; background: var(--panel); border-left: .3rem solid var(--accent); border-radius: .2rem; }
.notice { padding: .5rem .9rem; border: 1px solid #d55e00; border-radius: .2rem; }
.figures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 26rem), 1fr)); gap: 1.2rem; align-items: start; margin: 1rem 0; }
figure { margin: 0; max-width: 29rem; }
figure > svg { display: block; width: 100%; height: auto; background: #ffffff; border: 1px solid var(--line); border-radius: .2rem; }
figcaption { margin-top: .4rem; font-size: .9rem; }
.files, footer, caption, .missing { color: var(--soft); font-size: .85rem; }
.files { white-space: nowrap; }
.wide { overflow-x: auto; margin: 1rem 0; }
table { border-collapse: collapse; font-size: .92rem; font-variant-numeric: tabular-nums; }
caption { text-align: left; padding-bottom: .35rem; }
th, td { padding: .25rem .8rem .25rem 0; text-align: left; vertical-align: top; border-bottom: 1px solid var(--line); }
th { font-weight: 600; vertical-align: bottom; }
.number { text-align: right; }
td.number, td:first-child { white-space: nowrap; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: .2rem 1rem; margin: .6rem 0; }
dd { margin: 0; }
summary { cursor: pointer; margin: 2.2rem 0 .6rem; }
summary h2 { display: inline; }
footer { margin-top: 3rem; border-top: 1px solid var(--line); padding-top: .6rem; }
@media (max-width: 32rem) {
  body { padding: 1rem .8rem 2rem; }
  h1 { font-size: 1.35rem; }
  .answer { font-size: 1.05rem; padding: .7rem .8rem; }
  dl { grid-template-columns: 1fr; gap: 0; }
  dd { margin: 0 0 .5rem; }
}
@media print {
  :root { color-scheme: light; --ink: #000000; --soft: #444444; --ground: #ffffff; --panel: #ffffff; --line: #999999; --accent: #000000; }
  html { font-size: 9.5pt; }
  body { max-width: none; padding: 0; }
  figure, tr { break-inside: avoid; }
  h2, caption { break-after: avoid; }
  .figures { grid-template-columns: 1fr 1fr; }
  .wide { overflow: visible; }
  .answer { border: 1px solid var(--line); }
  details:not([open]), .files { display: none; }
}
@page { margin: 18mm 16mm; }
)css";

} // namespace stemware::pipeline
