// The findings of a comparison, the steps of an improvement, and the history of a project's models with the commands
// that reproduce them.
import {errorUnit} from "../../../../drawing/error_budget.js";
import {verdictMark} from "../../../../drawing/kinds.js";
import {fixed, isNumber, pValue, short, whole} from "../../../../drawing/numbers.js";
import {barred} from "../../../../drawing/ranking.js";
import {MarkIcon} from "../../drawing/marks";
import {ParameterTable} from "../../error/parameter_table";
import {Chance} from "../../error/ranking_table";
import {Card, Lead, Missing, type OfReport, Table, TableCard} from "../parts";
import {lengthUnit, list, object, type Report, textList, textOf} from "../values";
import {modelCells, modelHeads} from "./ladder";
import {LawSection} from "./law";
import {conditionsText, sizeOf} from "./pairs";

/** Shows patterns, given as strings or as {name | of | with, sentence | text, p_value, share | correlation}. */
export function PatternsSection({report}: OfReport) {
  if (!Array.isArray(report.patterns)) return <Missing what="What the errors depend on" />;
  if (report.patterns.length === 0) return <p>The errors depend on nothing recorded in the readings.</p>;
  const rows = report.patterns.map((pattern: unknown) => {
    const entry = object(pattern);
    if (!entry) return [textOf(pattern), null, null];
    const {sentence, text, name, of, with: other} = entry;
    const strength = [entry.share_of_misfit, entry.share, entry.explains, entry.correlation].find(isNumber);
    return [
      textOf(sentence, textOf(text, textOf(name, textOf(of, textOf(other))))),
      isNumber(strength) ? <Chance {...barred(Math.abs(strength), 1, fixed(strength, 2))} /> : null,
      isNumber(entry.p_value) ? pValue(entry.p_value) : null,
    ];
  });
  const heads = ["the errors depend on", "share explained", "p-value"];
  return <TableCard what="What the errors depend on" heads={heads} rows={rows} />;
}

/** Shows the worst readings, given as ids or as {id, error | size, sigmas}. */
export function WorstSection({report}: OfReport) {
  const byId = new Map(list(report.readings).map((reading) => [String(reading.id), reading]));
  const rows = (Array.isArray(report.worst) ? report.worst : []).map((worst: unknown) => {
    const entry = object(worst) ?? {id: worst},
      reading = byId.get(textOf(entry.id));
    const size = [entry.error, entry.size, entry.rms, sizeOf(reading?.after ?? reading?.before)].find(isNumber);
    return [
      textOf(entry.id),
      textOf(entry.point ?? reading?.point),
      reading ? conditionsText(report, reading) : null,
      `${short(size)} ${textOf(entry.unit, lengthUnit(report))}`,
      isNumber(entry.sigmas) ? fixed(entry.sigmas, 1) : null,
    ];
  });
  const heads = ["reading", "point", "at", "error", "in sigmas"];
  return <TableCard what="The worst readings" heads={heads} rows={rows} text={[0, 1, 2]} />;
}

/** Shows for each step the verdict, the added cause with its reason, and the errors with the law of the cause. */
export function ImprovementSection({report}: OfReport) {
  const steps = list(report.steps);
  if (steps.length === 0) return <Missing what="The steps" />;
  return (
    <>
      {steps.map((step, index) => (
        <ImprovementStep report={report} step={step} index={index} />
      ))}
    </>
  );
}

function ImprovementStep({report, step, index}: {step: Report; index: number} & OfReport) {
  const added = textList(step.added),
    equivalents = textList(step.also),
    reason = textOf(step.reason, ""),
    figures = object(step.figures);
  return (
    <div class="improvement-step">
      <h3>
        <MarkIcon mark={verdictMark(step.verdict)} size={16} /> Step {index + 1}:{" "}
        {textOf(figures?.verdict_words, textOf(step.verdict))}
      </h3>
      <p>{textOf(step.sentence, "")}</p>
      <p>
        <b>{added.length > 0 ? `Added: ${added.join(", ")}` : "Nothing was added"}</b>
        {reason === "" ? "." : `: ${reason}.`}
      </p>
      {equivalents.length > 0 ? <p class="note">The same all over the arm's range: {equivalents.join(", ")}.</p> : null}
      {figures && list(figures.readings).length > 0 ? (
        <LawSection report={{...figures, units: report.units, page: "diagnosis"}} />
      ) : null}
    </div>
  );
}

// ---- a saved project

export function HistorySection({report}: OfReport) {
  const unit = errorUnit(report);
  const rows = list(report.history).map((entry) => {
    const [name, ...errors] = modelCells(entry);
    return [name, textOf(entry.origin, ""), textOf(entry.state, ""), ...errors, textOf(entry.file)];
  });
  const [model, ...errors] = modelHeads(unit),
    heads = [model, "by", "", ...errors, "file"];
  return (
    <>
      <Lead>Every model of the project, the first as it was given; errors are refitted, on the readings in use.</Lead>
      <TableCard what="The models" heads={heads} rows={rows} text={[0, 1, 2, 7]} />
    </>
  );
}

export function ParametersSection({report}: OfReport) {
  return (
    <Card>
      <ParameterTable parameters={list(report.parameters) as any} hasIntervals />
    </Card>
  );
}

export function InputsSection({report}: OfReport) {
  const aside = textList(report.set_aside);
  const rows = list(report.inputs).map((input) => [
    textOf(input.what),
    textOf(input.name),
    whole(input.bytes),
    <code>{textOf(input.sha256)}</code>,
  ]);
  return (
    <Card>
      <Table heads={["input", "file", "bytes", "SHA-256"]} rows={rows} text={[0, 1, 3]} />
      {aside.length > 0 ? <p class="note">Set aside by hand: {aside.join(", ")}.</p> : null}
    </Card>
  );
}

export function CommandsSection({report}: OfReport) {
  return (
    <>
      <Lead>
        The first command writes the files; each of the others reproduces figures of this report from them, to every
        digit shown.
      </Lead>
      <pre class="card">{textList(report.commands).join("\n")}</pre>
    </>
  );
}
