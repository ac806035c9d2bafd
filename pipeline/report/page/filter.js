// The rows that are shown, and the filter in the page's address.
import { binningOf, rangeFromAddress, rangeToAddress } from "./bins.js";
import { rows } from "./data.js";
import { measureOf } from "./measures.js";
import { emit } from "./state.js";

const emptyFilter = () => ({
  status: "", reason: "", run: "", search: "",
  ranges: new Map(), // measure's id → {first, last} of its bins
  sort: "", descending: false,
  differences: false, before: 0, after: 1, // runs A and B
});

export const filter = emptyFilter();

// For every row 1 if it passes the filter.
export const passing = new Uint8Array(rows.length).fill(1);
let passingCount = rows.length;

export const countPassing = () => passingCount;

let searchTexts = null;

const searchTextOf = ({ plan, subject, task, reason, detail, target, flags }) =>
  [plan, subject, task, reason, detail, target, ...flags].join("\n").toLowerCase();

function searchTests() {
  const words = filter.search.toLowerCase().split(/\s+/).filter((word) => word !== "");
  if (words.length === 0) return [];
  searchTexts ??= rows.map(searchTextOf);
  return [(i) => words.every((word) => searchTexts[i].includes(word))];
}

function rangeTests() {
  return [...filter.ranges].map(([id, { first, last }]) => {
    const { bins } = binningOf(measureOf(id));
    return (i) => bins[i] >= first && bins[i] <= last;
  });
}

function equalTests() {
  const tests = [];
  if (filter.status !== "") tests.push((i) => rows[i].status === filter.status);
  if (filter.reason !== "") tests.push((i) => rows[i].reason === filter.reason);
  if (filter.run !== "") tests.push((i) => rows[i].run === filter.run);
  return tests;
}

function applyFilter() {
  const tests = [...equalTests(), ...rangeTests(), ...searchTests()];
  passingCount = 0;
  for (let i = 0; i < rows.length; ++i) {
    passing[i] = tests.every((test) => test(i)) ? 1 : 0;
    passingCount += passing[i];
  }
}

export function setFilter(changes) {
  Object.assign(filter, changes);
  applyFilter();
  emit("filter");
}

export function setRange(id, range) {
  const ranges = new Map(filter.ranges);
  if (range) ranges.set(id, range);
  else ranges.delete(id);
  setFilter({ ranges });
}

export function clearFilter() {
  const { sort, descending, differences, before, after } = filter;
  setFilter({ ...emptyFilter(), sort, descending, differences, before, after });
}

export const isFiltered = () =>
  filter.status !== "" || filter.reason !== "" || filter.run !== "" || filter.search !== "" ||
  filter.ranges.size > 0;

// The first page's address: #?status=infeasible&duration_ratio=1.2~1.6&sort=-tip_error_mean
export function filterAddress() {
  const query = new URLSearchParams();
  for (const key of ["status", "reason", "search"]) if (filter[key] !== "") query.set(key, filter[key]);
  if (filter.run !== "") query.set("run", filter.run);
  for (const [id, range] of filter.ranges) query.set(id, rangeToAddress(measureOf(id), range));
  if (filter.sort !== "") query.set("sort", `${filter.descending ? "-" : ""}${filter.sort}`);
  if (filter.differences) query.set("differences", `${filter.before}~${filter.after}`);
  const text = query.toString();
  return text === "" ? "#" : `#?${text}`;
}

function readRun(text) {
  const run = Number(text);
  return text !== "" && rows.some((row) => row.run === run) ? run : "";
}

function readRanges(query) {
  const ranges = new Map();
  for (const [id, text] of query) {
    const measure = measureOf(id);
    const range = measure && rangeFromAddress(measure, text);
    if (range) ranges.set(id, range);
  }
  return ranges;
}

// Unknown values in an address are ignored.
export function readFilterAddress(hash) {
  const query = new URLSearchParams(hash.replace(/^#\??/, ""));
  const sort = query.get("sort") ?? "";
  const changes = emptyFilter();
  for (const key of ["status", "reason", "search"]) changes[key] = query.get(key) ?? "";
  changes.run = readRun(query.get("run") ?? "");
  changes.ranges = readRanges(query);
  changes.descending = sort.startsWith("-");
  changes.sort = sort.replace(/^-/, "");
  const runs = (query.get("differences") ?? "").split("~").map(readRun);
  if (runs.length === 2 && runs[0] !== "" && runs[1] !== "" && runs[0] !== runs[1])
    Object.assign(changes, { differences: true, before: runs[0], after: runs[1] });
  setFilter(changes);
}
