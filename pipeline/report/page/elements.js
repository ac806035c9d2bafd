// Builds elements of the page; texts are never taken as HTML.
import { plainText, shortText } from "./format.js";

function fillElement(element, attributes, children) {
  for (const [name, value] of Object.entries(attributes)) {
    if (value !== null && value !== undefined && value !== false)
      element.setAttribute(name, value === true ? "" : value);
  }
  element.append(...children.filter((child) => child !== null && child !== undefined));
  return element;
}

export const build = (tag, attributes = {}, ...children) =>
  fillElement(document.createElement(tag), attributes, children);

export const buildSvg = (tag, attributes = {}, ...children) =>
  fillElement(document.createElementNS("http://www.w3.org/2000/svg", tag), attributes, children);

export function buildButton(text, attributes, onClick) {
  const button = build("button", { type: "button", ...attributes }, text);
  button.addEventListener("click", onClick);
  return button;
}

// A name from a file, isolated in its writing direction, with the full name as its title.
export const buildName = (name) => build("bdi", { title: plainText(name) }, shortText(name));

export const buildStatus = (status) => build("span", { class: `status ${status}` }, status);

export const runClass = (run) => `run run-${run % 4}`;
