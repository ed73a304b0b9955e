// A saved project: how its models came about, what it is of, and how to have it again.
import {errorUnit} from "../drawing/error_budget.js";
import {errorOf} from "../drawing/ladder.js";
import {isNumber, pValue, short, whole} from "../drawing/numbers.js";
import {el, notRecorded, table} from "./elements.js";
import {list, numbers, textOf} from "./values.js";

export function historySection(report) {
  const unit = errorUnit(report);
  const rows = list(report.history)
                   .map((entry) => [textOf(entry.name), textOf(entry.origin, ""), textOf(entry.state, ""),
                                    short(errorOf(entry.rms)), short(errorOf(entry.heldout_rms)),
                                    isNumber(entry.chi2_per_dof) ? short(entry.chi2_per_dof) : null,
                                    isNumber(entry.p_value) ? pValue(entry.p_value) : null, textOf(entry.file)]);
  if (rows.length === 0) return [notRecorded("The models")];
  return [
    el("p", {class: "lead"},
       "Every model of the project, the first as it was given; errors are refitted, on the readings in use."),
    el("div", {class: "card"},
       table(["model", "by", "", `error, ${unit}`, `held-out, ${unit}`, "chi-square per degree of freedom", "p", "file"], rows,
             {text: [0, 1, 2, 7]}))
  ];
}

export function parametersSection(report) {
  const rows = list(report.parameters).map((number) => {
    const band = numbers(number.interval, 2);
    return [
      textOf(number.name), short(number.value), isNumber(number.sigma) ? short(number.sigma) : null,
      band ? `${short(band[0])} to ${short(band[1])}` : null, short(number.start), textOf(number.unit, ""),
      textOf(number.identifiable, "")
    ];
  });
  return [el("div", {class: "card"},
             table(["number", "value", "sigma", "95 %", "start", "unit", "identifiable"], rows, {text: [0, 5, 6]}))];
}

export function inputsSection(report) {
  const rows = list(report.inputs).map(
      (input) => [textOf(input.what), textOf(input.name), whole(input.bytes), el("code", {}, textOf(input.sha256))]);
  const aside = Array.isArray(report.set_aside) ? report.set_aside.filter((id) => typeof id === "string") : [];
  return [
    el("div", {class: "card"}, table(["input", "file", "bytes", "SHA-256"], rows, {text: [0, 1, 3]})),
    aside.length === 0 ? null : el("p", {class: "note"}, `Set aside by hand: ${aside.join(", ")}.`)
  ];
}

export function commandsSection(report) {
  const lines = Array.isArray(report.commands) ? report.commands.filter((line) => typeof line === "string") : [];
  return [
    el("p", {class: "lead"},
       "The first command writes the files; each of the others reproduces figures of this report from them, to every digit shown."),
    el("pre", {class: "card"}, lines.join("\n"))
  ];
}
