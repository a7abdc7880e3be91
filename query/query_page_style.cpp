#include "query/query_page_style.h"

namespace mdbd {
namespace {

constexpr std::string_view style = R"(
main.query { max-width: 72rem; }
.asked { display: flex; flex-wrap: wrap; align-items: center; gap: 1rem 1.5rem; margin: 0 0 1.5rem; }
.asked .look { width: 12rem; border-color: var(--accent); }
.asked p { margin: 0.15rem 0; overflow-wrap: anywhere; }
.matches { display: grid; grid-template-columns: repeat(auto-fill, minmax(11rem, 1fr)); gap: 1.5rem 1.1rem; margin: 0; padding: 0; list-style: none; }
.matches li { min-width: 0; break-inside: avoid; }
.look { display: block; width: 100%; padding: 0.5rem; border: 1px solid var(--rule); border-radius: 8px; background: var(--panel); color: inherit; font: inherit; cursor: pointer; }
.look:hover { border-color: var(--accent); }
.look:focus-visible, dialog button:focus-visible, canvas:focus-visible { outline: 2px solid var(--accent); outline-offset: 2px; }
.look img { display: block; width: 100%; max-width: 160px; height: auto; margin: 0 auto; aspect-ratio: 1; }
.gauge { height: 3px; margin: 0.55rem 0 0.4rem; border-radius: 2px; background: var(--grid); }
.gauge span { display: block; width: calc(100% * var(--share)); height: 100%; border-radius: 2px; background: var(--accent); }
.facts { display: flex; justify-content: space-between; gap: 0.5rem; margin: 0; font-variant-numeric: tabular-nums; }
.facts .rank { color: var(--soft); }
.name { margin: 0; font-weight: 600; line-height: 1.35; overflow-wrap: anywhere; }
.soft { margin: 0; color: var(--soft); font-size: 0.85rem; line-height: 1.4; overflow-wrap: anywhere; }
h3 { margin: 2.25rem 0 0.5rem; font-size: 1.05rem; }
details { border-top: 1px solid var(--rule); }
details:last-of-type { border-bottom: 1px solid var(--rule); }
summary { padding: 0.55rem 0; cursor: pointer; overflow-wrap: anywhere; font-variant-numeric: tabular-nums; }
summary .soft { display: inline; margin-left: 0.6rem; }
dialog { width: min(64rem, 94vw); max-height: 94vh; padding: 1.2rem 1.4rem 1.4rem; border: 1px solid var(--rule); border-radius: 10px; background: var(--page); color: var(--ink); }
dialog::backdrop { background: rgba(8, 12, 18, 0.55); }
dialog .top { display: flex; justify-content: space-between; align-items: baseline; gap: 1rem; }
dialog .top p { margin: 0; }
dialog button { padding: 0.3rem 0.9rem; border: 1px solid var(--rule); border-radius: 6px; background: var(--panel); color: var(--ink); font: inherit; cursor: pointer; }
.pair { display: grid; grid-template-columns: repeat(auto-fit, minmax(16rem, 1fr)); gap: 1rem; margin-top: 0.9rem; }
.pair figure { margin: 0; } .pair figcaption { margin: 0 0 0.4rem; overflow-wrap: anywhere; }
.pair [hidden] { display: none; }
canvas { display: block; width: 100%; aspect-ratio: 1; border-radius: 8px; background: var(--panel); cursor: grab; touch-action: none; }
canvas:active { cursor: grabbing; }
@media print {
  main.query { max-width: none; } .matches { grid-template-columns: repeat(5, 1fr); gap: 1rem 0.7rem; }
  .look { background: none; } .asked .look { width: 9rem; }
}
)";

}  // namespace

std::string_view query_page_style() { return style; }

}  // namespace mdbd
