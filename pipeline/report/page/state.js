// What is open, picked and shown, and who wants to know when it changes.
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

// Picking what is picked already lets go of it.
export function pick(what) {
  state.pick = samePick(state.pick, what) ? null : what;
  emit("pick");
}

// A movement's address: #<plan>/<time on the clock>, of several runs #<run>:<plan>/<time>; without
// a time it opens where there is most to see.
export function addressOf(rows, index, time = null) {
  const { run, plan } = rows[index];
  const several = rows.some((row) => row.run !== 0);
  const name = plan.split("/").map(encodeURIComponent).join("/");
  return `#${several ? `${run}:` : ""}${name}${time === null ? "" : `/${time.toFixed(3)}`}`;
}

// {row, time} of an address, null if it names no movement. A demonstration's name may have slashes.
export function readAddress(rows, hash) {
  const found = /^#(?:(\d+):)?(.+)$/.exec(hash);
  if (!found) return null;
  const run = Number(found[1] ?? 0);
  const rowNamed = (name) => {
    try {
      const plan = decodeURIComponent(name);
      return rows.findIndex((each) => each.run === run && each.plan === plan);
    } catch {
      return -1; // not an address that this page wrote
    }
  };
  const whole = rowNamed(found[2]);
  if (whole >= 0) return { row: whole, time: NaN };
  const timed = /^(.+)\/(-?[\d.]+)?$/.exec(found[2]);
  const row = timed ? rowNamed(timed[1]) : -1;
  return row < 0 ? null : { row, time: Number(timed[2] ?? NaN) };
}
