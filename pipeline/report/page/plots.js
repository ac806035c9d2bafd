// The plots beside the 3D view, on its clock. A click moves the clock; a line that is clicked is
// picked everywhere.
import { colour } from "./colours.js";
import { build } from "./elements.js";
import { numberText } from "./format.js";
import { on, pick, setTime, state } from "./state.js";

const kDash = [5, 4];
const kPalette = ["--line-0", "--line-1", "--line-2", "--line-3", "--line-4", "--line-5", "--line-6"];

const isPicked = (series) => series.pick && JSON.stringify(series.pick) === JSON.stringify(state.pick);

function optionsOf(series, hasManySeries) {
  const palette = kPalette.map(colour);
  const hasPick = series.some(isPicked);
  const options = {};
  series.forEach((line, index) => {
    options[line.label] = {
      color: line.isReference ? colour("--muted") : palette[index % palette.length],
      strokeWidth: isPicked(line) ? 3 : hasPick && line.pick ? 0.4 : hasManySeries ? 1 : 1.6,
      strokePattern: line.isReference || line.dashed ? kDash : Math.floor(index / palette.length) % 2 === 1 ? [2, 2] : null,
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

function buildPlot(host, plot, bands) {
  plot.series.forEach((line, index) => {
    line.label = `${index} ${line.name}`;
    line.dashed = index > 0 && plot.series.length <= 4;
  });
  const box = build("div", { class: "plot-canvas" });
  const cursor = build("div", { class: "plot-cursor", "aria-hidden": "true" });
  const value = build("output", { class: "plot-value" });
  const figure = build("figure", { class: "plot", role: "group", "aria-label": `${plot.title}, ${plot.unit}` },
      build("figcaption", {}, build("b", {}, plot.title), ` ${plot.unit} `, value), box, cursor);
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
  return { graph, figure, cursor, plot, hasManySeries };
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
  let shownPlots = [];
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
  };
  const clear = () => {
    for (const { graph, figure } of shownPlots) {
      graph.destroy();
      visibility.unobserve(figure);
    }
    shownPlots = [];
    host.replaceChildren();
  };
  on("time", moveCursors);
  on("pick", restyle);
  return {
    // One plot per frame, so that the first ones appear at once.
    show(plots, bands) {
      clear();
      const ownPlots = shownPlots;
      const next = (index) => {
        if (ownPlots !== shownPlots || index === plots.length) return;
        shownPlots.push(buildPlot(host, plots[index], bands));
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
