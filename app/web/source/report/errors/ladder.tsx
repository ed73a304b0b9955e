// The errors of the models, with the noise floor, as bars and as a table; and the numbers of tool steps that would
// enter with each model.
import {errorUnit} from "../../../../drawing/error_budget.js";
import {comparedModels, errorOf, LADDER_WORDS} from "../../../../drawing/ladder.js";
import {isNumber, percent, plural, pValue, short, whole} from "../../../../drawing/numbers.js";
import {LadderRows} from "../../error/ladder_rows";
import {Card, Lead, Missing, type OfReport, TableCard} from "../parts";
import {StepBars} from "../step_bars";
import {lengthText, list, numbers, object, type Report, textOf} from "../values";

export function noiseFloorOf(report: Report): number | null {
  return errorOf(report.noise_floor ?? object(report.rms)?.noise_floor);
}

/** Returns the models of a diagnosis, a comparison or a ladder. */
function modelsOf(report: Report, first: "models" | "ladder"): Report[] {
  const [own, other] = [list(report[first]), list(report[first === "models" ? "ladder" : "models"])];
  return own.length > 0 ? own : other;
}

export function LadderSection({report}: OfReport) {
  const models = comparedModels(modelsOf(report, "ladder")).map((model) => ({...model, worst: null, centred: null}));
  if (models.length === 0) return <Missing what="The errors of the models" />;
  const floor = noiseFloorOf(report);
  return (
    <>
      <Lead>
        Root mean square, over the readings in use, of the length of measured less predicted. An overfitted model does
        well on the readings that it was fitted to and badly on those held out.
      </Lead>
      <Card class="ladder">
        <LadderRows ladder={{models, floor, unit: errorUnit(report)}} />
        <p class="ladder-legend">
          <i class="swatch fitted" /> {LADDER_WORDS.fitted}
          <i class="swatch heldout" /> {LADDER_WORDS.heldout}
          {floor === null ? null : (
            <>
              <i class="floor-sign" /> {LADDER_WORDS.floor}
            </>
          )}
        </p>
      </Card>
    </>
  );
}

export function ModelsSection({report}: OfReport) {
  const unit = errorUnit(report),
    models = modelsOf(report, "models");
  const rows = models.map((model) => [...modelCells(model), numberOf(model.numbers, whole)]);
  return <TableCard what="The models" heads={[...modelHeads(unit), "fitted numbers"]} rows={rows} />;
}

const numberOf = (value: unknown, write: (value: unknown) => string) => (isNumber(value) ? write(value) : null);

/** Returns the column headings for `modelCells`. */
export function modelHeads(unit: string): string[] {
  return ["model", `error, ${unit}`, `held-out, ${unit}`, "chi-square per degree of freedom", "p"];
}

/** Returns the name and the errors of a model as table cells. */
export function modelCells(model: Report): (string | null)[] {
  return [
    textOf(model.name, textOf(model.model, textOf(model.cell))),
    short(errorOf(model.rms)),
    short(errorOf(model.heldout_rms ?? model.heldout)),
    numberOf(model.chi2_per_dof, short),
    numberOf(model.p_value, pValue),
  ];
}

/** Returns the names and step counts of the models that were scored, all with the same tool. */
function stepRows(report: Report): {name: string; counts: number[]}[] {
  const models = list(report.models),
    count = models.find((model) => Array.isArray(model.steps))?.steps.length;
  return models.flatMap((model) => {
    const counts = numbers(model.steps, count);
    return counts ? [{name: textOf(model.name), counts}] : [];
  });
}

export function hasStepCounts(report: Report): boolean {
  return stepRows(report).length > 0;
}

export function shareCells(counts: readonly number[]): string[] {
  const total = counts.reduce((sum, count) => sum + count, 0);
  return counts.map((count) => `${whole(count)} (${percent(total > 0 ? count / total : null)})`);
}

export function LadderStepsSection({report}: OfReport) {
  const rows = stepRows(report),
    about = object(report.step_table) ?? {},
    sigma = about.unmodelled_sigma;
  return (
    <>
      <Lead>
        Each model computes the postures under the same random holes; the true arm then positions the tip. True arm:{" "}
        {textOf(about.real_arm, "a model")}.
        {isNumber(sigma) && sigma > 0
          ? ` Standard deviation of a coordinate that no model explains: ${lengthText(sigma, report)}.`
          : ""}
      </Lead>
      <Card>
        <StepBars label="Holes by number of inserted steps, for each model" rows={rows} />
      </Card>
      <TableCard
        what="The models"
        heads={["model", ...rows[0].counts.map((_, i) => plural(i, "step"))]}
        rows={rows.map(({name, counts}) => [name, ...shareCells(counts)])}
      />
    </>
  );
}
