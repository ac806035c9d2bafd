// A table of many rows, of which only the visible ones are elements. Columns are
// {id, title, unit, hint, number, width [rem], sortKey(item) → number or text, fill(cell, item)}.
import { build, buildButton } from "./elements.js";

const kExtraRows = 10; // rows drawn above and below the visible ones
const collator = new Intl.Collator("en", { numeric: true });

function ranksOf(texts) {
  const uniqueTexts = [...new Set(texts)].filter((text) => text !== "").sort(collator.compare);
  const rankOf = new Map(uniqueTexts.map((text, rank) => [text, rank]));
  return Float64Array.from(texts, (text) => rankOf.get(text) ?? NaN);
}

// Numbers that order items as a column does; NaN: last in both directions.
function keysOf(column, itemCount) {
  const keys = Array.from({ length: itemCount }, (_, item) => column.sortKey(item));
  return column.number ? Float64Array.from(keys) : ranksOf(keys);
}

const keysByColumn = new Map();

export function sortItems(items, column, descending, itemCount) {
  if (!keysByColumn.has(column)) keysByColumn.set(column, keysOf(column, itemCount));
  const keys = keysByColumn.get(column);
  const sign = descending ? -1 : 1;
  return items.sort((a, b) => {
    const x = keys[a], y = keys[b];
    if (x < y) return -sign;
    if (x > y) return sign;
    if (x === y) return a - b;
    return Number.isNaN(x) - Number.isNaN(y) || a - b;
  });
}

function buildHeader(column, onSort) {
  const unit = column.unit ? build("span", { class: "unit" }, ` ${column.unit}`) : null;
  const button = buildButton("", { title: column.hint }, () => onSort(column));
  button.append(column.title, ...(unit ? [unit] : []), build("span", { class: "direction" }));
  return build("th", { scope: "col", class: column.number ? "number" : "" }, button);
}

const buildSpacer = () => build("tbody", { "aria-hidden": "true", class: "spacer" },
    build("tr", {}, build("td", {})));

function setSpacer(spacer, height) {
  spacer.hidden = height === 0;
  spacer.rows[0].cells[0].style.height = `${height}px`;
}

function sizeColumns(table, columns) {
  const totalWidth = columns.reduce((sum, { width }) => sum + width, 0);
  const cols = columns.map(({ width }) => {
    const col = build("col");
    col.style.width = `${100 * width / totalWidth}%`;
    return col;
  });
  table.querySelector("colgroup").replaceChildren(...cols);
  table.style.minWidth = `${totalWidth}rem`;
}

// {box, setColumns(columns), show(items, sortedColumn, descending), focusItem(item)}; onOpen(item) when a
// row is clicked or entered, onSort(column) when a header is clicked.
export function buildTable({ label, onOpen, onSort }) {
  const head = build("tr", { "aria-rowindex": 1 });
  const above = buildSpacer(), body = build("tbody"), below = buildSpacer();
  const table = build("table", {
    class: "plan-table", role: "grid", tabindex: "0", "aria-label": label, "aria-readonly": "true",
  }, build("colgroup"), build("thead", {}, head), above, body, below);
  const box = build("div", { class: "table-box" }, table);
  let columns = [], items = [], current = -1, first = 0, last = -1, rowHeight = 30;

  const buildRow = (position) => {
    const row = build("tr", {
      id: `row-${position}`, "aria-rowindex": position + 2, class: position === current ? "current" : "",
    });
    for (const column of columns) {
      const cell = build("td", column.number ? { class: "number" } : {});
      column.fill(cell, items[position]);
      row.append(cell);
    }
    return row;
  };
  const draw = () => {
    body.replaceChildren(...Array.from({ length: last - first }, (_, k) => buildRow(first + k)));
    setSpacer(above, first * rowHeight);
    setSpacer(below, (items.length - last) * rowHeight);
    const seen = current >= first && current < last;
    if (seen) table.setAttribute("aria-activedescendant", `row-${current}`);
    else table.removeAttribute("aria-activedescendant");
  };
  const headHeight = () => head.offsetHeight;
  // Draws if rows became visible that are not elements yet.
  const drawVisible = (always) => {
    const top = Math.floor(box.scrollTop / rowHeight);
    const bottom = Math.ceil((box.scrollTop + box.clientHeight - headHeight()) / rowHeight);
    if (!always && top >= first && Math.min(bottom, items.length) <= last) return;
    first = Math.max(0, Math.min(top - kExtraRows, items.length));
    last = Math.max(first, Math.min(items.length, Math.max(bottom, top + 20) + kExtraRows));
    draw();
  };
  const measureRow = () => {
    const height = body.rows[0]?.offsetHeight;
    if (!height || height === rowHeight) return;
    rowHeight = height;
    drawVisible(true);
  };
  const goTo = (position) => {
    current = Math.min(items.length - 1, Math.max(0, position));
    const top = current * rowHeight, visibleHeight = box.clientHeight - headHeight() - rowHeight;
    if (box.scrollTop > top) box.scrollTop = top;
    if (box.scrollTop < top - visibleHeight) box.scrollTop = top - visibleHeight;
    drawVisible(true);
  };
  const page = () => Math.max(1, Math.floor(box.clientHeight / rowHeight) - 2);
  const keys = {
    ArrowDown: () => goTo(current + 1),
    ArrowUp: () => goTo(current - 1),
    PageDown: () => goTo(current + page()),
    PageUp: () => goTo(current - page()),
    Home: () => goTo(0),
    End: () => goTo(items.length - 1),
    Enter: () => { if (current >= 0) onOpen(items[current]); },
  };
  table.addEventListener("keydown", (event) => {
    if (event.target !== table || !Object.hasOwn(keys, event.key) || items.length === 0) return;
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    keys[event.key]();
  });
  table.addEventListener("focus", () => {
    if (current < 0 && items.length > 0) goTo(Math.ceil(box.scrollTop / rowHeight));
  });
  body.addEventListener("click", (event) => {
    const row = event.target.closest("tr");
    if (!row || event.target.closest("a") || !getSelection().isCollapsed) return;
    onOpen(items[Number(row.getAttribute("aria-rowindex")) - 2]);
  });
  box.addEventListener("scroll", () => drawVisible(false), { passive: true });
  new ResizeObserver(() => { measureRow(); drawVisible(false); }).observe(box);
  addEventListener("beforeprint", () => {
    [first, last] = [0, items.length];
    draw();
  });
  addEventListener("afterprint", () => drawVisible(true));

  return {
    box,
    setColumns(given) {
      columns = given;
      head.replaceChildren(...columns.map((column) => buildHeader(column, onSort)));
      table.setAttribute("aria-colcount", columns.length);
      sizeColumns(table, columns);
    },
    show(given, sorted, descending) {
      const kept = items[current];
      items = given;
      current = kept === undefined ? -1 : items.indexOf(kept);
      table.setAttribute("aria-rowcount", items.length + 1);
      columns.forEach((column, k) => {
        const direction = descending ? "descending" : "ascending";
        if (column === sorted) head.cells[k].setAttribute("aria-sort", direction);
        else head.cells[k].removeAttribute("aria-sort");
      });
      drawVisible(true);
      measureRow();
    },
    focusItem(item) {
      const position = items.indexOf(item);
      if (position >= 0) goTo(position);
      table.focus({ preventScroll: true });
    },
  };
}
