#include "provers/report/page.h"

namespace tact::provers {

// Neither text holds & or <, which XML and HTML would read differently inside <style> and <script>.
const char* const kPageStyle = R"css(
:root { color-scheme: light dark; --paper: #fdfcf9; --ink: #1d1c1a; --soft: #5d5a54; --line: #dcd8cf; --card: #f6f3ec;
  --link: #1a4f8a; --proved: #14532d; --proved-bg: #d9f2de; --holds: #0b4f5c; --holds-bg: #d3eef2; --refuted: #7f1d1d;
  --refuted-bg: #fbdcd8; --reproduced: #1e3a8a; --reproduced-bg: #dde6fb; --not-reproduced: #7a3e00;
  --not-reproduced-bg: #fde6c8; --undecided: #44403c; --undecided-bg: #e7e5e0; }
@media (prefers-color-scheme: dark) { :root { --paper: #191a1c; --ink: #e6e3dc; --soft: #a6a299; --line: #38393c;
  --card: #222326; --link: #8ab8ee; --proved: #a7e8b8; --proved-bg: #143a22; --holds: #9fe0ec; --holds-bg: #0d3a43;
  --refuted: #ffb9b0; --refuted-bg: #541b18; --reproduced: #b9cdfd; --reproduced-bg: #1f2f5c; --not-reproduced: #fdcf95;
  --not-reproduced-bg: #4d2c08; --undecided: #d4d0c8; --undecided-bg: #3a3937; } }
* { box-sizing: border-box; }
html { scroll-padding-top: 1rem; }
body { margin: 0 auto; padding: 2.5rem 1.25rem 5rem; max-width: 46rem; background: var(--paper); color: var(--ink);
  font: 1.0625rem/1.6 Charter, "Bitstream Charter", "Sitka Text", Cambria, Georgia, serif; overflow-wrap: break-word; }
h1, h2, h3, h4 { line-height: 1.25; }
h1 { font-size: 2.4rem; margin: 0; letter-spacing: -0.01em; }
h2 { font-size: 1.55rem; margin: 4rem 0 0.5rem; padding-bottom: 0.4rem; border-bottom: 2px solid var(--ink); }
h3 { font-size: 1.15rem; margin: 2.2rem 0 0.8rem; color: var(--soft); font-weight: 600; }
.statement { font-size: 1.2rem; margin: 0.7rem 0 0.6rem; color: var(--ink); }
p { margin: 0.7rem 0; }
a { color: var(--link); text-underline-offset: 0.15em; }
.lead { font-size: 1.2rem; color: var(--soft); margin: 0.4rem 0 1.4rem; }
.small, small { color: var(--soft); font-size: 0.85rem; }
code, pre, .id, .certificates ul { font-family: ui-monospace, "DejaVu Sans Mono", Menlo, Consolas, monospace; font-size: 0.85em; }
pre { overflow-x: auto; padding: 0.7rem 0.9rem; background: var(--card); border-left: 3px solid var(--line); line-height: 1.45; }
.chip, dt, table, figcaption, .certificates b, summary, .filter { font-family: system-ui, "Noto Sans", "DejaVu Sans", Helvetica, Arial, sans-serif; }
.chip { display: inline-block; padding: 0 0.6em; border: 1px solid currentColor; border-radius: 1em; font-size: 0.78rem;
  line-height: 1.6; font-weight: 600; white-space: nowrap; }
.chip.proved { color: var(--proved); background: var(--proved-bg); }
.chip.holds { color: var(--holds); background: var(--holds-bg); }
.chip.refuted { color: var(--refuted); background: var(--refuted-bg); }
.chip.reproduced { color: var(--reproduced); background: var(--reproduced-bg); }
.chip.not-reproduced { color: var(--not-reproduced); background: var(--not-reproduced-bg); }
.chip.undecided { color: var(--undecided); background: var(--undecided-bg); border-style: dashed; }
.counts { list-style: none; display: flex; flex-wrap: wrap; gap: 0.5rem 1.5rem; padding: 0; margin: 1.6rem 0 0.4rem; }
.counts b { font-size: 1.7rem; margin-right: 0.15rem; font-variant-numeric: tabular-nums; vertical-align: -0.1em; }
nav h2 { margin-top: 2.5rem; }
nav h3 { color: var(--ink); margin: 1.8rem 0 0.3rem; }
nav h4 { font-size: 0.95rem; font-weight: 600; color: var(--soft); margin: 0.9rem 0 0.2rem; }
nav ul { list-style: none; margin: 0; padding: 0; }
nav li { display: grid; grid-template-columns: 9.2rem 1fr; gap: 0.8rem; align-items: baseline; padding: 0.28rem 0; line-height: 1.45; }
nav li .chip { justify-self: start; }
nav li a { color: inherit; text-decoration-color: var(--line); }
.filter { display: flex; flex-wrap: wrap; gap: 0.6rem; margin: 0.8rem 0; font-size: 0.9rem; }
.filter input, .filter select { font: inherit; color: inherit; background: var(--card); border: 1px solid var(--line); border-radius: 0.4rem; padding: 0.3rem 0.6rem; }
.filter input { flex: 1 1 14rem; }
[hidden] { display: none !important; }
.legend { margin: 0.8rem 0; font-size: 0.92rem; }
summary { cursor: pointer; color: var(--soft); font-size: 0.88rem; }
.legend div { display: grid; grid-template-columns: 9.2rem 1fr; gap: 0.8rem; padding: 0.15rem 0; }
.legend dd { margin: 0; }
.claim { margin: 1.4rem 0 2.6rem; padding: 1.1rem 0 0; border-top: 1px solid var(--line); }
.claim:target { outline: 3px solid var(--line); outline-offset: 0.8rem; }
.claim header { display: flex; flex-wrap: wrap; gap: 0.3rem 0.9rem; align-items: baseline; }
.claim .id { color: var(--soft); text-decoration: none; }
.claim dl { display: flex; flex-wrap: wrap; gap: 0.35rem 1.8rem; margin: 0 0 0.9rem; font-size: 0.92rem; }
.claim dl dt { font-size: 0.7rem; letter-spacing: 0.06em; text-transform: uppercase; color: var(--soft); }
.claim dl dd { margin: 0; line-height: 1.4; }
table { border-collapse: collapse; font-size: 0.85rem; line-height: 1.45; margin: 0.4rem 0; }
caption { text-align: left; color: var(--soft); padding: 0.3rem 0; font-size: 0.82rem; }
th, td { text-align: left; vertical-align: top; padding: 0.28rem 1.1rem 0.28rem 0; border-bottom: 1px solid var(--line); }
thead th, thead th.number { border-bottom: 1.5px solid var(--ink); vertical-align: bottom; white-space: normal; }
tbody th { font-weight: 400; }
th:last-child, td:last-child { padding-right: 0.2rem; }
.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
th.number + th:not(.number), td.number + td:not(.number) { padding-left: 0.6rem; }
.scroll { overflow: auto; max-height: 32rem; margin: 1rem 0; }
.scroll:focus-visible, a:focus-visible, summary:focus-visible { outline: 2px solid var(--link); outline-offset: 2px; }
.scroll thead th { position: sticky; top: 0; background: var(--paper); }
.figures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 19rem), 1fr)); gap: 1.2rem; margin: 1.4rem 0; align-items: end; }
figure { margin: 0; min-width: 0; }
.drawing { color-scheme: light; background: #fffefb; color: #1d1c1a; border: 1px solid var(--line); border-radius: 0.5rem; padding: 0.8rem; text-align: center; overflow-x: auto; }
.drawing svg { display: block; margin: 0 auto; max-width: 100%; height: auto; }
figcaption { font-size: 0.85rem; color: var(--soft); margin-top: 0.5rem; line-height: 1.45; }
.certificates { margin: 1rem 0 0; font-size: 0.92rem; }
.certificates b { font-size: 0.85rem; }
.certificates ul { margin: 0.2rem 0; padding-left: 1.2rem; }
@media (max-width: 34rem) { nav li, .legend div { grid-template-columns: 1fr; gap: 0.1rem; } h1 { font-size: 1.9rem; } }
@media print { :root { color-scheme: light; --paper: #fff; --ink: #000; --soft: #444; --line: #bbb; --card: #fff; --link: #000;
  --proved: #000; --proved-bg: #fff; --holds: #000; --holds-bg: #fff; --refuted: #000; --refuted-bg: #fff; --reproduced: #000;
  --reproduced-bg: #fff; --not-reproduced: #000; --not-reproduced-bg: #fff; --undecided: #000; --undecided-bg: #fff; }
  body { max-width: none; padding: 0; font-size: 10.5pt; } .filter { display: none; } .scroll { max-height: none; overflow: visible; }
  h2, h3, h4, .claim header { break-after: avoid; } figure, tr, .claim dl { break-inside: avoid; } h2 { margin-top: 2rem; } }
)css";

// Shows the filter (a page without scripts does without) and hides what it does not ask for.
const char* const kPageScript = R"js(
(function () {
  var form = document.querySelector(".filter");
  if (!form) return;
  form.hidden = false;
  var text = form.querySelector("input"), verdict = form.querySelector("select"), said = form.querySelector("output");
  function matches(article, words) {
    if (verdict.value !== "" ? !article.classList.contains(verdict.value) : false) return false;
    var content = article.textContent.toLowerCase();
    return words.every(function (word) { return content.includes(word); });
  }
  function apply() {
    var words = text.value.toLowerCase().split(/\s+/).filter(Boolean), shown = 0;
    document.querySelectorAll("article").forEach(function (article) {
      article.hidden = !matches(article, words);
      if (!article.hidden) shown += 1;
      document.querySelectorAll("nav li").forEach(function (item) {
        if (item.querySelector("a").getAttribute("href") === "#" + article.id) item.hidden = article.hidden;
      });
    });
    said.textContent = shown + " shown";
    document.querySelectorAll("nav section, main section").forEach(function (group) {
      group.hidden = !group.querySelector("li:not([hidden]), article:not([hidden])");
    });
  }
  form.addEventListener("input", apply);
  form.addEventListener("submit", function (event) { event.preventDefault(); });
})();
)js";

}  // namespace tact::provers
