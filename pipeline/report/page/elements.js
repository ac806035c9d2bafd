// Elements of the page. Text goes in as text.
import { plainText, shortText } from "./words.js";

function withParts(made, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (value !== null && value !== undefined && value !== false)
      made.setAttribute(name, value === true ? "" : value);
  }
  made.append(...children.filter((child) => child !== null && child !== undefined));
  return made;
}

export const build = (tag, attributes = {}, ...children) =>
  withParts(document.createElement(tag), attributes, children);

export const buildSvg = (tag, attributes = {}, ...children) =>
  withParts(document.createElementNS("http://www.w3.org/2000/svg", tag), attributes, children);

export function buildButton(text, attributes, onClick) {
  const button = build("button", { type: "button", ...attributes }, text);
  button.addEventListener("click", onClick);
  return button;
}

// A name from a file: on its own in writing direction, whole in its title.
export const buildName = (name) => build("bdi", { title: plainText(name) }, shortText(name));

export const buildStatus = (status) => build("span", { class: `status ${status}` }, status);

export const runClass = (run) => `run run-${run % 4}`;
