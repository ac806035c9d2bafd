// What a certificate holds for and what it rests on, in one box: certified, inferred, assumed, set by
// hand, not looked at. Its first line names the subjects; opened, it says what was taken for them.
import { report, rows } from "./data.js";
import { build } from "./elements.js";
import { countText, plainText } from "./format.js";

const kAssumptionKinds = [["inferred", "inferred"], ["assumed", "assumed"], ["set_by_hand", "set by hand"],
                          ["not_looked_at", "not looked at"]];

// groups: [{kind, heading, short (text), details ([text])}]
function buildBox(groups) {
  const short = groups.map(({ kind, heading, short: text }) =>
    build("span", { class: `group ${kind}` }, build("b", {}, heading), ` ${plainText(text)}`));
  const long = groups.map(({ kind, heading, details }) =>
    build("div", { class: `group ${kind}` }, build("h3", {}, heading),
        build("ul", {}, ...details.map((text) => build("li", {}, plainText(text))))));
  return build("details", { class: "certificate" },
      build("summary", { title: "certified, assumed, not looked at" }, ...short), build("div", { class: "groups" }, ...long));
}

const kMaxDetails = 20; // of many plans

const shortened = (texts) => (texts.length <= kMaxDetails ? texts
    : [...texts.slice(0, kMaxDetails), `and ${countText(texts.length - kMaxDetails, "other")}`]);

// [{kind, heading, short, details}] of assumptions; of(subject) → words after a subject.
function assumptionGroups(assumptions, of = () => "") {
  return kAssumptionKinds.flatMap(([kind, heading]) => {
    const own = assumptions.filter((each) => each.kind === kind);
    if (own.length === 0) return [];
    const subjects = [...new Set(own.map(({ subject }) => subject))];
    return [{ kind, heading, short: subjects.map((subject) => (kind === "set_by_hand" ? subject : subject.replaceAll("_", " ")) + of(subject)).join(", "),
              details: shortened([...new Set(own.map(({ text }) => text))]) }];
  });
}

const clearanceText = ({ kind, clearance, first, second, time, plan }) =>
  `${kind} clearance ${(1e3 * clearance).toFixed(2)} mm: ${first} and ${second} at ${time.toFixed(2)} s${plan ? ` of ${plan}` : ""}`;

const groupOf = (short, ...details) => ({ kind: "certified", heading: "certified", short, details });
const unverifiedGroup = (reason) => groupOf("nothing: the file is not verified", `the file ${reason}`);

function certifiedGroup(ofPlans, clearances) {
  const least = clearances.map(({ kind, clearance }) => `${kind} ${(1e3 * clearance).toFixed(1)} mm`);
  return groupOf(`limits, collisions, tracking${ofPlans}${least.length > 0 ? `; least clearance ${least.join(", ")}` : ""}`,
      "limits, collisions and tracking, along the curve and between its samples", ...clearances.map(clearanceText));
}

function certifiedOf(row, notVerified) {
  if (notVerified) return unverifiedGroup(notVerified);
  if (row.status === "infeasible") return groupOf("nothing: there is no trajectory", "no trajectory, hence no certificate");
  return certifiedGroup("", row.certificate.clearance_by_kind ?? []);
}

// The box of a plan; null for files of earlier versions, which say nothing.
export function certificateOf(row) {
  const run = report.runs[row.run];
  const assumptions = assumptionGroups([...row.assumptions, ...run.assumptions]);
  if (assumptions.length === 0 && !row.certificate.clearance_by_kind) return null;
  return buildBox([certifiedOf(row, run.not_verified), ...assumptions]);
}

// The least clearance of each kind over some plans, with the plan.
function leastClearances(planRows) {
  const least = new Map();
  for (const { plan, certificate } of planRows) {
    for (const entry of certificate.clearance_by_kind ?? []) {
      if (!(least.get(entry.kind)?.clearance <= entry.clearance)) least.set(entry.kind, { ...entry, plan });
    }
  }
  return [...least.values()];
}

// The box of all plans of a run.
export function certificateOfRun(run, index) {
  const planRows = rows.filter((row) => row.run === index);
  const certified = planRows.filter(({ status }) => status !== "infeasible");
  const counts = new Map();
  for (const { assumptions } of planRows) {
    for (const subject of new Set(assumptions.map(({ subject }) => subject))) counts.set(subject, (counts.get(subject) ?? 0) + 1);
  }
  const ofFile = new Set(run.assumptions.map(({ subject }) => subject));
  const of = (subject) => (ofFile.has(subject) || counts.get(subject) === planRows.length
    ? "" : ` (${counts.get(subject)} of ${countText(planRows.length, "plan")})`);
  const groups = assumptionGroups([...planRows.flatMap(({ assumptions }) => assumptions), ...run.assumptions], of);
  const least = leastClearances(certified);
  if (groups.length === 0 && least.length === 0) return null;
  const head = run.not_verified
    ? unverifiedGroup(run.not_verified) : certifiedGroup(` of ${countText(certified.length, "plan")}`, least);
  return buildBox([head, ...groups]);
}
