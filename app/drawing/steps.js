// The steps of a document's tool: how many there are, what each number of inserted steps is called, and its mark. A tool
// has as many steps as its cell says, and the document carries them.
import {plural} from "./numbers.js";

/** @typedef {import("./kinds.js").Mark} Mark */
/** @typedef {{name: string, mark: Mark}} StepKind What a number of inserted steps is called, and how it is drawn. */
/**
 * Document that states the steps: by their words, the tool itself, tubes counted by steps, or a tube's probabilities.
 * @typedef {{step_words?: unknown, steps?: unknown, counts?: unknown, tubes?: unknown,
 *    base?: unknown}} SteppedDocument
 */

/**
 * Marks of no step, of all, and from the first to the last but one; the latter repeat beyond the eighth.
 * @typedef {{none: Mark, all: Mark, some: Mark[]}} StepMarks
 */

/** @type {StepMarks} */
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

/** Marks for a nominal base, which hold if it stands exactly where it should. @type {StepMarks} */
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
 * The mark of so many inserted steps of a tool that has `count`, by the base that a document says they are of.
 * @param {number} inserted @param {number} count @param {{placed?: unknown} | null} [base]
 */
export function stepMark(inserted, count, base) {
  const {none, all, some} = base?.placed === false ? NOMINAL : PLACED;
  if (inserted <= 0) return none;
  return inserted >= count ? all : some[(inserted - 1) % some.length];
}

/** Returns the number of steps of a document's tool; 0 if it is not stated. @param {SteppedDocument} document */
export function stepCountOf({step_words: words, steps, counts, tubes}) {
  if (Array.isArray(words) && words.length > 0) return words.length - 1;
  if (Array.isArray(steps) && steps.length > 0) return steps.length;
  const byMode = counts !== null && typeof counts === "object" ? Object.values(counts) : [];
  const chances = Array.isArray(tubes) ? tubes.map((tube) => tube?.probability_by_steps) : [];
  return (byMode.concat(chances).find((row) => Array.isArray(row) && row.length > 0)?.length ?? 1) - 1;
}

/**
 * Returns names and marks of 0, 1, ..., all inserted steps.
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

/** Returns words on the steps that enter, the document's if it has some. @param {unknown} words @param {number} steps */
export function stepText(words, steps) {
  const own = Array.isArray(words) ? words[steps] : undefined;
  return typeof own === "string" && own !== "" ? own : plural(steps, "step");
}

/**
 * The number of steps of the tool that enter at a centring error, by the tolerances of all of them.
 * @param {number} error @param {readonly number[]} tolerances
 */
export function stepsAtError(error, tolerances) {
  const first = tolerances.findIndex((tolerance) => error > tolerance);
  return first < 0 ? tolerances.length : first;
}
