// Shape and colour of what is marked, by its kind. Words are no part of it: they come with the documents, from the
// tables that the kinds are rows of. Colours are names of the style sheets' variables.

/** @typedef {import("./shapes.js").Shape} Shape */
/** @typedef {"ink"|"muted"|"accent"|"hole"|"faint"|"rose"|"violet"|"case0"|"case1"|"case2"|"case3"} MarkColour */
/** @typedef {{shape: Shape, colour: MarkColour}} Mark */

/** Tubes that cannot be visited, that were not scored, that nobody asked for. @type {Mark} */
export const UNREACHABLE = {shape: "hatched", colour: "rose"};
/** @type {Mark} */
export const UNSCORED = {shape: "diamond", colour: "muted"};
/** @type {Mark} */
export const NOT_PLANNED = {shape: "dot", colour: "faint"};

/** @type {Record<string, Mark>} */
const STATES = {
  open: {shape: "ring", colour: "hole"},
  plugged: {shape: "disc", colour: "ink"},
  stabilised: {shape: "square", colour: "ink"},
  sleeved: {shape: "double-ring", colour: "violet"},
  "to-plug": {shape: "half", colour: "violet"},
  inaccessible: {shape: "bar", colour: "ink"},
  unresolved: {shape: "target", colour: "violet"},
};
/** @type {Record<string, Mark>} */
const VERDICTS = {
  adequate: {shape: "disc", colour: "case3"},
  explained: {shape: "square", colour: "accent"},
  "partly-explained": {shape: "square", colour: "violet"},
  ambiguous: {shape: "half", colour: "violet"},
  unexplained: {shape: "cross", colour: "case0"},
  inconclusive: {shape: "ring", colour: "muted"},
  "falls-short": {shape: "triangle", colour: "case0"},
};
/** Mark of a kind that is not in its table. @type {Mark} */
const OTHER = {shape: "diamond", colour: "violet"};

/** The state of a hole's tube. @param {string} name @returns {Mark} */
export function stateMark(name) {
  return Object.hasOwn(STATES, name) ? STATES[name] : OTHER;
}

/** @param {string} name @returns {Mark} */
export function verdictMark(name) {
  return Object.hasOwn(VERDICTS, name) ? VERDICTS[name] : {shape: "diamond", colour: "muted"};
}

/** Errors before, hollow, and after, full: told apart without colour. @type {Mark} */
export const BEFORE = {shape: "triangle", colour: "case0"};
/** @type {Mark} */
export const AFTER = {shape: "disc", colour: "accent"};
