// Colourings of the sheet's holes. A colouring assigns each hole to one of a few kinds, each with a colour and a shape.
import type {ColourName} from "../drawing/colours";
import type {Mark, Shape} from "../drawing/marks";
import {NOT_PLANNED, stateMark, UNREACHABLE, UNSCORED} from "../../../drawing/kinds.js";
import {isNumber, short} from "../../../drawing/numbers.js";
import {stepKinds, stepText} from "../../../drawing/steps.js";
import {visitText} from "../../../drawing/visits.js";
import type {FieldDocument, PlanDocument, PlannedTube, ReachDocument} from "../server/documents";
import type {SheetModel} from "./sheet_model";

export interface Kind {
  name: string;
  mark: Mark;
}

export interface Colouring {
  title: string;
  /** Meaning of the values, in a sentence. */
  meaning: string;
  kinds: Kind[];
  /** Index of the kind of each hole. */
  of: Uint8Array;
  counts: number[];
  /** Returns further lines of text about a hole. */
  words: (hole: number) => string[];
}

function finished(
  title: string,
  kinds: Kind[],
  of: Uint8Array,
  words: (hole: number) => string[] = () => [],
  meaning = "",
): Colouring {
  const counts = kinds.map(() => 0);
  for (const kind of of) counts[kind] += 1;
  return {title, meaning, kinds, of, counts, words};
}

export function byState(sheet: SheetModel): Colouring {
  const kinds = sheet.states.map((name, k) => ({name: sheet.stateWords[k], mark: stateMark(name)}));
  return finished("State", kinds, sheet.state);
}

export function byReach(sheet: SheetModel, reach: ReachDocument): Colouring {
  const kinds: Kind[] = [
    {name: "in reach", mark: {shape: "disc", colour: "case3"}},
    {name: "out of reach", mark: UNREACHABLE},
  ];
  const of = new Uint8Array(sheet.count);
  for (let i = 0; i < sheet.count; ++i) of[i] = reach.reachable[i] ? 0 : 1;
  return finished("Reach", kinds, of, (hole) =>
    reach.reachable[hole]
      ? [`in reach by ${reach.branches[hole]} posture${reach.branches[hole] === 1 ? "" : "s"}`]
      : [`out of reach: ${reach.reason[hole]}`],
  );
}

/** Returns the likeliest number of steps that enter a tube; null if the plan's base allows no prediction. */
export function predictedSteps({steps, probability_by_steps: chances}: PlannedTube): number | null {
  return chances === null ? null : steps;
}

/**
 * Returns the colouring by the number of steps that enter the planned tubes, as predicted, or as scored with the true
 * arm in a compensation mode.
 */
export function bySteps(sheet: SheetModel, plan: PlanDocument, mode: string): Colouring {
  const inserted = stepKinds(plan);
  const kinds = [...inserted, {name: "out of reach", mark: UNREACHABLE}, {name: "not on the list", mark: NOT_PLANNED}];
  if (mode === "predicted" && plan.tubes.some((tube) => predictedSteps(tube) === null))
    kinds.push({name: "steps not known", mark: UNSCORED});
  const of = new Uint8Array(sheet.count).fill(inserted.length + 1);
  for (const tube of plan.unreachable) mark(of, sheet.find(tube.row, tube.column), inserted.length);
  const tubes = new Map<number, number>();
  plan.tubes.forEach((tube, index) => {
    const hole = sheet.find(tube.row, tube.column);
    const steps = mode === "predicted" ? predictedSteps(tube) : tube.scored?.[mode]?.steps;
    tubes.set(hole, index);
    if (isNumber(steps)) mark(of, hole, Math.max(0, Math.min(inserted.length - 1, steps)));
    else if (steps === null) mark(of, hole, kinds.length - 1);
  });
  return finished("Steps of the tool", kinds, of, (hole) => tubeWords(plan, tubes.get(hole)));
}

function mark(of: Uint8Array, hole: number, kind: number): void {
  if (hole >= 0) of[hole] = kind;
}

function tubeWords(plan: PlanDocument, index: number | undefined): string[] {
  if (index === undefined) return [];
  const tube = plan.tubes[index];
  const steps = predictedSteps(tube);
  const words = steps === null ? "steps not known" : `predicted: ${stepText(plan.step_words, steps)}`;
  return [visitText(index, plan.tubes.length), words];
}

const BANDS: {shape: Shape; colour: ColourName}[] = [
  {shape: "dot", colour: "band0"},
  {shape: "ring", colour: "band1"},
  {shape: "half", colour: "band2"},
  {shape: "diamond", colour: "band3"},
  {shape: "square", colour: "band4"},
  {shape: "triangle", colour: "band5"},
];
const UNKNOWN: Mark = {shape: "cross", colour: "faint"};

/** Returns the colouring by a field: bands at quantiles of its values rounded to two digits, from small to large. */
export function byField(
  sheet: SheetModel,
  field: FieldDocument,
  title: string,
  onOneScale: readonly FieldDocument[] = [field],
): Colouring {
  const known = onOneScale.flatMap(({values}) => values.filter(isNumber)).sort((a, b) => a - b);
  const edges = bandEdges(known);
  const kinds = BANDS.slice(0, edges.length + 1).map((band, i) => ({
    name: bandName(edges, i, field.unit),
    mark: band as Mark,
  }));
  const of = new Uint8Array(sheet.count);
  for (let i = 0; i < sheet.count; ++i) {
    const value = field.values[i];
    of[i] = isNumber(value) ? edges.filter((edge) => value >= edge).length : kinds.length;
  }
  const none = field.of === "residual" ? "not touched" : "unreachable";
  return finished(
    title,
    [...kinds, {name: none, mark: field.of === "residual" ? {shape: "dot", colour: "faint"} : UNKNOWN}],
    of,
    (hole) =>
      isNumber(field.values[hole]) ? [`${title.toLowerCase()} ${short(field.values[hole])} ${field.unit}`] : [none],
    field.meaning,
  );
}

export function bandEdges(sorted: readonly number[]): number[] {
  if (sorted.length === 0 || sorted[0] === sorted[sorted.length - 1]) return [];
  const edges = [0.1, 0.3, 0.6, 0.85, 0.97]
    .map((share) => sorted[Math.floor(share * (sorted.length - 1))])
    .map((value) => Number(value.toPrecision(2)));
  return [...new Set(edges)].filter((edge) => edge > sorted[0]);
}

function bandName(edges: readonly number[], band: number, unit: string): string {
  if (edges.length === 0) return `one value, ${unit}`;
  if (band === 0) return `below ${short(edges[0])} ${unit}`;
  if (band === edges.length) return `${short(edges[band - 1])} ${unit} and more`;
  return `${short(edges[band - 1])} to ${short(edges[band])} ${unit}`;
}
