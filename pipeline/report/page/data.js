// The report's data: what stands in the page as text, read once. README.md has the contract.

const jsonOf = (id) => JSON.parse(document.getElementById(id).textContent);

export const report = jsonOf("report");
export const rows = jsonOf("rows");

// What a reason means, as a sentence.
export const reasonSentence = (reason) => (Object.hasOwn(report.reasons, reason) ? report.reasons[reason] : "");

// Values of a table, row by row, from the bytes of its columns.
function decodeTable(bytes, { array: [rowCount, columnCount], step, at }) {
  const values = new Float64Array(rowCount * columnCount);
  let next = at;
  for (let column = 0; column < columnCount; ++column) {
    let before = 0, last = 0;
    for (let row = 0; row < rowCount; ++row) {
      let code = 0, weight = 1, byte;
      do {
        byte = bytes[next++];
        code += (byte & 127) * weight;
        weight *= 128;
      } while (byte >= 128);
      let value = NaN;
      if (code > 0) {
        const zigzag = code - 1;
        const second = zigzag % 2 === 0 ? zigzag / 2 : -(zigzag + 1) / 2;
        const whole = second + 2 * last - before;
        before = last;
        last = whole;
        value = whole * step;
      }
      values[row * columnCount + column] = value;
    }
  }
  return { rows: rowCount, cols: columnCount, values };
}

function withTables(node, bytes) {
  if (Array.isArray(node)) return node.map((each) => withTables(each, bytes));
  if (node === null || typeof node !== "object") return node;
  if (Array.isArray(node.array)) return decodeTable(bytes, node);
  const out = {};
  for (const [key, value] of Object.entries(node)) out[key] = withTables(value, bytes);
  return out;
}

async function inflate(base64) {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

const whole = new Promise((resolve) => {
  if (document.readyState !== "loading") resolve();
  else document.addEventListener("DOMContentLoaded", resolve, { once: true });
});

// What a block holds, tables as {rows, cols, values}. The last few are kept.
const kept = new Map();
const kMostKept = 32;

export function loadBlock(id) {
  if (!kept.has(id)) {
    if (kept.size >= kMostKept) kept.delete(kept.keys().next().value);
    kept.set(id, readBlock(id));
  }
  return kept.get(id);
}

async function readBlock(id) {
  let element = document.getElementById(id);
  if (!element) {
    await whole;
    element = document.getElementById(id);
  }
  const bytes = await inflate(element.textContent);
  const length = new DataView(bytes.buffer).getUint32(0, true);
  const json = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + length)));
  return withTables(json, bytes.subarray(4 + length));
}

// A table's value; NaN: not seen.
export const at = (table, row, column = 0) => table.values[row * table.cols + column];

export function rowOf(table, row) {
  return table.values.subarray(row * table.cols, (row + 1) * table.cols);
}
