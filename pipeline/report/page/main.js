// Opens the page that the address names, and handles the keys of both pages.
import { report, rows } from "./data.js";
import { readFilterAddress } from "./filter.js";
import { plainText } from "./format.js";
import { closeMovement, focusMovement, movementKey, openMovement, prepareMovement } from "./movement.js";
import { closeOverview, focusSearch, openOverview, shownRows } from "./overview.js";
import { addressOf, emit, readAddress, state } from "./state.js";

const element = (id) => document.getElementById(id);
const overviewElement = element("overview"), movementElement = element("movement");

let firstAddress = "#";

function route() {
  const found = readAddress(rows, location.hash);
  const before = state.row;
  state.row = found ? found.row : null;
  overviewElement.hidden = found !== null;
  movementElement.hidden = found === null;
  element("back").hidden = element("previous").hidden = element("next").hidden = found === null;
  const files = report.runs.map(({ file }) => plainText(file)).join(", ");
  document.title = found ? `${plainText(rows[found.row].plan)} – Morphe` : `${files} – Morphe`;
  if (found) {
    closeOverview();
    openMovement(movementElement, found.row, found.time);
  } else {
    closeMovement();
    if (before === null || location.hash.startsWith("#?")) readFilterAddress(location.hash);
    openOverview(overviewElement, before);
  }
  if (found) focusMovement();
  emit("open");
}

const openFirstPage = () => { location.hash = firstAddress; };

function openNeighbour(count) {
  const shown = shownRows();
  const position = shown.indexOf(state.row);
  const next = shown[position + count];
  if (position < 0 || next === undefined) return;
  location.hash = addressOf(rows, next);
}

const kThemes = ["light", "dark"];

function setTheme(theme) {
  document.documentElement.dataset.theme = theme;
  emit("theme");
}

function toggleTheme() {
  setTheme(kThemes[1 - kThemes.indexOf(document.documentElement.dataset.theme)]);
}

const dark = matchMedia("(prefers-color-scheme: dark)");
setTheme(dark.matches ? "dark" : "light");
dark.addEventListener("change", () => setTheme(dark.matches ? "dark" : "light"));

const help = element("help");
const showHelp = () => { if (!help.open) help.showModal(); };

const kKeys = {
  "?": showHelp,
  t: toggleTheme,
  n: () => openNeighbour(1),
  N: () => openNeighbour(-1),
  Escape: () => { if (state.row !== null) openFirstPage(); },
  "/": () => { if (state.row === null) focusSearch(); },
};

const isTyping = ({ target }) => target.closest?.("input:not([type=checkbox]):not([type=range]), select, textarea");
const isPressing = ({ key, target }) => (key === " " || key === "Enter") && target.closest?.("button, a, summary, input, label");

addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.altKey || event.metaKey || help.open || event.defaultPrevented) return;
  if (isPressing(event) || isTyping(event) && event.key !== "Escape") return;
  if (event.target.type === "range" && event.key.startsWith("Arrow")) return;
  if (Object.hasOwn(kKeys, event.key)) kKeys[event.key]();
  else if (state.row === null || !movementKey(event)) return;
  event.preventDefault();
});

addEventListener("hashchange", (event) => {
  const before = new URL(event.oldURL).hash;
  if (!readAddress(rows, before)) firstAddress = before || "#";
  route();
});

element("back").addEventListener("click", openFirstPage);
element("previous").addEventListener("click", () => openNeighbour(-1));
element("next").addEventListener("click", () => openNeighbour(1));
element("theme").addEventListener("click", toggleTheme);
element("help-button").addEventListener("click", showHelp);
element("help-close").addEventListener("click", () => help.close());
element("software").textContent = plainText(report.software);

route();
(globalThis.requestIdleCallback ?? setTimeout)(() => prepareMovement(movementElement));
