// From the page's data to its sections.
import {el} from "./elements.js";
import {object} from "./values.js";

export function readReport() { return object(JSON.parse(document.getElementById("report").textContent)) ?? {}; }

/// A section that cannot be drawn says so and leaves the others alone.
function makeSection({id, title, make}, number, report, sheet) {
  let content;
  try {
    content = make(report, sheet);
  } catch (error) {
    content = [el("p", {class: "missing"}, `This part could not be drawn: ${error.message}`)];
  }
  return el("section", {id}, el("h2", {}, el("span", {class: "count"}, number), title), content);
}

/// Numbers the sections, lists them under the head and shows them. `shared` is what all of them draw on.
export function showSections(sections, report, shared) {
  sections.forEach((section, i) => {
    document.getElementById("contents").append(el("a", {href: `#${section.id}`}, section.title));
    document.getElementById("sections").append(makeSection(section, i + 1, report, shared));
  });
}
