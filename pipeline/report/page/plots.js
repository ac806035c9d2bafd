// The plots beside the 3D view, on its clock. A click moves the clock; a line that is clicked is
// picked everywhere.
import { colour } from "./colours.js";
import { build, buildButton, buildSvg } from "./elements.js";
import { numberText, plainText } from "./format.js";
import { on, pick, setTime, state } from "./state.js";
import { buildBandKey } from "./timeline.js";

const kPatterns = [null, [7, 3], [2, 2], [9, 3, 2, 3]];
const kFewSeries = 6; // up to as many lines differ in colour and pattern
const kPalette = ["--line-0", "--line-1", "--line-2", "--line-3", "--line-4", "--line-5", "--line-6"];

const isPicked = (series) => series.pick && JSON.stringify(series.pick) === JSON.stringify(state.pick);

// {colour (a name of style.css), pattern (lengths of dashes and gaps, null: solid)} of a line.
function styleOf(series, index) {
  if (series[index].isReference) return { name: "--muted", pattern: [5, 4] };
  const round = series.length <= kFewSeries ? index : Math.floor(index / kPalette.length);
  return { name: kPalette[index % kPalette.length], pattern: kPatterns[round % kPatterns.length] };
}

// The names of the lines, those that can be picked as buttons.
function buildLegend(series, title) {
  const items = series.map((line, index) => {
    const { name, pattern } = styleOf(series, index);
    const swatch = buildSvg("svg", { width: 24, height: 8, "aria-hidden": "true" },
        buildSvg("line", { x1: 0, x2: 24, y1: 4, y2: 4, class: name.slice(2), "stroke-dasharray": pattern?.join(" ") }));
    if (!line.pick) return build("span", { class: "line-name" }, swatch, plainText(line.name));
    const button = buildButton("", { class: "line-name quiet", "aria-pressed": "false" }, () => pick(line.pick));
    button.append(swatch, plainText(line.name));
    return button;
  });
  return { items, series, element: build("div", { class: "plot-legend", role: "group", "aria-label": `Lines of ${title}` }, ...items) };
}

function optionsOf(series, hasManySeries) {
  const hasPick = series.some(isPicked);
  const options = {};
  series.forEach((line, index) => {
    const { name, pattern } = styleOf(series, index);
    options[line.label] = {
      color: colour(name),
      strokeWidth: isPicked(line) ? 3 : hasPick && line.pick ? 0.4 : hasManySeries ? 1 : 1.6,
      strokePattern: pattern,
    };
  });
  return options;
}

// Bands behind a plot: phases, intervals that repair changed, findings.
function drawBands(canvas, area, graph, bands) {
  const x = (time) => Math.min(area.x + area.w, Math.max(area.x, graph.toDomXCoord(time)));
  canvas.save();
  for (const { begin, end, kind } of bands) {
    const left = x(begin), width = x(end) - left;
    if (width <= 0) continue;
    canvas.fillStyle = colour(kind === "phase" ? "--band" : kind === "finding" ? "--bad" : "--mapped");
    if (kind === "phase") canvas.fillRect(left, area.y, width, area.h);
    else if (kind === "finding") canvas.fillRect(left, area.y, width, 4);
    else canvas.fillRect(left, area.y + area.h - 4, width, 4);
  }
  canvas.restore();
}

function buildPlot(host, plot, bands, legend) {
  plot.series.forEach((line, index) => {
    line.label = `${index} ${line.name}`;
  });
  const box = build("div", { class: "plot-canvas" });
  const cursor = build("div", { class: "plot-cursor", "aria-hidden": "true" });
  const value = build("output", { class: "plot-value" });
  const figure = build("figure", { class: "plot", role: "group", "aria-label": `${plot.title}, ${plot.unit}` },
      build("figcaption", {}, build("b", {}, plot.title), ` ${plot.unit} `, value), legend ? legend.element : "",
      build("div", { class: "plot-area" }, box, cursor));
  host.append(figure);
  const hasManySeries = plot.series.length > 6;
  const graph = new Dygraph(box, plot.rows, {
    labels: ["time", ...plot.series.map(({ label }) => label)],
    legend: "never", labelsDiv: build("div"), showLabelsOnHighlight: false,
    series: optionsOf(plot.series, hasManySeries),
    axes: { x: { axisLabelWidth: 40, pixelsPerLabel: 60 },
            y: { axisLabelWidth: 44, pixelsPerLabel: 24, axisLabelFormatter: (y) => numberText(y) } },
    axisLabelFontSize: 11, axisLineColor: colour("--line"), gridLineColor: colour("--line"), gridLineWidth: 0.4,
    valueRange: rangeOf(plot), highlightCircleSize: 3,
    highlightSeriesOpts: { strokeWidth: 2.5 }, highlightSeriesBackgroundAlpha: 1,
    underlayCallback: (canvas, area, drawnGraph) => drawBands(canvas, area, drawnGraph, bands),
    highlightCallback: (event, x, points, row, label) => {
      const index = plot.series.findIndex((line) => line.label === label);
      if (index >= 0) value.textContent = readingText(plot, index, plot.rows[row]);
    },
    unhighlightCallback: () => { value.textContent = ""; },
    clickCallback: (event, x) => {
      const label = graph.getHighlightSeries();
      const series = plot.series.find((line) => line.label === label);
      setTime(x);
      if (series?.pick && !isPicked(series)) pick(series.pick);
    },
  });
  return { graph, figure, cursor, plot, hasManySeries, legend };
}

const readingText = ({ series, unit }, index, row) =>
    `${series[index].name} ${numberText(row[index + 1])} ${unit} at ${row[0].toFixed(3)} s`;

// The range of the y axis: that of the values, from zero if they begin near it.
function rangeOf({ rows, limits }) {
  let low = Infinity, high = -Infinity;
  for (const row of rows) {
    for (let i = 1; i < row.length; ++i) {
      if (row[i] === null) continue;
      low = Math.min(low, row[i]);
      high = Math.max(high, row[i]);
    }
  }
  if (limits) return [Math.min(low, limits[0]) - 3, Math.max(high, limits[1]) + 3];
  const margin = 0.08 * (high - low || 1);
  return [low >= 0 && low < 0.5 * high ? 0 : low - margin, high + margin];
}

export function createPlots(host) {
  let shownPlots = [], legends = [];
  // Only the cursors in view move: a playing clock moves them at every frame.
  const visibility = new IntersectionObserver((entries) => {
    for (const { target, isIntersecting } of entries) target.isVisible = isIntersecting;
    moveCursors();
  }, { root: null });
  const moveCursors = () => {
    for (const { graph, cursor, figure } of shownPlots) {
      if (figure.isVisible === false) continue;
      const area = graph.getArea();
      const x = graph.toDomXCoord(state.time);
      cursor.hidden = x < area.x - 1 || x > area.x + area.w + 1;
      cursor.style.transform = `translateX(${x}px)`;
    }
  };
  const restyle = () => {
    for (const { graph, plot, hasManySeries } of shownPlots) {
      graph.updateOptions({ series: optionsOf(plot.series, hasManySeries), axisLineColor: colour("--line"),
                            gridLineColor: colour("--line") });
    }
    for (const { items, series } of legends)
      items.forEach((item, index) => { if (series[index].pick) item.setAttribute("aria-pressed", String(isPicked(series[index]))); });
  };
  const clear = () => {
    for (const { graph, figure } of shownPlots) {
      graph.destroy();
      visibility.unobserve(figure);
    }
    [shownPlots, legends] = [[], []];
    delete host.dataset.drawn;
    host.replaceChildren();
  };
  on("time", moveCursors);
  on("pick", restyle);
  return {
    // One plot per frame, so that the first ones appear at once.
    show(plots, bands) {
      clear();
      const ownPlots = shownPlots;
      host.append(buildBandKey(bands));
      // Plots of the same lines have one legend, before the first of them.
      const legendFor = (index) => {
        const { series, group, title } = plots[index];
        if (index > 0 && plots[index - 1].series === series) return null;
        const legend = buildLegend(series, group ?? title);
        legends.push(legend);
        if (!group) return legend;
        host.append(build("div", { class: "plot-group" }, build("b", {}, group), legend.element));
        return null;
      };
      const next = (index) => {
        if (ownPlots !== shownPlots) return;
        if (index === plots.length) {
          host.dataset.drawn = plots.length;
          return;
        }
        shownPlots.push(buildPlot(host, plots[index], bands, legendFor(index)));
        visibility.observe(shownPlots[index].figure);
        moveCursors();
        requestAnimationFrame(() => next(index + 1));
      };
      next(0);
    },
    clear,
    theme: restyle,
    resize() {
      for (const { graph } of shownPlots) graph.resize();
      moveCursors();
    },
  };
}
