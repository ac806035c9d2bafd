// A colour of style.css, in the current theme.
export const colour = (name) =>
  getComputedStyle(document.documentElement).getPropertyValue(name).trim();
