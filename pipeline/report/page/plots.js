// The plots beside the 3D view, on its clock. A click moves the clock; a line that is clicked is
// picked everywhere.
import { colour } from "./colours.js";
import { build } from "./elements.js";
import { figureText } from "./words.js";
import { on, pick, setTime, state } from "./state.js";

const kDash = [5, 4];
const kPalette = ["--line-0", "--line-1", "--line-2", "--line-3", "--line-4", "--line-5", "--line-6"];

const isPicked = (series) => series.pick && JSON.stringify(series.pick) === JSON.stringify(state.pick);

function optionsOf(series, several) {
  const paints = kPalette.map(colour);
  const faint = series.some(isPicked);
  const options = {};
  series.forEach((each, index) => {
    const picked = isPicked(each);
    options[each.label] = {
      color: each.line ? colour("--muted") : paints[index % paints.length],
      strokeWidth: picked ? 3 : faint && each.pick ? 0.4 : several ? 1 : 1.6,
      strokePattern: each.line || each.dashed ? kDash : Math.floor(index / paints.length) % 2 === 1 ? [2, 2] : null,
    };
  });
  return options;
}

// Bands behind a plot: phases in turns, what repair changed, findings.
function drawBands(canvas, area, graph, bands) {
  const x = (time) => Math.min(area.x + area.w, Math.max(area.x, graph.toDomXCoord(time)));
  canvas.save();
  for (const { begin, end, kind } of bands) {
    const left = x(begin), width = x(end) - left;
    if (width <= 0) continue;
    canvas.fillStyle = colour(kind === "phase" ? "--band" : kind === "finding" ? "--bad" : "--ghost");
    if (kind === "phase") canvas.fillRect(left, area.y, width, area.h);
    else if (kind === "finding") canvas.fillRect(left, area.y, width, 4);
    else canvas.fillRect(left, area.y + area.h - 4, width, 4);
  }
  canvas.restore();
}

function makePlot(host, plot, bands, readout) {
  plot.series.forEach((each, index) => {
    each.label = `${index} ${each.name}`;
    each.dashed = index > 0 && plot.series.length <= 4;
  });
  const box = build("div", { class: "plot-canvas" });
  const cursor = build("div", { class: "plot-cursor", "aria-hidden": "true" });
  const value = build("output", { class: "plot-value" });
  const figure = build("figure", { class: "plot", role: "group", "aria-label": `${plot.title}, ${plot.unit}` },
      build("figcaption", {}, build("b", {}, plot.title), ` ${plot.unit} `, value), box, cursor);
  host.append(figure);
  const several = plot.series.length > 6;
  const graph = new Dygraph(box, plot.rows, {
    labels: ["time", ...plot.series.map(({ label }) => label)],
    legend: "never", labelsDiv: build("div"), showLabelsOnHighlight: false,
    series: optionsOf(plot.series, several),
    axes: { x: { axisLabelWidth: 40, pixelsPerLabel: 60 },
            y: { axisLabelWidth: 44, pixelsPerLabel: 24, axisLabelFormatter: (y) => figureText(y) } },
    axisLabelFontSize: 11, axisLineColor: colour("--line"), gridLineColor: colour("--line"), gridLineWidth: 0.4,
    valueRange: rangeOf(plot), highlightCircleSize: 3,
    highlightSeriesOpts: { strokeWidth: 2.5 }, highlightSeriesBackgroundAlpha: 1,
    underlayCallback: (canvas, area, of) => drawBands(canvas, area, of, bands),
    highlightCallback: (event, x, points, row, label) => {
      const index = plot.series.findIndex((each) => each.label === label);
      if (index >= 0) value.textContent = sentence(plot, index, plot.rows[row]);
    },
    unhighlightCallback: () => { value.textContent = ""; },
    clickCallback: (event, x) => {
      const label = graph.getHighlightSeries();
      const series = plot.series.find((each) => each.label === label);
      setTime(x);
      if (series?.pick && !isPicked(series)) pick(series.pick);
    },
  });
  return { graph, figure, cursor, plot, several };
}

const sentence = ({ series, unit }, index, row) =>
    `${series[index].name} ${figureText(row[index + 1])} ${unit} at ${row[0].toFixed(3)} s`;

// From the values, with zero where it is near.
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
  const room = 0.08 * (high - low || 1);
  return [low >= 0 && low < 0.5 * high ? 0 : low - room, high + room];
}

export function createPlots(host) {
  let shown = [];
  // Only those in sight: a playing clock moves them at every frame.
  const sight = new IntersectionObserver((entries) => {
    for (const { target, isIntersecting } of entries) target.inSight = isIntersecting;
    moveCursors();
  }, { root: null });
  const moveCursors = () => {
    for (const { graph, cursor, figure } of shown) {
      if (figure.inSight === false) continue;
      const area = graph.getArea();
      const x = graph.toDomXCoord(state.time);
      cursor.hidden = x < area.x - 1 || x > area.x + area.w + 1;
      cursor.style.transform = `translateX(${x}px)`;
    }
  };
  const restyle = () => {
    for (const { graph, plot, several } of shown) {
      graph.updateOptions({ series: optionsOf(plot.series, several), axisLineColor: colour("--line"),
                            gridLineColor: colour("--line") });
    }
  };
  const clear = () => {
    for (const { graph, figure } of shown) {
      graph.destroy();
      sight.unobserve(figure);
    }
    shown = [];
    host.replaceChildren();
  };
  on("time", moveCursors);
  on("pick", restyle);
  return {
    // One plot a frame, so that the first ones are there at once.
    show(plots, bands) {
      clear();
      const mine = shown;
      const next = (index) => {
        if (mine !== shown || index === plots.length) return;
        shown.push(makePlot(host, plots[index], bands));
        sight.observe(shown[index].figure);
        moveCursors();
        requestAnimationFrame(() => next(index + 1));
      };
      next(0);
    },
    clear,
    theme: restyle,
    resize() {
      for (const { graph } of shown) graph.resize();
      moveCursors();
    },
  };
}
