// The first page: counts, distributions that select plans, a table of all plans, and the runs.
import { certificateOfRun } from "./certificate_box.js";
import { differenceColumns, partnerRows, planColumns } from "./columns.js";
import { buildCounts } from "./counts.js";
import { report, rows } from "./data.js";
import { build, buildButton } from "./elements.js";
import { clearFilter, countPassing, filter, filterAddress, isFiltered, passing, setFilter } from "./filter.js";
import { countText, plainText } from "./format.js";
import { buildHistogram, isDistribution } from "./histogram.js";
import { measures } from "./measures.js";
import { buildPosters } from "./posters.js";
import { buildRuns } from "./runs.js";
import { addressOf, on, state } from "./state.js";
import { buildTable, sortItems } from "./table.js";

let shownItems = rows.map((_, index) => index);
let elements = null, isOpenedByPoster = false;

// Indices into rows, in the order of the table.
export const shownRows = () => shownItems;

const kPlanColumns = planColumns();
let differences = { columns: [], partner: [], before: -1, after: -1 };

function columnsNow() {
  if (!filter.differences) return kPlanColumns;
  const { before, after } = filter;
  if (differences.before !== before || differences.after !== after) {
    const partner = partnerRows(before, after);
    differences = { columns: differenceColumns(partner), partner, before, after };
  }
  return differences.columns;
}

function sortBy(column) {
  const isSameColumn = filter.sort === column.id;
  // Ascending, then descending, then the order of the file.
  if (isSameColumn && filter.descending) setFilter({ sort: "", descending: false });
  else setFilter({ sort: column.id, descending: isSameColumn });
}

function openRow(row) {
  writeFilterAddress();
  location.hash = addressOf(rows, row);
}

function buildTools() {
  const search = build("input", { type: "search", placeholder: "Search plans, subjects, tasks, reasons",
    "aria-label": "Search", spellcheck: "false" });
  search.addEventListener("input", () => setFilter({ search: search.value }));
  const shown = build("output", { class: "shown-count" });
  const showAll = buildButton("show all", { class: "quiet" }, clearFilter);
  const tools = build("div", { class: "bar tools" }, search, shown, showAll);
  if (report.runs.length > 1) tools.append(...buildComparison());
  return { tools, search, shown, showAll };
}

function buildComparison() {
  const choice = (key, label) => {
    const select = build("select", { "aria-label": label },
        ...report.runs.map(({ name }, run) => build("option", { value: run, selected: run === filter[key] }, plainText(name))));
    select.addEventListener("change", () => setFilter({ [key]: Number(select.value), differences: true }));
    return select;
  };
  const box = build("input", { type: "checkbox" });
  box.addEventListener("change", () => setFilter({ differences: box.checked, sort: "", descending: false }));
  on("filter", () => { box.checked = filter.differences; });
  return [build("label", {}, box, " differences"), choice("before", "from run"), " → ", choice("after", "to run")];
}

// A box for each run, with its name if there are several.
function certificatesOfRuns() {
  return report.runs.flatMap((run, index) => {
    const box = certificateOfRun(run, index);
    if (box === null) return [];
    return report.runs.length > 1 ? [build("h3", {}, plainText(run.name)), box] : [box];
  });
}

function buildOverview(host) {
  const tools = buildTools();
  const table = buildTable({ label: "Plans", onOpen: openRow, onSort: sortBy });
  const counts = buildCounts();
  const posters = buildPosters();
  const histograms = measures.filter(isDistribution).map(buildHistogram);
  // Whoever follows a link comes back to what is chosen now.
  host.addEventListener("click", writeFilterAddress, true);
  host.replaceChildren(
    ...report.runs.filter(({ not_verified }) => not_verified).map(({ name, not_verified }) =>
      build("p", { class: "warning", role: "alert" }, "Not verified: ", plainText(name), " ", plainText(not_verified))),
    ...report.runs.filter(({ left_out }) => left_out).map(({ left_out }) =>
      build("p", { class: "warning" }, plainText(left_out))),
    counts.section,
    ...certificatesOfRuns(),
    build("section", { "aria-labelledby": "table-title" }, build("h2", { id: "table-title" }, "Movements"), tools.tools,
        posters.box, table.box),
    histograms.length === 0 ? "" : build("section", { "aria-labelledby": "distributions-title" },
        build("h2", { id: "distributions-title" }, "Distributions"),
        build("p", { class: "muted small" }, "Click or drag over bars to show only those plans."),
        build("div", { class: "histograms" }, ...histograms.map(({ card }) => card))),
    buildRuns());
  return { tools, posters, table, counts, histograms, columns: null };
}

function showFiltered() {
  const columns = columnsNow();
  const isKept = filter.differences ? (i) => passing[i] && differences.partner[i] >= 0 : (i) => passing[i];
  shownItems = rows.map((_, index) => index).filter(isKept);
  const sorted = columns.find(({ id }) => id === filter.sort);
  if (sorted) sortItems(shownItems, sorted, filter.descending, rows.length);
  if (!elements) return;
  if (elements.columns !== columns) {
    elements.columns = columns;
    elements.table.setColumns(columns);
  }
  elements.table.show(shownItems, sorted, filter.descending);
  elements.posters.show(shownItems);
  elements.counts.update();
  elements.histograms.forEach((histogram) => histogram.update());
  const { search, shown, showAll } = elements.tools;
  if (search.value !== filter.search) search.value = filter.search;
  const count = filter.differences ? shownItems.length : countPassing();
  shown.textContent = isFiltered() || filter.differences
    ? `${count.toLocaleString("en")} of ${countText(rows.length, "plan")}` : countText(rows.length, "plan");
  showAll.hidden = !isFiltered();
  if (state.row === null) keepFilterAddress();
}

let filterTimer = 0;

function keepFilterAddress() {
  clearTimeout(filterTimer);
  filterTimer = setTimeout(writeFilterAddress, 200);
}

function writeFilterAddress() {
  if (state.row === null && location.hash !== filterAddress()) history.replaceState(null, "", filterAddress());
}

on("filter", showFiltered);

export function openOverview(host, row) {
  elements ??= buildOverview(host);
  showFiltered();
  if (row !== null && !(isOpenedByPoster && elements.posters.focus(row))) elements.table.focusItem(row);
}

// Remembers whether the focus returns to a poster or to the table.
export function closeOverview() {
  if (!elements) return;
  isOpenedByPoster = elements.posters.box.contains?.(document.activeElement);
  elements.posters.stop();
}

export const focusSearch = () => elements?.tools.search.focus();
