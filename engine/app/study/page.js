// Draws the report: an overview, then for each subject its pictures, its plots and what they say.
"use strict";
const report = JSON.parse(document.getElementById("report").textContent);

// ---- Words ----
function make(name, attributes = {}, ...inside) {
  const svg = ["svg", "g", "path", "line", "circle", "text", "rect"].includes(name);
  const e = svg ? document.createElementNS("http://www.w3.org/2000/svg", name) : document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) e.setAttribute(key, value);
  e.append(...inside);
  return e;
}
const digits = (x, n) => x === 0 ? "0" : Number(x.toPrecision(n)).toLocaleString("en", { maximumSignificantDigits: n, useGrouping: false });
const brief = x => x >= 999500 ? digits(x / 1e6, 3) + "M" : x >= 9995 ? digits(x / 1e3, 3) + "k" : digits(x, 3);
const time = ms => ms >= 999.5 ? digits(ms / 1e3, 3) + " s" : digits(ms, 3) + " ms";
const isShare = curve => curve.error_unit.startsWith("relative");
const isTimed = curve => curve.error_unit === "hits"; // no picture: its law is the time's
const ofRay = ns => (ns >= 999500 ? digits(ns / 1e6, 3) + " ms" : ns >= 999.5 ? digits(ns / 1e3, 3) + " \u00b5s" : digits(ns, 3) + " ns") + " a ray";
const price = (curve, ms) => curve.clock.endsWith("million_rays") ? ofRay(ms) : time(ms);
const amount = (curve, e) => !isShare(curve) ? digits(e, 2) : e < 5e-6 ? "below 0.001 %" : (100 * e).toFixed(e < 0.00005 ? 3 : e < 0.01 ? 2 : e < 0.1 ? 1 : 0) + " %";
const wrong = (curve, p) => p.error === null ? "" : isTimed(curve) ? digits(100 * p.error, 2) + " %" : p.error > p.noise ? amount(curve, p.error) : "less than can be told" + (p.noise > 0 ? ` (noise ${amount(curve, p.noise)})` : "");
const clocks = { gpu_passes: "GPU time of its passes", gpu_frame: "GPU time of a frame", gpu_frames: "GPU time of all frames", cpu_bake: "CPU time of the bake", cpu_truth: "CPU time of the picture", cpu_making: "CPU time of the picture", cpu_million_rays: "CPU time of a million rays", gpu_million_rays: "GPU time of a million rays" };
const valueName = (curve, p) => isTimed(curve) ? `${curve.knob}, ${p.name} ${curve.unit}` : curve.knob + " " + p.name;
const inSpace = p => p.bytes === undefined ? "" : `, 95 of 100 below ${digits(100 * p.error_high, 3)} %, worst ${digits(100 * p.error_worst, 3)} %, ` + (p.leak === null ? "" : `leak ${digits(100 * p.leak, 2)} %, `) + `${digits(p.bytes / 1000, 3)} kB`;
const standardOf = curve => curve.points.find(p => p.default) || curve.points[curve.points.length - 1];

// ---- Axes ----
const held = (v, low, high) => Math.min(Math.max(v, low), high);
function scaleOf(values, from, to) { // logarithmic, a little wider than what it shows; a knob's zeros lie at its low end
  const real = values.filter(v => v > 0);
  let low = Math.min(...real), high = Math.max(...real);
  if (!real.length) low = 0.1, high = 1;
  const room = Math.max(Math.log(high / low) * 0.1, 0.12);
  low *= Math.exp(-room), high *= Math.exp(room);
  const place = v => from + (to - from) * Math.log(Math.max(v, low) / low) / Math.log(high / low);
  return { low, high, place };
}
function ticksOf({ low, high }) {
  const ticks = [];
  if (high / low < 8) {
    const unit = 10 ** Math.floor(Math.log10(high - low));
    const step = [1, 0.5, 0.2, 0.1].map(k => k * unit).find(s => Math.floor(high / s) - Math.ceil(low / s) >= 2);
    for (let v = Math.ceil(low / step) * step; v <= high; v += step) ticks.push(v);
    return ticks;
  }
  const every = high / low < 300 ? [1, 2, 5] : high / low < 3000 ? [1, 3] : [1];
  for (let decade = Math.floor(Math.log10(low)); decade <= Math.log10(high); ++decade)
    for (const k of every) if (k * 10 ** decade >= low && k * 10 ** decade <= high) ticks.push(k * 10 ** decade);
  return ticks;
}

// ---- Names of points ----
const kWide = 520, kHigh = 330, kLeft = 62, kRight = 18, kTop = 12, kBottom = 46;
const kNone = 34; // px, of the row below the break of the error's axis: what has no error is on no logarithmic scale
const kLine = 12; // px, of a name's height
const kSides = [[1, -1], [1, 0], [1, 1], [-1, -1], [-1, 0], [-1, 1], [0, -1], [0, 1], [1, -2], [1, 2], [-1, -2], [-1, 2]]; // of a mark, in columns and lines; the first is liked best
const kFar = 2; // lines that a name may lie on before it goes two of its own away from its mark
const pen = document.createElement("canvas").getContext("2d");
pen.font = "11px system-ui, sans-serif"; // as .name
function boxAt({ at, words, reach }, [dx, dy]) {
  const wide = pen.measureText(words).width + 2, slant = dx && dy ? 0.7 : 1;
  const x = at[0] + dx * (slant * reach + 3) - (dx < 0 ? wide : dx ? 0 : wide / 2), y = at[1] + dy * kLine + Math.sign(dy) * (slant * reach - 4);
  return { left: x, right: x + wide, top: y - kLine / 2, bottom: y + kLine / 2, far: Math.abs(dy) > 1 ? kFar : 0 };
}
const apart = (a, b) => a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top;
const covers = (box, { at, reach }) => Math.hypot(held(at[0], box.left, box.right) - at[0], held(at[1], box.top, box.bottom) - at[1]) < reach;
function crosses(box, [[ax, ay], [bx, by]]) { // the part of the line within the box's width, against its height
  const [u, v] = ax === bx ? [0, 1] : [(box.left - ax) / (bx - ax), (box.right - ax) / (bx - ax)].sort((a, b) => a - b).map(t => held(t, 0, 1));
  if (u === v || ax === bx && (ax < box.left || ax > box.right)) return false;
  const ends = [ay + u * (by - ay), ay + v * (by - ay)];
  return Math.max(...ends) > box.top && Math.min(...ends) < box.bottom;
}
// A box for each name, beside its mark and off all others, those of names that come first included; off lines where that can be had. Whose
// mark has no such place has no box: it is read by pointing at it.
function placesOf(names, marks, lines) {
  const taken = [];
  return names.map(name => {
    const free = kSides.map(side => boxAt(name, side)).filter(box => box.left > kLeft && box.right < kWide && box.top > 0 && box.bottom < kHigh - kBottom + 4
      && taken.every(other => apart(box, other)) && !marks.some(mark => covers(box, mark)));
    const costs = free.map(box => box.far + lines.filter(line => crosses(box, line)).length);
    const best = free[costs.indexOf(Math.min(...costs))];
    if (best) taken.push(best);
    return best;
  });
}

// ---- One chart: the curves that are held against one truth and timed by one clock ----
function plot(curves, byKnob, pick, colours) {
  const timed = isTimed(curves[0]), x = curve => p => byKnob ? p.value : p.ms, y = p => timed ? p.ms : Math.max(p.error, p.noise); // what cannot be told lies at its noise
  const across = c => byKnob ? c.points.map(p => p.value) : c.points.flatMap(p => [p.ms - p.ms_spread / 2, p.ms, p.ms + p.ms_spread / 2]);
  const xs = scaleOf(curves.flatMap(across), kLeft, kWide - kRight);
  const heights = curves.flatMap(c => c.points.map(y)), broken = heights.some(v => v > 0) && heights.includes(0);
  const ys = scaleOf(heights, kHigh - kBottom - (broken ? kNone : 0), kTop), none = kHigh - kBottom - (broken ? kNone / 3 : 0);
  const placed = (curve, p) => [xs.place(x(curve)(p)), y(p) > 0 ? ys.place(y(p)) : none];
  const first = curves[0], percent = isShare(first) ? 100 : 1;
  const svg = make("svg", { viewBox: `0 0 ${kWide} ${kHigh}`, role: "group", "aria-label": (timed ? "time" : "error") + " against " + (byKnob ? "the knob" : "time") });
  for (const t of ticksOf(xs)) {
    const at = xs.place(t);
    svg.append(make("line", { class: "grid", x1: at, x2: at, y1: kTop, y2: kHigh - kBottom }));
    svg.append(make("text", { x: at, y: kHigh - kBottom + 17, "text-anchor": "middle" }, brief(t)));
  }
  for (const t of heights.some(v => v > 0) ? ticksOf(ys) : [0]) { // where there is no error there is nothing to measure it by
    const at = ys.place(t);
    svg.append(make("line", { class: "grid", x1: kLeft, x2: kWide - kRight, y1: at, y2: at }));
    svg.append(make("text", { x: kLeft - 8, y: at + 4, "text-anchor": "end" }, brief(t * percent)));
  }
  svg.append(make("line", { class: "axis", x1: kLeft, x2: kWide - kRight, y1: kHigh - kBottom, y2: kHigh - kBottom }));
  svg.append(make("line", { class: "axis", x1: kLeft, x2: kLeft, y1: kTop, y2: kHigh - kBottom }));
  if (broken) {
    const at = kHigh - kBottom - kNone * 2 / 3;
    svg.append(make("rect", { class: "gap", x: kLeft - 1, y: at - 2, width: 2, height: 4 }));
    for (const up of [-2, 2]) svg.append(make("line", { class: "break", x1: kLeft - 5, x2: kLeft + 5, y1: at + up + 2, y2: at + up - 2 }));
    svg.append(make("line", { class: "grid none", x1: kLeft, x2: kWide - kRight, y1: none, y2: none }));
    svg.append(make("text", { class: "none", x: kLeft - 8, y: none + 4, "text-anchor": "end" }, "0"));
  }
  const below = timed ? first.unit : byKnob ? (curves.length > 1 ? "value of the knob" : first.knob + (first.unit ? ", " + first.unit : "")) : clocks[first.clock] + ", ms";
  svg.append(make("text", { x: (kLeft + kWide - kRight) / 2, y: kHigh - 8, "text-anchor": "middle" }, below));
  svg.append(make("text", { x: 14, y: (kTop + kHigh - kBottom) / 2, "text-anchor": "middle", transform: `rotate(-90 14 ${(kTop + kHigh - kBottom) / 2})` },
    timed ? "ms, of a million rays or of a raster" : first.error_unit === "relative mean" ? "error, % (mean)" : isShare(first) ? "error, % (relative RMSE)" : "error (RMSE)"));

  const lines = []; // that names stay off
  const path = points => points.map(([a, b], i) => {
    const joined = i > 0 && !(broken && (b === none || points[i - 1][1] === none)); // no line leads to no error
    if (joined) lines.push([points[i - 1], [a, b]]);
    return (joined ? "L" : "M") + a.toFixed(1) + " " + b.toFixed(1);
  }).join("");
  if (!byKnob) {
    const front = curves.flatMap(c => c.points.filter(p => p.pareto).map(p => placed(c, p))).sort((a, b) => a[0] - b[0]);
    if (front.length > 1) svg.append(make("path", { class: "front", d: path(front) }));
  }
  curves.forEach((curve, k) => {
    const colour = `var(--s${colours[k] % 6})`;
    if (byKnob && curve.measured_slope !== null && !curve.named) {
      const trail = [];
      const real = curve.points.map(p => p.value).filter(v => v > 0);
      for (let i = 0; i <= 40; ++i) {
        const v = Math.min(...real) * (Math.max(...real) / Math.min(...real)) ** (i / 40);
        const e = Math.hypot(curve.floor, curve.factor * v ** curve.measured_slope);
        if (e >= ys.low && e <= ys.high) trail.push([xs.place(v), ys.place(e)]);
      }
      if (trail.length > 1) svg.append(make("path", { class: "law", style: "stroke:" + colour, d: path(trail) }));
    }
    svg.append(make("path", { class: "row", style: "stroke:" + colour, d: path(curve.points.map(p => placed(curve, p))) }));
  });
  const marks = [], many = curves.reduce((sum, c) => sum + c.points.length, 0) > 9;
  curves.forEach((curve, k) => {
    const colour = `var(--s${colours[k] % 6})`;
    curve.points.forEach(p => {
      const at = placed(curve, p);
      const off = timed ? (p.error === null ? "" : `, ${wrong(curve, p)} of the hits differ`) : `, error ${wrong(curve, p)}, FLIP ${digits(p.flip, 2)}` + inSpace(p);
      const said = `${valueName(curve, p)}: ${price(curve, p.ms)}${p.ms_spread ? " (spread " + price(curve, p.ms_spread) + ")" : ""}` + off
        + (p.default ? ", the default" : "") + (p.pareto ? ", on the Pareto front" : "");
      const dot = make("g", { class: "dot", tabindex: 0, role: "button", "aria-label": said });
      if (!byKnob && p.ms_spread) {
        const [x1, x2] = [-0.5, 0.5].map(side => xs.place(held(p.ms + side * p.ms_spread, xs.low, xs.high)));
        dot.append(make("line", { style: "stroke:" + colour, x1, x2, y1: at[1], y2: at[1] }));
        lines.push([[x1, at[1]], [x2, at[1]]]);
      }
      if (p.default) dot.append(make("circle", { class: "ring", cx: at[0], cy: at[1], r: 9, style: "stroke:" + colour }));
      dot.append(make("circle", { cx: at[0], cy: at[1], r: 13, fill: "transparent" }));
      dot.append(make("circle", { class: "mark", cx: at[0], cy: at[1], r: 4.5, style: `fill:${p.pareto ? colour : "var(--card)"};stroke:${colour};stroke-width:1.5` }));
      const named = timed ? p === curve.points[curve.points.length - 1] : !many || p.default;
      const words = !named ? "" : timed ? curve.knob : many ? valueName(curve, p) : p.name;
      marks.push({ at, words, colour, dot, reach: p.default ? 10 : 6, weight: (p.default ? 2 : 0) + (p.pareto ? 1 : 0) });
      const say = () => tell(said, dot);
      dot.addEventListener("pointerenter", say), dot.addEventListener("focus", say);
      dot.addEventListener("pointerleave", hush), dot.addEventListener("blur", hush);
      dot.addEventListener("click", () => pick(curve, p));
      dot.addEventListener("keydown", event => { if (event.key === "Enter" || event.key === " ") event.preventDefault(), pick(curve, p); });
      p.dots = (p.dots || []).filter(d => d.isConnected).concat(dot);
      svg.append(dot);
    });
  });
  const names = marks.filter(mark => mark.words).sort((a, b) => b.weight - a.weight);
  placesOf(names, marks, lines).forEach((box, i) => {
    const style = curves.length > 1 ? "fill:" + names[i].colour : ""; // of several curves, whose it is
    if (box) names[i].dot.append(make("text", { class: "name", style, x: box.left + 1, y: box.bottom - 2 }, names[i].words));
  });
  return svg;
}

const tip = document.getElementById("tip");
function tell(words, at) {
  const box = at.getBoundingClientRect();
  tip.textContent = words;
  tip.style.visibility = "visible";
  tip.style.left = Math.max(8, Math.min(box.left + box.width / 2 + 14, innerWidth - tip.offsetWidth - 8)) + "px";
  tip.style.top = Math.max(8, box.top - tip.offsetHeight - 4) + "px";
}
function hush() { tip.style.visibility = "hidden"; }

// Standing alone: what the style sheet says goes along.
function alone(svg) {
  const copy = svg.cloneNode(true), from = [svg, ...svg.querySelectorAll("*")], to = [copy, ...copy.querySelectorAll("*")];
  from.forEach((e, i) => {
    const style = getComputedStyle(e), plain = { stroke: "none", "stroke-dasharray": "none", "stroke-linejoin": "miter", "stroke-linecap": "butt", opacity: "1" };
    const keys = e.localName === "text" ? ["fill", "font-size", "font-family"] : e.localName === "g" ? [] : ["fill", "opacity", "stroke", "stroke-width", "stroke-dasharray", "stroke-linejoin", "stroke-linecap"];
    to[i].removeAttribute("class"), to[i].removeAttribute("tabindex"), to[i].removeAttribute("style");
    const said = keys.filter(k => style.getPropertyValue(k) !== plain[k] && !(k === "stroke-width" && style.stroke === "none")).map(k => `${k}:${style.getPropertyValue(k)}`);
    if (said.length) to[i].setAttribute("style", said.join(";"));
  });
  copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
  copy.setAttribute("width", kWide), copy.setAttribute("height", kHigh);
  copy.prepend(make("rect", { width: kWide, height: kHigh, style: "fill:" + getComputedStyle(document.documentElement).getPropertyValue("--card") }));
  return copy;
}
function save(svg, name) {
  const link = make("a", { download: name, href: URL.createObjectURL(new Blob([new XMLSerializer().serializeToString(alone(svg))], { type: "image/svg+xml" })) });
  link.click();
}

// ---- Truth beside approximation ----
function viewer(id) {
  const truth = make("img", { alt: "" }), over = make("img", { class: "over", alt: "" }), heat = make("img", { alt: "" });
  const edge = make("div", { class: "edge" }), caption = make("b"), against = make("figcaption"), mean = make("span");
  const slider = make("input", { type: "range", min: 0, max: 100, step: 1, value: 50, "aria-label": "how much of the truth is shown: " + id });
  const stage = make("div", { class: "stage" }, truth, over, edge, make("span", { class: "tag", style: "left:8px" }, "truth"), make("span", { class: "tag", style: "right:8px" }, "shortcut"));
  const wipe = () => { over.style.clipPath = `inset(0 0 0 ${slider.value}%)`; edge.style.left = slider.value + "%"; };
  slider.addEventListener("input", wipe);
  const drag = event => { if (event.buttons) { const b = stage.getBoundingClientRect(); slider.value = 100 * (event.clientX - b.left) / b.width; wipe(); } };
  stage.addEventListener("pointerdown", drag), stage.addEventListener("pointermove", drag);
  stage.addEventListener("dragstart", event => event.preventDefault());
  wipe();
  const element = make("div", { class: "pair" },
    make("figure", {}, make("figcaption", {}, caption), stage, slider),
    make("figure", {}, make("figcaption", {}, mean, make("span", {}, "0", make("span", { class: "scale" }), "1")), make("div", { class: "stage" }, heat), against));
  const show = (curve, p) => {
    truth.src = p.reference || curve.reference, over.src = p.picture, heat.src = p.heat;
    truth.alt = "truth: " + curve.truth, over.alt = "drawn with " + valueName(curve, p), heat.alt = "FLIP per pixel";
    caption.textContent = `${valueName(curve, p)}: ${time(p.ms)}, error ${wrong(curve, p)}` + inSpace(p);
    mean.replaceChildren("FLIP, mean ", make("b", {}, digits(p.flip, 2)));
    against.textContent = "Truth: " + curve.truth;
    document.querySelectorAll(`[data-subject="${CSS.escape(id)}"] .chosen`).forEach(d => d.classList.remove("chosen"));
    (p.dots || []).forEach(d => d.classList.add("chosen"));
  };
  return { element, show };
}

function chartOf(subject, curves, colours, pick) {
  const timed = isTimed(curves[0]);
  let byKnob = timed || curves.every(c => c.by_value);
  const place = make("div"), title = curves.length > 1 ? curves.map((c, i) => make("span", { class: "series" }, make("span", { class: "swatch", style: `background:var(--s${colours[i] % 6})` }), c.knob + "\u2002")) : [(curves[0].knob === "drawn" ? "drawn or not" : curves[0].knob) + (curves[0].unit ? ", " + curves[0].unit : "")];
  const keys = make("div", { class: "keys" });
  const draw = () => place.replaceChildren(plot(curves, byKnob, pick, colours));
  const key = (words, how) => {
    const b = make("button", { type: "button", "aria-pressed": byKnob === how }, words);
    b.addEventListener("click", () => { byKnob = how; for (const other of keys.querySelectorAll("[aria-pressed]")) other.setAttribute("aria-pressed", other === b); draw(); });
    return b;
  };
  if (!timed && !curves.every(c => c.named)) keys.append(key("against time", false), key("against the knob", true));
  const saver = make("button", { type: "button", title: "save this plot" }, "save SVG");
  saver.addEventListener("click", () => save(place.querySelector("svg"), `${subject.effect}-${curves[0].knob}.svg`.replaceAll(" ", "-")));
  keys.append(saver);
  draw();
  const words = curves.flatMap((c, i) => [
    ...(!c.advice ? [] : [make("p", { class: "advice" }, ...(curves.length > 1 ? [make("span", { class: "swatch", style: `background:var(--s${colours[i] % 6})` })] : []), c.advice)]),
    ...(c.verdict ? [make("p", { class: "note" }, (timed ? "Time of " : "Error by ") + c.knob + ": " + c.verdict + ".")] : [])]);
  return make("div", { class: curves.length > 1 ? "chart many" : "chart" },
    make("div", {}, make("div", { class: "head" }, make("h3", {}, ...title), keys), place), make("div", {}, ...words));
}

function sectionOf(subject) {
  const pictured = !subject.curves.some(isTimed), look = viewer(subject.effect), groups = new Map();
  for (const curve of subject.curves) {
    const id = isTimed(curve) ? "timed" : curve.truth + curve.clock;
    if (!groups.has(id)) groups.set(id, []);
    groups.get(id).push(curve);
  }
  const charts = make("div", { class: "charts" });
  for (const curves of groups.values()) charts.append(chartOf(subject, curves, curves.map((_, i) => i), pictured ? look.show : () => {}));
  const section = make("section", { class: "card", id: subject.effect, "data-subject": subject.effect },
    make("h2", {}, subject.effect), make("p", { class: "question" }, subject.question), make("p", { class: "reason" }, "Here: " + subject.reason + "."),
    ...(pictured ? [look.element] : []), charts);
  const chosen = c => c.points.some(p => p.default);
  const opening = subject.curves.find(c => !c.named && chosen(c)) || subject.curves.find(c => c.knob !== "drawn" && chosen(c)) || subject.curves.find(c => !c.named) || subject.curves[0];
  if (pictured) queueMicrotask(() => look.show(opening, standardOf(opening)));
  return section;
}

function overview() {
  const body = make("tbody");
  for (const subject of report.subjects)
    subject.curves.forEach((c, i) => {
      const p = standardOf(c), law = c.expected_slope === null ? "" : `${c.most ? "below " : ""}${c.expected_slope} expected`;
      const measured = c.measured_slope === null ? "" : `${digits(c.measured_slope, 2)} measured`;
      body.append(make("tr", {}, make("td", {}, i ? "" : make("a", { href: "#" + subject.effect }, subject.effect)), make("td", {}, c.knob), make("td", {}, p.default ? p.name : isTimed(c) ? "" : `(${p.name})`),
        make("td", { class: "number" }, price(c, p.ms)), make("td", { class: "number" }, p.noise > 0 && p.error <= p.noise ? "< " + amount(c, p.noise) : wrong(c, p)), make("td", { class: "number" }, p.flip === null ? "" : digits(p.flip, 2)),
        make("td", { class: c.verdict.includes("the law holds") ? "holds" : "" }, [law, measured].filter(Boolean).join(", "))));
    });
  return make("section", { class: "card" }, make("h2", {}, "At a glance"), make("p", { class: "note" }, "Each row at the program's default, in brackets at the last value of what is no choice, against the truth that its section names. An error below another is one that the noise hides."),
    make("div", { class: "wide" }, make("table", {}, make("thead", {}, make("tr", {}, ...["effect", "knob", "default"].map(t => make("th", {}, t)), ...["time", "error", "FLIP"].map(t => make("th", { class: "number" }, t)), make("th", {}, "error by the knob (of triangles: time), log-log slope"))), body)));
}

function how() {
  const says = ["A point is one setting, measured. Its time is the lower quartile of several frames after one that warms up, for what else the machine does only adds; the bar across it is their interquartile range. The points of a knob take turns, frame by frame, so that no other work falls on one of them alone. A ring marks what the program does when nobody says otherwise. Filled points, joined by the broad line, are the Pareto front: nothing in the plot is both faster and nearer to the truth.",
    "Error is the root mean square over all pixels and channels. Of radiance it is relative to what the two pictures show at each pixel (and, where all is dark, to a tenth of the mean), of the path tracer's own pictures relative to the truth alone; of visibility and of displayed values it is as it is. Where the truth is path traced it is traced twice, and an error is what both agree on: it can be told below the noise of either. What noise leaves of that, two standard errors of the mean, is an error that cannot be told from none: it is printed as such, and no advice is made of it. FLIP is how different two pictures look when one flips between them, 0 to 1; it does see the noise of a truth.",
    "A knob's own error is measured in single frames, as in motion, against the same frame with the knob at its limit; whether an effect is drawn at all is judged at rest, by the mean of sixteen frames, against the path-traced picture.",
    "Irradiance probes are asked at points of free space, drawn evenly by chance, about six axes: their error is the mean over points, axes and channels, each relative to the point's own light. Where next to no light is, there is no such error, but a leak: the most that the probes say there, of the mean over all points. The picture is a slice through the level at the height of the camera. Bytes are those of all probes with the tree that finds them, before they are packed.",
    "Of triangles it is time that goes with their number: of incoherent rays, on one thread of the CPU, by ray queries and with every triangle asked in turn, and of the frame's geometry, in a picture so small that pixels count for little. The level is made for it, and is the same whichever is studied. A million rays in a millisecond are a ray in a nanosecond.",
    "Shadow maps are drawn anew in every frame that is timed, as when something moves."];
  return make("details", {}, make("summary", {}, "How to read this, and how it was measured"), ...says.map(t => make("p", {}, t)));
}

// ---- The page ----
const main = document.getElementById("main");
document.title = "What accuracy costs: " + report.level;
document.getElementById("lead").textContent = `Every shortcut that ${report.level} calls for, next to the truth that it replaces: how wrong it is, how long it takes, and what a little more or less of it would buy.`;
const facts = { drawn: report.device, baked: `${report.processor}, load ${digits(report.load, 2)} at most`, pictures: report.size.join(" \u00d7 "), truth: `2 \u00d7 ${report.truth_samples} paths a pixel, noise ${digits(100 * report.truth_noise, 2)} %` };
for (const [word, fact] of Object.entries(facts)) document.getElementById("facts").append(make("span", {}, word + " ", make("b", {}, fact)));
if (report.quick) document.getElementById("facts").append(make("span", {}, "a quick study: small pictures, lightmaps of half a draft's density"));
// The study itself keeps each processor busy.
if (report.load > 1.5 * report.threads) document.getElementById("facts").after(make("p", { class: "note warning" }, `Other work shared the machine: a load of ${digits(report.load, 2)} on ${report.threads} processors. Compare times within a plot, where points took turns, and not with another day's.`));
main.append(overview(), how(), ...report.subjects.map(sectionOf));
if (report.absent.length) main.append(make("footer", {}, make("h3", {}, "Not studied"), ...report.absent.map(t => make("p", { class: "note" }, t))));
// study.html#plot=EFFECT is its plot of several curves and nothing else: for a browser without a window, which prints it (`./run study`)
const plotted = /^#plot=(.+)$/.exec(location.hash);
if (plotted) document.documentElement.replaceChildren(alone(document.getElementById(decodeURIComponent(plotted[1])).querySelector(".chart.many svg")));
