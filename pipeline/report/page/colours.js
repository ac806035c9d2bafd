// A colour of style.css, in the theme that is on.
export const colour = (name) =>
  getComputedStyle(document.documentElement).getPropertyValue(name).trim();
