#include "report/page_style.h"

#include <fmt/format.h>

#include "report/markup.h"

namespace mdbd {
namespace {

constexpr std::string_view style = R"(
:root {
  color-scheme: light dark;
  --page: #ffffff; --panel: #f6f7f9; --ink: #1b2129; --soft: #5a6470; --rule: #dfe3e8;
  --grid: #e9ecf0; --band: #f3f5f8; --accent: #1f5fa8;
  --caution: #8a5a00; --caution-panel: #fdf6e6; --caution-rule: #e8c670;
  --right: 31, 95, 168; --wrong: 203, 90, 28; --on-shade: #ffffff;
  --colour-0: #1f6fb5; --colour-1: #d9701a; --colour-2: #2d8a57; --colour-3: #b0408a;
  --colour-4: #1b9aaa; --colour-5: #a47f12; --colour-6: #c0392f; --colour-7: #6b7480;
}
@media (prefers-color-scheme: dark) {
  :root {
    --page: #14181d; --panel: #1c2229; --ink: #e4e8ed; --soft: #9aa5b1; --rule: #333c46;
    --grid: #272e36; --band: #1a2027; --accent: #7db4ea;
    --caution: #e9c46a; --caution-panel: #262113; --caution-rule: #6b5720;
    --right: 84, 150, 219; --wrong: 232, 128, 72; --on-shade: #0d1116;
    --colour-0: #5aa5e6; --colour-1: #f0954a; --colour-2: #5fbf8a; --colour-3: #dc7fbd;
    --colour-4: #4fc6d4; --colour-5: #d3b14a; --colour-6: #ec7168; --colour-7: #a2acb8;
  }
}
* { box-sizing: border-box; }
body {
  margin: 0; background: var(--page); color: var(--ink);
  font: 16px/1.55 system-ui, "Segoe UI", Roboto, "Helvetica Neue", "Noto Sans", "DejaVu Sans", sans-serif;
}
main { max-width: 62rem; margin: 0 auto; padding: 3rem 1.5rem 4rem; }
h1 { margin: 0; font-size: 2rem; line-height: 1.2; font-weight: 650; letter-spacing: -0.015em; overflow-wrap: anywhere; }
h2 { margin: 3.25rem 0 1rem; padding-top: 1rem; border-top: 1px solid var(--rule); font-size: 1.3rem; line-height: 1.3; font-weight: 650; }
p { max-width: 44rem; margin: 0 0 1rem; }
.maker { margin: 0 0 0.5rem; color: var(--accent); font-size: 0.85rem; font-weight: 600; letter-spacing: 0.03em; }
.summary { margin: 1rem 0 0; font-size: 1.15rem; line-height: 1.5; overflow-wrap: anywhere; }
nav ul { display: flex; flex-wrap: wrap; gap: 0.35rem 1.4rem; margin: 1.5rem 0 0; padding: 0; list-style: none; font-size: 0.92rem; }
a { color: var(--accent); text-underline-offset: 0.18em; }
.notes { margin: 1.75rem 0 0; padding: 0.9rem 1.2rem; border: 1px solid var(--caution-rule); border-left-width: 4px; border-radius: 4px; background: var(--caution-panel); font-size: 0.95rem; }
.notes h2 { margin: 0 0 0.3rem; padding: 0; border: 0; color: var(--caution); font-size: 0.95rem; }
.notes ul { margin: 0; padding-left: 1.1rem; }
.notes li { margin: 0.2rem 0; overflow-wrap: anywhere; }
.scroll { overflow-x: auto; margin: 1.5rem 0 2rem; }
table { border-collapse: collapse; font-size: 0.92rem; line-height: 1.4; font-variant-numeric: tabular-nums; }
caption, figcaption { padding: 0; margin: 0 0 0.6rem; text-align: left; font-size: 0.95rem; font-weight: 600; }
caption { padding-bottom: 0.6rem; }
.data th, .data td { padding: 0.32rem 1.6rem 0.32rem 0; text-align: left; vertical-align: top; }
.data th:last-child, .data td:last-child { padding-right: 0.3rem; }
.data thead th { border-bottom: 1.5px solid var(--soft); color: var(--soft); font-weight: 600; vertical-align: bottom; }
.data tbody td { border-bottom: 1px solid var(--rule); overflow-wrap: anywhere; }
.data .number { text-align: right; white-space: nowrap; }
.data tbody tr:hover { background: var(--panel); }
.confusion th, .confusion td { padding: 0.35rem 0.55rem; text-align: right; }
.confusion th { color: var(--soft); font-weight: 600; text-align: left; white-space: nowrap; }
.confusion thead th { vertical-align: bottom; }
.confusion thead .number { padding-left: 1rem; text-align: right; }
.confusion .upright span { display: inline-block; max-height: 9rem; writing-mode: vertical-rl; transform: rotate(180deg); }
.confusion .upright { text-align: center; }
.confusion tbody td { min-width: 2.7rem; border: 2px solid var(--page); text-align: center; }
.confusion tbody td.sum { border-color: transparent; text-align: right; }
.confusion .none { color: var(--soft); background: var(--band); opacity: 0.75; }
.confusion .right { background: rgba(var(--right), calc(0.08 + 0.92 * var(--share))); }
.confusion .wrong { background: rgba(var(--wrong), calc(0.12 + 0.88 * var(--share))); }
.confusion .strong { color: var(--on-shade); font-weight: 600; }
.confusion tfoot td, .confusion tfoot th { color: var(--soft); font-size: 0.85rem; text-align: center; white-space: nowrap; }
.confusion tfoot th { text-align: left; }
.confusion tfoot .sum:nth-last-child(-n+2) { text-align: right; }
.slim th, .slim td { padding: 0.12rem 0.3rem; font-size: 0.8rem; }
.slim tbody td { min-width: 1.85rem; border-width: 1px; }
.slim .none { opacity: 0.5; }
.slim tfoot td { font-size: 0.72rem; }
figure { margin: 1.5rem 0 2.25rem; }
svg { display: block; max-width: 100%; height: auto; overflow: visible; }
svg text { fill: var(--soft); font-size: 12px; }
.grid { stroke: var(--grid); } .base { stroke: var(--soft); } .band { fill: var(--band); }
.boundary { stroke: var(--page); fill: none; stroke-width: 1; stroke-opacity: 0.75; }
.line { fill: none; stroke: currentColor; stroke-width: 2; stroke-linecap: round; stroke-linejoin: round; }
circle { fill: var(--page); stroke: currentColor; stroke-width: 2; }
.bar rect, path.bar { fill: currentColor; }
image { image-rendering: pixelated; }
.legend { display: flex; flex-wrap: wrap; gap: 0.2rem 1.4rem; margin: 0 0 0.9rem; padding: 0; list-style: none; font-size: 0.88rem; }
.legend li { display: flex; align-items: center; gap: 0.5rem; }
.legend span { color: var(--ink); }
.colour-0 { color: var(--colour-0); } .colour-1 { color: var(--colour-1); } .colour-2 { color: var(--colour-2); }
.colour-3 { color: var(--colour-3); } .colour-4 { color: var(--colour-4); } .colour-5 { color: var(--colour-5); }
.colour-6 { color: var(--colour-6); } .colour-7 { color: var(--colour-7); }
.dash-1 .line { stroke-dasharray: 9 5; } .dash-2 .line { stroke-dasharray: 1.5 5; }
.dash-3 .line { stroke-dasharray: 11 5 1.5 5; } .dash-4 .line { stroke-dasharray: 5 4; }
.nothing { color: var(--soft); font-style: italic; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: 0.35rem 1.6rem; margin: 0; font-size: 0.9rem; }
dt { color: var(--soft); } dd { margin: 0; overflow-wrap: anywhere; font-family: ui-monospace, "DejaVu Sans Mono", Menlo, Consolas, monospace; font-size: 0.85rem; }
@media (max-width: 40rem) {
  main { padding: 1.75rem 1rem 3rem; } h1 { font-size: 1.6rem; }
  dl { grid-template-columns: 1fr; gap: 0; } dd { margin-bottom: 0.6rem; }
}
@media print {
  :root {
    color-scheme: light;
    --page: #ffffff; --panel: #ffffff; --ink: #000000; --soft: #444b54; --rule: #c8cdd3; --grid: #e2e6ea;
    --band: #f1f3f6; --accent: #1f5fa8; --caution: #6b4600; --caution-panel: #ffffff; --caution-rule: #b58a2a;
    --right: 31, 95, 168; --wrong: 203, 90, 28; --on-shade: #ffffff;
    --colour-0: #1f6fb5; --colour-1: #d9701a; --colour-2: #2d8a57; --colour-3: #b0408a;
    --colour-4: #1b9aaa; --colour-5: #a47f12; --colour-6: #c0392f; --colour-7: #6b7480;
  }
  @page { margin: 18mm 16mm; }
  * { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
  body { font-size: 10.5pt; } main { max-width: none; padding: 0; } nav { display: none; }
  h2 { margin-top: 2rem; break-after: avoid; } .scroll { overflow: visible; }
  figure, .notes, .confusion, tr { break-inside: avoid; } caption, figcaption { break-after: avoid; }
  thead { display: table-header-group; }
}
)";

}  // namespace

std::string_view page_style() { return style; }

std::string page_head(std::string_view title, std::string_view more_style) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
      "<title>{}</title>\n<style>{}{}</style>\n</head>\n",
      escape_markup(title), page_style(), more_style);
}

}  // namespace mdbd
