// A measure's distribution: bars of all rows, over them those that are shown. Bars that are clicked,
// dragged over or chosen with the arrow keys select rows.
import { binningOf, edgeOf, rangeLabel } from "./bins.js";
import { report, rows } from "./data.js";
import { build, buildButton, buildSvg } from "./elements.js";
import { filter, passing, setRange } from "./filter.js";
import { axisText, countText } from "./format.js";

const kWidth = 300, kHeight = 108, kLeft = 4, kTop = 15, kBottom = 88;
const kInner = kWidth - 2 * kLeft;
const kRunCount = report.runs.length;

// The number of plans [bin * runs + run], of all plans or of those that pass the filter.
function countBins({ bins, count }, all) {
  const counts = new Uint32Array(count * kRunCount);
  for (let i = 0; i < rows.length; ++i)
    if (bins[i] >= 0 && (all || passing[i])) ++counts[bins[i] * kRunCount + rows[i].run];
  return counts;
}

function buildBar(className, bin, run, width) {
  const inner = width * 0.9 / kRunCount;
  return buildSvg("rect", {
    class: className, x: kLeft + bin * width + width * 0.05 + run * inner, width: inner,
    y: kBottom, height: 0,
  });
}

function setBarHeight(bar, count, maxCount) {
  const height = count === 0 ? 0 : Math.max(1.5, (kBottom - kTop) * count / maxCount);
  bar.setAttribute("y", kBottom - height);
  bar.setAttribute("height", height);
}

function buildBins(measure, { count }) {
  const width = kInner / count;
  return Array.from({ length: count }, (_, bin) => {
    const runs = Array.from({ length: kRunCount }, (_unused, run) => run);
    const all = runs.map((run) => buildBar("all-plans", bin, run, width));
    const shown = runs.map((run) => buildBar(`shown-plans run-${run % 4}`, bin, run, width));
    const option = buildSvg("g", { role: "option", id: `bin-${measure.id}-${bin}` },
        buildSvg("rect", { class: "click-area", x: kLeft + bin * width, y: 0, width, height: kHeight }),
        ...all, ...shown);
    return { option, all, shown };
  });
}

function tickBins(measure, { count }) {
  if (measure.valueNames) return [0, 1];
  const every = Math.ceil(count / 5);
  return Array.from({ length: Math.floor(count / every) + 1 }, (_, k) => k * every);
}

function buildAxis(measure, binning) {
  const { count, step, hasValuesAbove } = binning;
  const width = kInner / count;
  const centred = measure.isInteger && step === 1;
  const axis = buildSvg("g", { class: "axis", "aria-hidden": "true" },
      buildSvg("line", { x1: kLeft, x2: kWidth - kLeft, y1: kBottom, y2: kBottom }));
  for (const bin of tickBins(measure, binning)) {
    if (centred && bin >= count) continue;
    const x = kLeft + (bin + (centred ? 0.5 : 0)) * width;
    const end = bin === 0 && !centred ? "start" : bin >= count ? "end" : "middle";
    const open = hasValuesAbove && bin >= count - (centred ? 1 : 0);
    const label = measure.valueNames?.[bin] ?? axisText(edgeOf(binning, bin));
    axis.append(buildSvg("line", { x1: x, x2: x, y1: kBottom, y2: kBottom + 3 }),
        buildSvg("text", { x, y: kHeight - 5, "text-anchor": end }, open ? `${label} +` : label));
  }
  return axis;
}

function markRange(mark, range, count) {
  const width = kInner / count;
  mark.setAttribute("x", kLeft + (range ? range.first * width : 0));
  mark.setAttribute("width", range ? (range.last - range.first + 1) * width : 0);
}

const rangeOfBins = (a, b) => ({ first: Math.min(a, b), last: Math.max(a, b) });
const sameRange = (a, b) => a && b && a.first === b.first && a.last === b.last;

function selectByPointer(svg, measure, count) {
  let anchor = -1, before = null;
  const binAt = ({ clientX }) => {
    const box = svg.getBoundingClientRect();
    const x = (clientX - box.left) / box.width * kWidth;
    return Math.min(count - 1, Math.max(0, Math.floor((x - kLeft) / kInner * count)));
  };
  const select = (range) => {
    if (!sameRange(filter.ranges.get(measure.id), range)) setRange(measure.id, range);
  };
  svg.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    svg.setPointerCapture(event.pointerId);
    anchor = binAt(event);
    before = filter.ranges.get(measure.id);
  });
  svg.addEventListener("pointermove", (event) => {
    if (anchor < 0 || binAt(event) === anchor && !filter.ranges.has(measure.id)) return;
    select(rangeOfBins(anchor, binAt(event)));
  });
  svg.addEventListener("pointerup", (event) => {
    if (anchor < 0) return;
    const range = rangeOfBins(anchor, binAt(event));
    anchor = -1;
    if (sameRange(range, before)) setRange(measure.id, null);
    else select(range);
  });
  svg.addEventListener("pointercancel", () => { anchor = -1; });
}

// Arrow keys move from bar to bar, with shift they extend the range; enter selects, escape clears.
function selectByKeys(svg, measure, count, showCursor) {
  let cursor = 0, anchor = 0;
  const move = (to, widen) => {
    cursor = Math.min(count - 1, Math.max(0, to));
    if (!widen) anchor = cursor;
    showCursor(rangeOfBins(anchor, cursor), cursor);
  };
  const choose = () => {
    const range = rangeOfBins(anchor, cursor);
    setRange(measure.id, sameRange(range, filter.ranges.get(measure.id)) ? null : range);
  };
  const keys = {
    ArrowLeft: (event) => move(cursor - 1, event.shiftKey),
    ArrowRight: (event) => move(cursor + 1, event.shiftKey),
    Home: (event) => move(0, event.shiftKey),
    End: (event) => move(count - 1, event.shiftKey),
    Enter: choose,
    " ": choose,
    Escape: () => setRange(measure.id, null),
  };
  svg.addEventListener("keydown", (event) => {
    if (!Object.hasOwn(keys, event.key) || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    keys[event.key](event);
  });
  svg.addEventListener("focus", () => move(cursor, false));
  svg.addEventListener("blur", () => showCursor(null, -1));
}

function missingText({ missing }) {
  return missing === 0 ? "all plans have a value" : `${missing.toLocaleString("en")} without a value`;
}

function buildCard(measure, binning, figure) {
  const unit = measure.unit === "" ? "" : ` [${measure.unit}]`;
  const range = build("span", { class: "range" });
  const clear = buildButton("clear", { class: "quiet", hidden: true }, () => setRange(measure.id, null));
  const head = build("figcaption", {},
      build("span", { class: "name", title: measure.title }, `${measure.label}${unit}`), range, clear);
  const foot = build("p", { class: "muted small" }, missingText(binning));
  return { card: build("figure", { class: "histogram" }, head, figure, foot), range, clear };
}

const kLeastValues = 20; // about as many as there are bins

// False for so few values, or so equal ones, that the table shows them better.
export function isDistribution(measure) {
  const { bins, count } = binningOf(measure);
  return count > 1 && bins.filter((bin) => bin >= 0).length >= kLeastValues;
}

// {card, update} of a measure that is a distribution.
export function buildHistogram(measure) {
  const binning = binningOf(measure);
  const bins = buildBins(measure, binning);
  const all = countBins(binning, true);
  const maxCount = all.reduce((a, b) => Math.max(a, b), 1);
  const mark = buildSvg("rect", { class: "mark", y: kTop - 3, height: kBottom - kTop + 3 });
  const cursor = buildSvg("rect", { class: "cursor", y: kTop - 3, height: kBottom - kTop + 3 });
  const svg = buildSvg("svg", {
    viewBox: `0 0 ${kWidth} ${kHeight}`, tabindex: "0", role: "listbox",
    "aria-label": `${measure.title}: bars, enter selects, shift and arrow keys widen`,
    "aria-multiselectable": "true",
  }, mark, ...bins.map(({ option }) => option), buildAxis(measure, binning), cursor,
  buildSvg("text", { class: "max-count", x: kLeft, y: 10, "aria-hidden": "true" }, `max ${maxCount} plans`));
  const { card, range, clear } = buildCard(measure, binning, svg);
  bins.forEach((bin, k) => bin.all.forEach((bar, run) => setBarHeight(bar, all[k * kRunCount + run], maxCount)));
  selectByPointer(svg, measure, binning.count);
  selectByKeys(svg, measure, binning.count, (shown, bin) => {
    markRange(cursor, shown, binning.count);
    if (bin < 0) svg.removeAttribute("aria-activedescendant");
    else svg.setAttribute("aria-activedescendant", bins[bin].option.id);
  });
  const sums = bins.map((_, k) => all.subarray(k * kRunCount, (k + 1) * kRunCount).reduce((a, b) => a + b, 0));
  const update = () => {
    const chosen = filter.ranges.get(measure.id);
    const shown = countBins(binning, false);
    bins.forEach((bin, k) => {
      const ofBin = shown.subarray(k * kRunCount, (k + 1) * kRunCount);
      bin.shown.forEach((bar, run) => setBarHeight(bar, ofBin[run], maxCount));
      const label = rangeLabel(measure, { first: k, last: k });
      bin.option.setAttribute("aria-label",
          `${label}: ${ofBin.reduce((a, b) => a + b, 0)} of ${countText(sums[k], "plan")} shown`);
      bin.option.setAttribute("aria-selected", String(Boolean(chosen && k >= chosen.first && k <= chosen.last)));
    });
    markRange(mark, chosen, binning.count);
    range.textContent = chosen ? rangeLabel(measure, chosen) : "";
    clear.hidden = !chosen;
  };
  return { card, update };
}
