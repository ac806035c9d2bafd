// The runs: files, versions, hashes, configs.
import { report, rows } from "./data.js";
import { build, buildButton, buildName, runClass } from "./elements.js";
import { countText, plainText, shortText } from "./format.js";

function selectText(element) {
  const range = document.createRange();
  range.selectNodeContents(element);
  getSelection().removeAllRanges();
  getSelection().addRange(range);
}

// If the clipboard is not accessible, the text stays selected for the user to copy.
async function copyText(element, text, button) {
  element.textContent = text;
  selectText(element);
  let copied = true;
  try {
    await navigator.clipboard.writeText(text);
  } catch {
    copied = document.execCommand("copy");
  }
  button.textContent = copied ? "copied" : "selected";
}

function buildHash(hash) {
  const fullHash = plainText(hash ?? "");
  const code = build("code", { title: fullHash }, fullHash.slice(0, 12));
  const button = buildButton("copy", { class: "quiet", "aria-label": "copy the whole hash" },
      () => copyText(code, fullHash, button));
  return build("span", { class: "hash" }, code, button);
}

const fact = (term, ...values) => build("div", {}, build("dt", {}, term), build("dd", {}, ...values));

const joinedNames = (names) => names.flatMap((name, k) => (k === 0 ? [] : [", "]).concat(buildName(name)));

function uncheckedOf(run, index) {
  const own = run.robot?.unchecked_links ?? [];
  return own.length > 0 ? own : rows.find((row) => row.run === index)?.unchecked_links ?? [];
}

function shownWords({ plans, shown }) {
  return shown === plans ? `${countText(plans, "plan")}, all shown` : `${shown} of ${countText(plans, "plan")} shown`;
}

const configText = (config) => (config ?? "").split("\n").map(plainText).join("\n");

function buildConfig({ config }) {
  return build("details", {}, build("summary", {}, "Config (effective, defaults included)"),
      build("pre", { class: "config", tabindex: "0" }, configText(config)));
}

function buildRun(run, index) {
  const unchecked = uncheckedOf(run, index);
  const title = build("h3", {}, build("span", { class: runClass(index), "aria-hidden": "true" }),
      buildName(run.name || run.file));
  return build("article", { class: "run-card" }, title,
      run.not_verified ? build("p", { class: "warning" }, "Not verified: this file ", plainText(run.not_verified)) : null,
      run.left_out ? build("p", { class: "warning" }, shortText(run.left_out)) : null,
      unchecked.length > 0
        ? build("p", { class: "warning" }, "Contacts are not checked for: ", ...joinedNames(unchecked)) : null,
      build("dl", { class: "facts" },
          fact("Robot", buildName(run.robot_name)),
          fact("Plans", shownWords(run)),
          fact("File", buildName(run.file)),
          fact("Software", plainText(run.software)),
          fact("SHA-256 of the file", buildHash(run.sha256)),
          fact("SHA-256 of the config", buildHash(run.config_sha256)),
          fact("SHA-256 of the dataset", buildHash(run.dataset_sha256)),
          fact("Built with", shortText(run.built_with))),
      buildConfig(run));
}

export function buildRuns() {
  return build("section", { "aria-labelledby": "runs-title" },
      build("h2", { id: "runs-title" }, report.runs.length === 1 ? "Run" : "Runs"),
      build("div", { class: "run-cards" }, ...report.runs.map(buildRun)));
}
