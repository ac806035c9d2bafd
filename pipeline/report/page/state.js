// The open movement, the time and the selection, and listeners to their changes.
//
//   event     when
//   "open"    another movement is opened, or the first page (row null)
//   "time"    the clock shows another instant
//   "pick"    a joint, finger or pair is picked, or none
//   "filter"  the first page shows other rows

const listeners = new Map();

export function on(event, listener) {
  if (!listeners.has(event)) listeners.set(event, []);
  listeners.get(event).push(listener);
}

export function emit(event) {
  for (const listener of listeners.get(event) ?? []) listener();
}

export const state = {
  row: null, // index into rows of the movement that is open
  time: 0, // of the clock [s]
  // {kind: "joint", index} | {kind: "finger", index (of tips)} | {kind: "pair", first, second} | null
  pick: null,
};

export function setTime(time) {
  state.time = time;
  emit("time");
}

const samePick = (a, b) => JSON.stringify(a) === JSON.stringify(b);

// Picks a joint, fingertip or pair; picking it again releases it.
export function pick(selection) {
  state.pick = samePick(state.pick, selection) ? null : selection;
  emit("pick");
}

// A movement's address: #<plan>/<time on the clock>, of several runs #<run>:<plan>/<time>; without a
// time it opens at the worst instant or the beginning.
export function addressOf(rows, index, time = null) {
  const { run, plan } = rows[index];
  const hasSeveralRuns = rows.some((row) => row.run !== 0);
  const name = plan.split("/").map(encodeURIComponent).join("/");
  return `#${hasSeveralRuns ? `${run}:` : ""}${name}${time === null ? "" : `/${time.toFixed(3)}`}`;
}

// {row, time} of an address, null if it names no movement. A demonstration's name may have slashes.
export function readAddress(rows, hash) {
  const match = /^#(?:(\d+):)?(.+)$/.exec(hash);
  if (!match) return null;
  const run = Number(match[1] ?? 0);
  const rowIndexOf = (name) => {
    try {
      const plan = decodeURIComponent(name);
      return rows.findIndex((row) => row.run === run && row.plan === plan);
    } catch {
      return -1; // not an address that this page wrote
    }
  };
  const untimed = rowIndexOf(match[2]);
  if (untimed >= 0) return { row: untimed, time: NaN };
  const timed = /^(.+)\/(-?[\d.]+)?$/.exec(match[2]);
  const row = timed ? rowIndexOf(timed[1]) : -1;
  return row < 0 ? null : { row, time: Number(timed[2] ?? NaN) };
}
