// Making parts of the page. Text goes in as text nodes only, never as markup.

const SVG_NAMESPACE = "http://www.w3.org/2000/svg";

export function append(parent, children) {
  for (const child of children.flat()) {
    if (child === null || child === undefined) continue;
    parent.append(child instanceof Node ? child : document.createTextNode(String(child)));
  }
  return parent;
}

/// An HTML element: el("p", {class: "note"}, "text", otherElement).
export function el(name, attributes = {}, ...children) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (typeof value === "function")
      element.addEventListener(key, value);
    else if (value !== null && value !== false)
      element.setAttribute(key, value === true ? "" : value);
  }
  return append(element, children);
}

/// An SVG element.
export function svg(name, attributes = {}, ...children) {
  const element = document.createElementNS(SVG_NAMESPACE, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  return append(element, children);
}

/// An SVG text element.
export function label(x, y, text, attributes = {}) { return svg("text", {x, y, ...attributes}, text); }

export function notRecorded(what) { return el("p", {class: "missing"}, `${what}: not recorded.`); }

/// A table from its heads and its rows of cells; a cell is text, an element, or null. Columns in `text` are not
/// numbers.
export function table(heads, rows, {text = [0], caption = null} = {}) {
  const kind = (index) => ({class: text.includes(index) ? null : "number"});
  const body =
      rows.map((row) => el("tr", {}, row.map((cell, i) => el("td", kind(i), cell === null ? "\u2013" : cell))));
  return el(
      "div", {class: "table"},
      el("table", {}, caption ? el("caption", {}, caption) : null,
         heads.length ?
             el("thead", {}, el("tr", {}, heads.map((head, i) => el("th", {scope: "col", ...kind(i)}, head)))) :
             null,
         el("tbody", {}, body)));
}

/// A button that prints the section it stands in, and nothing else of the page; `prepare` is called before.
export function printButton(text, prepare = () => {}) {
  return el("button", {
    type: "button",
    class: "print",
    click: (event) => {
      prepare();
      const section = event.currentTarget.closest("section");
      section.classList.add("printed");
      document.body.classList.add("section-only");
      window.print();
      document.body.classList.remove("section-only");
      section.classList.remove("printed");
    },
  }, text);
}

/// A group of buttons of which one is pressed; `choose` is called with its value.
export function choice(name, options, chosen, choose) {
  const buttons = options.map(
      ([value, text]) =>
          el("button", {
            type: "button",
            "aria-pressed": String(value === chosen),
            click: (event) => {
              buttons.forEach((button) => button.setAttribute("aria-pressed", String(button === event.currentTarget)));
              choose(value);
            }
          },
             text));
  return el("div", {class: "choice", role: "group", "aria-label": name}, buttons);
}

// Every figure draws itself for the width that it gets, and again when the width or the colours change.
const figures = [];

/// A figure whose `draw(width)` returns the element to show at that width in CSS pixels. Returns {element, redraw}.
export function figure(description, draw) {
  const stage = el("div", {class: "stage", role: "img", "aria-label": description});
  let drawnWidth = 0;
  const redraw = () => {
    if (drawnWidth > 0) stage.replaceChildren(draw(drawnWidth));
  };
  new ResizeObserver(() => {
    if (document.documentElement.dataset.printing || Math.abs(stage.clientWidth - drawnWidth) < 1) return;
    drawnWidth = stage.clientWidth;
    redraw();
  }).observe(stage);
  figures.push(redraw);
  return {element: stage, redraw};
}

/// A colour of the style sheet by its variable's name.
export function colour(name) { return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim(); }

/// Follows the reader's colour scheme, and is light for the printer; figures are drawn again with the colours.
export function followColourScheme() {
  const dark = matchMedia("(prefers-color-scheme: dark)"), page = document.documentElement;
  const apply = (isDark) => {
    page.dataset.scheme = isDark ? "dark" : "light";
    figures.forEach((redraw) => redraw());
  };
  apply(dark.matches);
  dark.addEventListener("change", () => apply(dark.matches));
  addEventListener("beforeprint", () => {
    page.dataset.printing = "yes";
    apply(false);
  });
  addEventListener("afterprint", () => {
    delete page.dataset.printing;
    apply(dark.matches);
  });
}
