// ---- explanations.js: the explanations of a diagnosis as one list, and what they leave.

/// [{effects, rms, heldout_rms, p_value, enough}], best first, from `explanations`, else from the bare alternatives.
function explanationsOf(report) {
  const given = list(report.explanations).map((entry) => ({...entry, effects: list(entry.effects)}));
  if (given.length > 0) return given;
  const alternatives = Array.isArray(report.alternatives) ? report.alternatives.filter(Array.isArray) : [];
  return alternatives.map((effects) => ({effects: list(effects), enough: true}));
}

function explanationTitle(explanation) { return explanation.effects.map(effectTitle).join(" and "); }

/// Readings with a place in the world.
function placedReadings(report) { return list(report.readings).filter((reading) => numbers(reading.position, 3)); }

function sizeOf(error) { return numbers(error, 3) ? Math.hypot(...error) : null; }

function rootMeanSquare(values) {
  const known = values.filter(isNumber);
  return known.length === 0 ? null : Math.sqrt(known.reduce((sum, value) => sum + value * value, 0) / known.length);
}

/// "with hysteresis at theta4"; of what is not enough "with the closest, backlash at tool.z"; without any "refitted".
function afterName(report) {
  const [first] = explanationsOf(report);
  if (!first) return "refitted";
  return `${first.enough === false ? "with the closest, " : "with "}${explanationTitle(first)}`;
}

function beforeName(report) { return report.page === "diagnosis" ? "refitted, no effect" : "as the model stands"; }

function hasAfter(report) { return list(report.readings).some((reading) => numbers(reading.after, 3)); }

/// The two series of every picture of errors; the second only where there is one.
function seriesOf(report) {
  const before = {key: "before", name: beforeName(report), shape: "triangle", colour: "case0"};
  const after = {key: "after", name: afterName(report), shape: "disc", colour: "accent"};
  return hasAfter(report) ? [before, after] : [before];
}

function seriesLegend(report) {
  const icon = (entry) => markIcon(entry.key === "before" ? {...entry, shape: "open-triangle"} : entry);
  return el("ul", {class: "legend"}, seriesOf(report).map((entry) => el("li", {}, icon(entry), entry.name)));
}
