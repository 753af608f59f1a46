// The page around the chapters: style, colours for light and dark, and a script that only adds: read-out, sorting,
// dimming.
#include "chapters.hpp"
#include "markup.hpp"

namespace tyndall::bench::report {
namespace {

// Colours after Okabe and Ito, "Color Universal Design" (2008), darkened where they are too light for lines on white;
// the text's own grey for brute force. Each is told from the others by its marker too. No '<' or '&' here: the page is
// XML.
constexpr const char* kStyle = R"(
:root { color-scheme: light dark; --paper:#fff; --ink:#1c1f23; --soft:#5b6470; --line:#d5dae0; --faint:#edf0f3; --band:#f6f8fa; --front:#9aa4af;
  --c0:#d55e00; --c1:#3c434b; --c2:#0072b2; --c3:#b5548f; --c4:#7b3294; --c5:#009e73; --c6:#c98a00; --c7:#3a9bd6; --c8:#8a8a2b; --c9:#8c564b;
  --f0:#8fbbe0; --f1:#f2b98a; --f2:#9fd3bd; --f3:#e3b7d3; --f4:#e8d27a; --f5:#b9b3de; --f6:#c4c9cf; --f7:#d9a79b; }
@media screen and (prefers-color-scheme: dark) { :root { --paper:#14171a; --ink:#e6e9ec; --soft:#9ea8b3; --line:#39414a; --faint:#23292f; --band:#1b2025; --front:#6b7682;
  --c0:#ff8a3c; --c1:#c9d0d7; --c2:#4fa8ea; --c3:#e58fc3; --c4:#b98be0; --c5:#2cc79a; --c6:#f0b429; --c7:#7cc7f5; --c8:#c5c560; --c9:#d0968a;
  --f0:#2f5d86; --f1:#8a5426; --f2:#2b6d55; --f3:#7d4769; --f4:#756418; --f5:#544c8c; --f6:#4c545d; --f7:#7a463a; } }
* { box-sizing:border-box; }
body { margin:0 auto; padding:1.5rem 1.2rem 4rem; max-width:960px; background:var(--paper); color:var(--ink); font:15px/1.5 system-ui,"DejaVu Sans",sans-serif; }
h1 { font-size:1.6rem; line-height:1.25; } h2 { margin:2.6rem 0 .6rem; padding-bottom:.2rem; border-bottom:2px solid var(--line); font-size:1.3rem; }
h3 { margin:1.8rem 0 .5rem; font-size:1.06rem; } h4 { margin:1.2rem 0 .2rem; font-size:.95rem; font-weight:600; }
a { color:var(--c2); } code,pre { font:13px/1.45 ui-monospace,"DejaVu Sans Mono",monospace; } pre { overflow-x:auto; padding:.6rem; background:var(--band); }
dl { display:grid; grid-template-columns:max-content 1fr; gap:.15rem 1rem; } dt { color:var(--soft); } dd { margin:0; overflow-wrap:anywhere; }
nav ul, ul.legend, ul.settings { list-style:none; padding:0; display:flex; flex-wrap:wrap; gap:.15rem 1.1rem; }
ul.legend { margin:.2rem 0 .2rem 58px; font-size:13px; } ul.legend li { white-space:nowrap; }
ul.findings { background:var(--band); border-left:3px solid var(--c2); margin:.8rem 0; padding:.6rem 1rem .6rem 2rem; }
figure { margin:.6rem 0 1.2rem; break-inside:avoid; } figcaption, p.caption { color:var(--soft); font-size:13px; max-width:76ch; margin-top:.3rem; }
.panels { display:flex; flex-wrap:wrap; gap:.5rem 1rem; } .panels div { flex:1 1 400px; min-width:0; }
.scroll { overflow-x:auto; margin:.6rem 0; } .tall { max-height:80vh; overflow-y:auto; border:1px solid var(--line); }
table { border-collapse:collapse; font-size:13px; } caption { text-align:left; font-weight:600; padding:.3rem 0; }
th,td { padding:.22rem .55rem; border-bottom:1px solid var(--line); text-align:left; vertical-align:top; } tbody th { font-weight:500; white-space:nowrap; }
thead th { background:var(--band); font-weight:600; vertical-align:bottom; } .tall thead th { position:sticky; top:0; }
td.number { text-align:right; font-variant-numeric:tabular-nums; white-space:nowrap; } td.none, td small { color:var(--soft); } td.none { text-align:right; }
table.points { font-size:12px; } table.points td { white-space:nowrap; }
.live thead th { cursor:pointer; } th[aria-sort=ascending]::after { content:" ▲"; font-size:.7em; } th[aria-sort=descending]::after { content:" ▼"; font-size:.7em; }
svg.plot { display:block; width:100%; height:auto; font:11px system-ui,"DejaVu Sans",sans-serif; } svg.swatch { vertical-align:-3px; }
.plot text { fill:var(--ink); } .grid { stroke:var(--line); stroke-width:1; } .minor { stroke:var(--faint); } .frame { fill:none; stroke:var(--soft); }
.plot text.tick { fill:var(--soft); } text.x { text-anchor:middle; } text.tick.y { text-anchor:end; } text.axis { font-size:12px; text-anchor:middle; } .plot text.note { fill:var(--soft); }
.c0 { --s:var(--c0); } .c1 { --s:var(--c1); } .c2 { --s:var(--c2); } .c3 { --s:var(--c3); } .c4 { --s:var(--c4); } .c5 { --s:var(--c5); } .c6 { --s:var(--c6); } .c7 { --s:var(--c7); } .c8 { --s:var(--c8); } .c9 { --s:var(--c9); }
.f0 { --s:var(--f0); } .f1 { --s:var(--f1); } .f2 { --s:var(--f2); } .f3 { --s:var(--f3); } .f4 { --s:var(--f4); } .f5 { --s:var(--f5); } .f6 { --s:var(--f6); } .f7 { --s:var(--f7); }
.curve { fill:none; stroke:var(--s); stroke-width:1.6; stroke-linejoin:round; } .front { fill:none; stroke:var(--front); stroke-width:6; stroke-opacity:.45; stroke-linejoin:round; }
.rule { stroke:var(--soft); stroke-width:1.2; stroke-dasharray:3 3; } text.rule { stroke:none; text-anchor:end; fill:var(--soft); font-size:10px; } .reach { stroke:var(--line); stroke-width:3; }
.mark .dot { fill:var(--s); stroke:var(--paper); stroke-width:1; } .mark .bar { fill:none; stroke:var(--s); stroke-width:1.2; } text.name { paint-order:stroke; stroke:var(--paper); stroke-width:3px; stroke-linejoin:round; font-size:10.5px; }
.part rect { fill:var(--s); stroke:var(--paper); stroke-width:1; } text.part { text-anchor:middle; font-size:10.5px; pointer-events:none; }
.dim { opacity:.12; } #tip { position:fixed; display:none; pointer-events:none; white-space:pre-line; max-width:26rem; padding:.4rem .6rem; font-size:12.5px; background:var(--ink); color:var(--paper); border-radius:4px; z-index:9; }
input.filter { font:inherit; font-size:13px; padding:.2rem .4rem; margin-right:.6rem; } button { font:inherit; font-size:13px; }
@media print { body { max-width:none; padding:0; font-size:10pt; } .tall { max-height:none; } .scroll { overflow:visible; } table.points { font-size:5.5pt; } table.points td { white-space:normal; } table.points th, table.points td { padding:1px 2px; }
  h2, h3, h4 { break-after:avoid; } tr { break-inside:avoid; } #tip, input.filter, button, nav { display:none; } * { print-color-adjust:exact; -webkit-print-color-adjust:exact; } }
)";

// Written without '<' and '&' too.
constexpr const char* kScript = R"(
'use strict';
(function () {
  var tip = document.createElement('div'); tip.id = 'tip'; document.body.appendChild(tip);
  document.querySelectorAll('svg.plot title').forEach(function (t) { t.parentNode.setAttribute('data-tip', t.textContent); t.remove(); });
  document.addEventListener('mousemove', function (e) {
    var at = e.target.closest ? e.target.closest('[data-tip]') : null;
    if (!at) { tip.style.display = 'none'; return; }
    tip.textContent = at.getAttribute('data-tip'); tip.style.display = 'block';
    tip.style.left = Math.max(4, Math.min(e.clientX + 14, window.innerWidth - tip.offsetWidth - 8)) + 'px';
    tip.style.top = Math.max(4, Math.min(e.clientY + 14, window.innerHeight - tip.offsetHeight - 8)) + 'px';
  });
  document.querySelectorAll('ul.legend li[data-series]').forEach(function (li) {
    var marks = li.closest('figure').querySelectorAll('svg.plot [data-series]');
    function show(dim) { marks.forEach(function (m) { m.classList.toggle('dim', dim ? m.dataset.series !== li.dataset.series : false); }); }
    li.addEventListener('mouseenter', function () { show(true); });
    li.addEventListener('mouseleave', function () { show(false); });
  });
  function value(row, i) { var c = row.cells[i]; return c.dataset.v === undefined ? c.textContent : c.dataset.v; }
  function compare(a, b) {
    var none = '–', x = Number(a), y = Number(b);
    if (a === none) { return b === none ? 0 : 1; }
    if (b === none) { return -1; }
    return isNaN(x) || isNaN(y) ? a.localeCompare(b, undefined, { numeric: true }) : x - y;
  }
  document.querySelectorAll('table.sortable').forEach(function (table) {
    table.classList.add('live');
    var heads = Array.from(table.tHead.rows[0].cells), body = table.tBodies[0];
    heads.forEach(function (th, i) {
      function sort() {
        var down = th.getAttribute('aria-sort') === 'ascending';
        heads.forEach(function (h) { h.removeAttribute('aria-sort'); });
        th.setAttribute('aria-sort', down ? 'descending' : 'ascending');
        Array.from(body.rows).sort(function (a, b) {
          var x = value(a, i), y = value(b, i);
          if (x === '–' || y === '–') { return compare(x, y); }
          return down ? compare(y, x) : compare(x, y);
        }).forEach(function (r) { body.appendChild(r); });
      }
      th.tabIndex = 0; th.addEventListener('click', sort);
      th.addEventListener('keydown', function (e) { if (e.key === 'Enter') { sort(); } });
    });
  });
  var points = document.querySelector('table.points');
  if (!points) { return; }
  var filter = document.createElement('input'); filter.className = 'filter'; filter.placeholder = 'show rows with all of these words'; filter.size = 36;
  filter.addEventListener('input', function () {
    var words = filter.value.toLowerCase().split(' ');
    Array.from(points.tBodies[0].rows).forEach(function (r) { var t = r.textContent.toLowerCase(); r.hidden = !words.every(function (w) { return t.includes(w); }); });
  });
  var save = document.createElement('button'); save.textContent = 'Save as CSV';
  save.addEventListener('click', function () {
    var rows = Array.from(points.rows).filter(function (r) { return !r.hidden; }).map(function (r) {
      return Array.from(r.cells).map(function (c) { var t = c.classList.contains('number') ? c.dataset.v : c.textContent; return '"' + (t === '–' ? '' : t).replaceAll('"', '""') + '"'; }).join(',');
    });
    var a = document.createElement('a'); a.href = URL.createObjectURL(new Blob([rows.join('\n') + '\n'], { type: 'text/csv' })); a.download = 'points.csv'; a.click(); URL.revokeObjectURL(a.href);
  });
  points.parentNode.before(filter, save);
}());
)";

}  // namespace

std::string page(const std::string& title, const std::string& body) {
  Markup m;
  m.open("html", {{"xmlns", "http://www.w3.org/1999/xhtml"}, {"lang", "en"}})
      .open("head")
      .leaf("meta", {{"charset", "utf-8"}});
  m.leaf("meta", {{"name", "viewport"}, {"content", "width=device-width, initial-scale=1"}}).element("title", title);
  m.open("style").raw(kStyle).close().close();
  m.open("body").element("h1", title).raw(body).open("script").raw(kScript).close().close().close();
  return "<!DOCTYPE html>\n" + m.take() + "\n";
}

}  // namespace tyndall::bench::report
