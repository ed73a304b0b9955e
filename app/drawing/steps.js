// Steps of a document's stepped tool: their number, and the name and mark of each number of inserted steps. The number
// of steps comes from the document and is defined in the tool's cell file.
import {plural} from "./numbers.js";

/** @typedef {import("./kinds.js").Mark} Mark */
/** @typedef {{name: string, mark: Mark}} StepKind Name and mark of a number of inserted steps. */
/**
 * Document from which the number of steps is derived: from the steps' names, the tool, the counts of tubes per number
 * of steps, or the probabilities of a tube.
 * @typedef {{step_words?: unknown, steps?: unknown, counts?: unknown, tubes?: unknown,
 *   base?: unknown}} SteppedDocument
 */

/**
 * Marks of no inserted step (`none`), of all steps (`all`), and of 1, 2, ... steps (`some`, repeated cyclically).
 * @typedef {{none: Mark, all: Mark, some: Mark[]}} StepMarks
 */

/** Marks of steps inserted from a calibrated base. @type {StepMarks} */
const PLACED = {
  none: {shape: "cross", colour: "case0"},
  all: {shape: "disc", colour: "case3"},
  some: [
    {shape: "triangle", colour: "case1"},
    {shape: "square", colour: "case2"},
    {shape: "half", colour: "ink"},
    {shape: "double-ring", colour: "violet"},
    {shape: "target", colour: "case1"},
    {shape: "bar", colour: "case2"},
    {shape: "ring", colour: "ink"},
  ],
};

/** @param {import("./shapes.js").Shape} shape @returns {Mark} */
const nominal = (shape) => ({shape, colour: "accent"});

/** Marks of steps inserted from a nominal base, which is assumed to be exact. @type {StepMarks} */
const NOMINAL = {
  none: nominal("plus"),
  all: nominal("crossed-ring"),
  some: /** @type {import("./shapes.js").Shape[]} */ ([
    "hollow-triangle",
    "hollow-square",
    "hollow-diamond",
    "split-square",
    "split-diamond",
    "crossed-square",
    "crossed-diamond",
  ]).map(nominal),
};

/**
 * Returns the mark of a number of inserted steps of a tool with `count` steps. The marks for a nominal base (placed:
 * false) differ from those for a calibrated one.
 * @param {number} inserted @param {number} count @param {{placed?: unknown} | null} [base]
 */
export function stepMark(inserted, count, base) {
  const {none, all, some} = base?.placed === false ? NOMINAL : PLACED;
  if (inserted <= 0) return none;
  return inserted >= count ? all : some[(inserted - 1) % some.length];
}

/** Returns the number of steps of a document's tool; 0 if not stated. @param {SteppedDocument} document */
export function stepCountOf({step_words: words, steps, counts, tubes}) {
  if (Array.isArray(words) && words.length > 0) return words.length - 1;
  if (Array.isArray(steps) && steps.length > 0) return steps.length;
  const byMode = counts !== null && typeof counts === "object" ? Object.values(counts) : [];
  const chances = Array.isArray(tubes) ? tubes.map((tube) => tube?.probability_by_steps) : [];
  return (byMode.concat(chances).find((row) => Array.isArray(row) && row.length > 0)?.length ?? 1) - 1;
}

/**
 * Returns the names and marks of all numbers of inserted steps, from none to all; the index is the number of steps.
 * @param {SteppedDocument} document @returns {StepKind[]}
 */
export function stepKinds(document) {
  const count = stepCountOf(document);
  const base = /** @type {{placed?: unknown} | null | undefined} */ (document.base);
  return Array.from({length: count + 1}, (_, inserted) => ({
    name: stepText(document.step_words, inserted),
    mark: stepMark(inserted, count, base),
  }));
}

/**
 * Returns the name of a number of inserted steps, if possible from the document's `step_words`.
 * @param {unknown} words @param {number} steps
 */
export function stepText(words, steps) {
  const own = Array.isArray(words) ? words[steps] : undefined;
  return typeof own === "string" && own !== "" ? own : plural(steps, "step");
}

/**
 * Returns the number of steps that enter the tube at a centring error, given the centring tolerances of all steps.
 * @param {number} error @param {readonly number[]} tolerances
 */
export function stepsAtError(error, tolerances) {
  const first = tolerances.findIndex((tolerance) => error > tolerance);
  return first < 0 ? tolerances.length : first;
}
