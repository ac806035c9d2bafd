// The report's data, read once from the page. README.md has the format.

const jsonOf = (id) => JSON.parse(document.getElementById(id).textContent);

export const report = jsonOf("report");
export const rows = jsonOf("rows");

// The meaning of a reason, as a sentence.
export const reasonSentence = (reason) => (Object.hasOwn(report.reasons, reason) ? report.reasons[reason] : "");

// Values of a table, row by row, from the bytes of its columns.
function decodeTable(bytes, { array: [rowCount, columnCount], step, offset }) {
  const values = new Float64Array(rowCount * columnCount);
  let next = offset;
  for (let column = 0; column < columnCount; ++column) {
    let beforeLast = 0, last = 0;
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
        const steps = second + 2 * last - beforeLast;
        beforeLast = last;
        last = steps;
        value = steps * step;
      }
      values[row * columnCount + column] = value;
    }
  }
  return { rows: rowCount, cols: columnCount, values };
}

function decodeTables(node, bytes) {
  if (Array.isArray(node)) return node.map((element) => decodeTables(element, bytes));
  if (node === null || typeof node !== "object") return node;
  if (Array.isArray(node.array)) return decodeTable(bytes, node);
  const out = {};
  for (const [key, value] of Object.entries(node)) out[key] = decodeTables(value, bytes);
  return out;
}

async function inflate(base64) {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

const documentLoaded = new Promise((resolve) => {
  if (document.readyState !== "loading") resolve();
  else document.addEventListener("DOMContentLoaded", resolve, { once: true });
});

// The contents of a block, tables as {rows, cols, values}. The last few blocks are kept.
const loadedBlocks = new Map();
const kMaxLoadedBlocks = 32;

export function loadBlock(id) {
  if (!loadedBlocks.has(id)) {
    if (loadedBlocks.size >= kMaxLoadedBlocks) loadedBlocks.delete(loadedBlocks.keys().next().value);
    loadedBlocks.set(id, readBlock(id));
  }
  return loadedBlocks.get(id);
}

async function readBlock(id) {
  let element = document.getElementById(id);
  if (!element) {
    await documentLoaded;
    element = document.getElementById(id);
  }
  const bytes = await inflate(element.textContent);
  const length = new DataView(bytes.buffer).getUint32(0, true);
  const json = JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + length)));
  return decodeTables(json, bytes.subarray(4 + length));
}

// A table's value; NaN: unknown.
export const valueAt = (table, row, column = 0) => table.values[row * table.cols + column];

export function rowOf(table, row) {
  return table.values.subarray(row * table.cols, (row + 1) * table.cols);
}
