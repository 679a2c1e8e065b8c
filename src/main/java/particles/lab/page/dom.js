// What all modules need: the page's elements, new ones, colours and short numbers.
export const $ = id => document.getElementById(id);
export function make(tag, properties, ...children) {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
}
/** A colour of the page. */
export const ink = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
export const few = (number, digits = 4) => String(Number(number.toPrecision(digits)));
