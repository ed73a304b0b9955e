// Shapes and colours of marks, keyed by kind. The text for each kind comes with the documents. Colours are names of
// variables of the style sheets.

/** @typedef {import("./shapes.js").Shape} Shape */
/** @typedef {"ink"|"muted"|"accent"|"hole"|"faint"|"rose"|"violet"|"case0"|"case1"|"case2"|"case3"} MarkColour */
/** @typedef {{shape: Shape, colour: MarkColour}} Mark */

/** Mark of tubes that cannot be visited. @type {Mark} */
export const UNREACHABLE = {shape: "hatched", colour: "rose"};
/** Mark of tubes that were not scored. @type {Mark} */
export const UNSCORED = {shape: "diamond", colour: "muted"};
/** Mark of tubes that are not on the work list. @type {Mark} */
export const NOT_PLANNED = {shape: "dot", colour: "faint"};

/** Marks of tube states. @type {Record<string, Mark>} */
const STATES = {
  open: {shape: "ring", colour: "hole"},
  plugged: {shape: "disc", colour: "ink"},
  stabilised: {shape: "square", colour: "ink"},
  sleeved: {shape: "double-ring", colour: "violet"},
  "to-plug": {shape: "half", colour: "violet"},
  inaccessible: {shape: "bar", colour: "ink"},
  unresolved: {shape: "target", colour: "violet"},
};
/** Marks of diagnosis and comparison verdicts. @type {Record<string, Mark>} */
const VERDICTS = {
  adequate: {shape: "disc", colour: "case3"},
  explained: {shape: "square", colour: "accent"},
  "partly-explained": {shape: "square", colour: "violet"},
  ambiguous: {shape: "half", colour: "violet"},
  unexplained: {shape: "cross", colour: "case0"},
  inconclusive: {shape: "ring", colour: "muted"},
  "falls-short": {shape: "triangle", colour: "case0"},
};
/** Marks of the standings of an outage's items. @type {Record<string, Mark>} */
const STANDINGS = {
  held: {shape: "cross", colour: "case0"},
  queued: {shape: "triangle", colour: "case1"},
  open: {shape: "ring", colour: "hole"},
  done: {shape: "disc", colour: "case3"},
  excluded: {shape: "bar", colour: "muted"},
};
/** Mark of a tube state without an entry in STATES. @type {Mark} */
const OTHER = {shape: "diamond", colour: "violet"};

/** Returns the mark of a tube's state. @param {string} name @returns {Mark} */
export function stateMark(name) {
  return Object.hasOwn(STATES, name) ? STATES[name] : OTHER;
}

/** Returns the mark of an item's standing. @param {string} name @returns {Mark} */
export function standingMark(name) {
  return Object.hasOwn(STANDINGS, name) ? STANDINGS[name] : NOT_PLANNED;
}

/** @param {string} name @returns {Mark} */
export function verdictMark(name) {
  return Object.hasOwn(VERDICTS, name) ? VERDICTS[name] : {shape: "diamond", colour: "muted"};
}

/**
 * Mark of errors before a change. It has another shape than AFTER, so that the marks differ even without colour. @type
 * {Mark}
 */
export const BEFORE = {shape: "triangle", colour: "case0"};
/** Mark of errors after a change. @type {Mark} */
export const AFTER = {shape: "disc", colour: "accent"};
