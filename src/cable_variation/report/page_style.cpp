#include <cable_variation/report/page_style.h>

namespace cable_variation {

const char* const kPageStyle = R"(
:root { color-scheme: light dark;
  --paper: #fff; --ink: #16181d; --muted: #555b66; --rule: #d5d9e0; --faint: #8a919c; --accent: #2678b2;
  --bar: #8db8d6; --bad: #b00020; --good: #176b35; --doubtful: #8a5200; --bad-paper: #fdecee;
  --good-paper: #e7f5ec; --doubtful-paper: #fff4d6; --line-1: #0072b2; --line-2: #d55e00; }
@media screen and (prefers-color-scheme: dark) { :root {
  --paper: #15171c; --ink: #e4e7ec; --muted: #a3abb8; --rule: #363b45; --faint: #7d8593; --accent: #5aa9e0;
  --bar: #3f79a3; --bad: #ff7a85; --good: #6fd391; --doubtful: #f0bd5b; --bad-paper: #3d1a20;
  --good-paper: #15321f; --doubtful-paper: #3a2e12; --line-1: #56b4e9; --line-2: #e69f00; } }
body { font: 15px/1.5 sans-serif; color: var(--ink); background: var(--paper); max-width: 76em; margin: 2em auto;
  padding: 0 1.5em; }
h1 { font-size: 1.9em; line-height: 1.2; margin: 0 0 .4em; }
h2 { font-size: 1.4em; border-bottom: 2px solid var(--accent); padding-bottom: .15em; margin: 1.8em 0 .6em; }
h3 { font-size: 1.1em; margin: 1.5em 0 .4em; }
a { color: var(--accent); }
dl.about { display: grid; grid-template-columns: max-content 1fr; gap: 0 1.2em; margin: 0 0 1em; font-size: .92em; }
dl.about dt { color: var(--muted); }
dl.about dd { margin: 0; overflow-wrap: anywhere; }
nav ol { display: flex; flex-wrap: wrap; gap: .1em 2.4em; padding-left: 1.3em; margin: 1em 0; }
.scroll { overflow-x: auto; margin: .8em 0; }
table { border-collapse: collapse; font-size: .88em; font-variant-numeric: tabular-nums; }
caption { text-align: left; color: var(--muted); padding-bottom: .3em; }
th, td { padding: .25em .7em; border-bottom: 1px solid var(--rule); text-align: right; vertical-align: bottom;
  white-space: nowrap; }
th:first-child, .words, td.text { text-align: left; }
td.text { white-space: normal; min-width: 18em; vertical-align: top; }
p { max-width: 62em; }
thead th { border-bottom: 2px solid var(--ink); }
tbody th { font-weight: normal; }
.out { color: var(--bad); font-weight: bold; }
.good { color: var(--good); font-weight: bold; }
.doubtful { color: var(--doubtful); font-weight: bold; }
.bad { color: var(--bad); font-weight: bold; }
.banner { max-width: none; padding: .5em .9em; border-left: 6px solid currentColor; font-size: 1.1em;
  font-weight: normal; }
.banner strong { margin-right: .5em; letter-spacing: .04em; }
.banner.good { background: var(--good-paper); }
.banner.doubtful { background: var(--doubtful-paper); }
.banner.bad { background: var(--bad-paper); }
.warning { background: var(--doubtful-paper); border-left: 4px solid var(--doubtful); padding: .5em .8em;
  max-width: none; overflow-wrap: anywhere; }
figure { display: inline-block; box-sizing: border-box; vertical-align: top; margin: .6em 0; padding-right: 1.2em;
  break-inside: avoid; }
figure.third { width: calc(33.3% - .4em); }
figure.half { width: calc(50% - .4em); }
figure.full { width: 100%; padding-right: 0; }
figure.full svg { max-width: 60em; }
figcaption { font-size: .85em; color: var(--muted); }
svg { display: block; width: 100%; height: auto; }
svg text { font: 12px sans-serif; fill: var(--ink); }
@media (max-width: 70em) { figure.third { width: calc(50% - .4em); } }
@media (max-width: 46em) {
  body { margin: 1em auto; padding: 0 .9em; }
  h1 { font-size: 1.5em; }
  figure, figure.third, figure.half { width: 100%; padding-right: 0; }
  table { font-size: .78em; }
  th, td { padding: .25em .32em; }
  td.words { white-space: normal; }
}
@media print {
  body { font-size: 9.5pt; margin: 0; max-width: none; padding: 0; }
  h1 { font-size: 1.7em; }
  h2 { margin: 1.2em 0 .4em; }
  .scroll { overflow-x: visible; margin: .5em 0; }
  table { font-size: 7pt; }
  th, td { white-space: normal; padding: .2em .4em; }
  td.text { min-width: 0; }
  figure.third, figure.half { width: calc(50% - .4em); padding-right: 3mm; margin: 1mm 0; }
  figure.full svg { max-width: 125mm; }
  h2, h3, caption { break-after: avoid; }
  tr, .banner, .warning, dl.about { break-inside: avoid; }
  * { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
}
@page { size: A4; margin: 14mm 16mm; }
)";

}  // namespace cable_variation
