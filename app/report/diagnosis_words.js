// ---- diagnosis_words.js: the names of verdicts, effects and their numbers in plain words, and signs for them.

/// Each with a colour and a shape; the shape alone tells them apart in print.
const VERDICTS = {
  "adequate": {word: "Adequate: nothing is missing", colour: "case3", shape: "disc"},
  "explained": {word: "Explained", colour: "accent", shape: "square"},
  "partly-explained": {word: "Partly explained: sure causes, and a remainder", colour: "state", shape: "square"},
  "ambiguous": {word: "Ambiguous: one of several", colour: "state", shape: "half"},
  "unexplained": {word: "Unexplained: none of the known effects", colour: "case0", shape: "cross"},
  "inconclusive": {word: "Inconclusive: more readings are needed", colour: "muted", shape: "ring"},
  "falls-short": {word: "The model falls short", colour: "case0", shape: "triangle"},
};

function verdictOf(report) {
  const name = textOf(report.verdict, "");
  if (name === "") return null;
  return Object.hasOwn(VERDICTS, name) ? VERDICTS[name] : {word: name, colour: "muted", shape: "diamond"};
}

/// What an effect is, for a reader who does not know its name.
const EFFECT_WORDS = {
  "joint-offset": "a joint's zero is off",
  "joint-scale": "a joint's gear ratio is off",
  "encoder-eccentricity": "a joint's encoder runs off centre: an error once per turn",
  "transmission-error": "a joint's gear errs twice per turn",
  "hysteresis": "a joint rests elsewhere by the sense of its last motion",
  "joint-coupling": "one joint's motion moves another",
  "link-length": "a link is longer or shorter than drawn",
  "link-twist": "a link is twisted",
  "tool-offset": "the tip is elsewhere on the tool",
  "link-weight": "a link weighs more or less",
  "tool-weight": "the tool weighs more or less",
  "payload-offset": "the load hangs beside the tip",
  "gravity-tilt": "gravity leans in the base's frame",
  "hose-pull": "a hose or cable pulls at a link",
  "contact-force": "something presses on the tip",
  "joint-compliance": "a joint axis taken as rigid gives",
  "link-bending": "a beam taken as rigid bends",
  "link-torsion": "a beam taken as rigid twists",
  "stiffening": "a joint is soft under small moments and stiffer beyond",
  "backlash": "a clearance is crossed with the moment's sense",
  "thermal-growth": "lengths grow with temperature",
  "base-slip": "the base has slipped once",
  "base-drift": "the base creeps in time",
  "scale-error": "the measuring scale is off",
  "gravity-sag": "a joint gives under weights that the arm file does not state",
  "tool-remount": "the tip was mounted anew for a set-up",
  "gear-wave": "a joint's gear errs once per turn of the motor",
  "slide-bending": "a slide bends by how far it is out",
  "cable-stretch": "a joint's cable stretches with torque and direction",
  "free": "a number of the arm's file is off",
};

function effectTitle(effect) {
  return `${textOf(effect.effect)}${textOf(effect.at, "") === "" ? "" : ` at ${effect.at}`}`;
}

function effectWords(effect) { return Object.hasOwn(EFFECT_WORDS, effect.effect) ? EFFECT_WORDS[effect.effect] : null; }

function unitText(unit) { return textOf(unit, "") === "" || unit === "1" ? "" : `\u00a0${unit}`; }

/// A value with as many digits as its sigma tells: 0.1101 \u00b1 0.0007 deg.
function withSigma(size) {
  const number = object(size);
  if (!number || !isNumber(number.value)) return MISSING;
  const unit = unitText(number.unit);
  const sigma = number.sigma;
  if (!isNumber(sigma) || sigma <= 0) return `${short(number.value)}${unit}`;
  const digits = 1 - Math.floor(Math.log10(sigma));
  if (digits > 6 || digits < 0) return `${short(number.value)} \u00b1 ${short(sigma)}${unit}`;
  return `${fixed(number.value, digits)} \u00b1 ${fixed(sigma, digits)}${unit}`;
}

/// [{name, value, sigma, unit}] of an effect's numbers that were fitted or scanned.
function numbersOf(effect) {
  const parameters = object(effect.parameters) ?? {};
  return Object.entries(parameters)
      .filter(([, number]) => object(number) && isNumber(number.value))
      .map(([name, number]) => ({name: plainName(name), ...number}));
}

function plainName(name) { return textOf(name).replaceAll("_", " "); }

/// Those of an effect's numbers that say something: fitted ones, or all where none was.
function tellingNumbers(effect) {
  const all = numbersOf(effect);
  const fitted = all.filter((number) => isNumber(number.sigma));
  return fitted.length > 0 ? fitted : all.filter((number) => number.value !== 0);
}

function sizeText(effect) {
  return tellingNumbers(effect).map((number) => `${number.name} ${withSigma(number)}`).join(", ");
}

/// "3 % of this shows; the rest hides in the fitted numbers."
function keptText(fraction) {
  if (!isNumber(fraction)) return null;
  if (fraction > 0.98) return "all of this shows";
  return `${percent(fraction, fraction < 0.1 ? 1 : 0)} of this shows; the rest hides in the fitted numbers`;
}

/// A p-value: below what any noise model is good for, only that.
function pText(value) {
  if (!isNumber(value)) return MISSING;
  return value < 1e-12 ? "<\u00a01e\u221212" : short(value);
}

function lengthText(value, report) { return `${short(value)}\u00a0${lengthUnit(report)}`; }
