// Where a cause shows: which variable its law lives on, and as which part of the error. Of the variables that the law
// may hang on, the one that what the cause does at these readings follows most.
import type {EffectAt, Vector3} from "../server/documents";
import {jointKey, type Part} from "./parts";
import type {Variable} from "../../../drawing/variables.js";

const BINS = 12;

/** The share of the values' variance that lies between levels of x, or between bins of as many readings each. */
export function followedShare(xs: readonly (number | undefined)[], values: readonly (number | null)[]): number {
  const rows: [number, number][] = [];
  xs.forEach((x, i) => {
    const value = values[i];
    if (x !== undefined && Number.isFinite(x) && value !== null && Number.isFinite(value)) rows.push([x, value]);
  });
  if (rows.length < 3) return 0;
  const mean = rows.reduce((sum, row) => sum + row[1], 0) / rows.length;
  const all = rows.reduce((sum, row) => sum + (row[1] - mean) ** 2, 0);
  if (!(all > 0)) return 0;
  const groups = groupsOf(rows);
  const within = groups.reduce((sum, group) => {
    const own = group.reduce((total, row) => total + row[1], 0) / group.length;
    return sum + group.reduce((total, row) => total + (row[1] - own) ** 2, 0);
  }, 0);
  const free = rows.length - groups.length;
  return free > 0 ? 1 - within / free / (all / (rows.length - 1)) : 0;
}

/** Levels where there are few, else bins of about as many readings each; a level is never cut. */
export function groupsOf<T extends readonly [number, ...unknown[]]>(rows: readonly T[], bins = BINS): T[][] {
  const sorted = [...rows].sort((a, b) => a[0] - b[0]);
  const levels = new Set(sorted.map((row) => row[0])).size;
  const most = levels <= bins ? 1 : Math.ceil(sorted.length / Math.min(bins, Math.max(2, sorted.length / 3)));
  const groups: T[][] = [];
  for (const row of sorted) {
    const last = groups.at(-1);
    const isSameLevel = last !== undefined && last.at(-1)![0] === row[0];
    if (last && (isSameLevel || (levels > bins && last.length < most))) last.push(row);
    else groups.push([row]);
  }
  return groups;
}

export interface View {
  variable: Variable;
  part: Part;
  /** The share of what the cause does there that follows the variable. */
  score?: number;
}

/** Of several causes, the view of the one that shows best: an earlier one unless another is clearly better. */
export function viewOfCauses(
  effects: readonly EffectAt[],
  ...where: [
    done: readonly (Vector3 | null)[],
    readings: Parameters<Variable["of"]>[0][],
    variables: readonly Variable[],
    parts: readonly Part[],
  ]
): View | null {
  return effects
    .map((effect) => viewOfCause(effect, ...where))
    .reduce<View | null>(
      (best, view) => (view && (!best || (view.score ?? 0) > (best.score ?? 0) + CLEARLY) ? view : best),
      null,
    );
}

/** The joint or axis that an effect turns: "theta3" of "theta3<-theta2", "forearm.z". */
export function turnedBy(effect: EffectAt): string {
  return effect.at.split("<-")[0];
}

/** Moments at the effect's own place: about its axis, "forearm.z", or any of its member's, "forearm". */
function ownMoments({at}: EffectAt, variables: readonly Variable[]): Variable[] {
  const key = `moment_${at.replace(/\W/g, "_")}`;
  return variables.filter((variable) => variable.key === key || new RegExp(`^${key}_[xyz]$`).test(variable.key));
}

/** A user's own law stands in the place of its place: "theta2 += c*sin(theta1)". */
function isLaw({at}: EffectAt): boolean {
  return at.includes("+=");
}

/** The variables that a cause's law may hang on, the named ones of a formula or a coupling first. */
function candidates(effect: EffectAt, variables: readonly Variable[]): Variable[] {
  const driver = effect.at.split("<-")[1];
  if (driver) return variables.filter((variable) => variable.key === driver);
  if (isLaw(effect)) {
    const words = new Set(effect.at.match(/[A-Za-z_]\w*/g) ?? []);
    return variables.filter((variable) => words.has(variable.key));
  }
  const kinds = effect.varies_with ?? [];
  const own = variables.find((variable) => variable.key === effect.at);
  if (own && kinds.includes(own.kind)) return [own];
  const moments = kinds[0] === "moment" ? ownMoments(effect, variables) : [];
  if (moments.length > 0) return moments;
  return kinds.flatMap((kind) => variables.filter((variable) => variable.kind === kind));
}

/** The mean square of the values that are there. */
function meanSquare(values: readonly (number | null)[]): number {
  const known = values.filter((value): value is number => value !== null);
  return known.length > 0 ? known.reduce((sum, value) => sum + value * value, 0) / known.length : 0;
}

/** A view must be better by so much to be taken instead of an earlier one. */
const CLEARLY = 0.02;

/**
 * Where a cause is seen best: `done` is what it does to the error at each reading. As the error of the joint or axis
 * that it turns, where it turns one; else as the part along an axis that has most of it and follows its variable.
 */
export function viewOfCause(
  effect: EffectAt,
  done: readonly (Vector3 | null)[],
  readings: Parameters<Variable["of"]>[0][],
  variables: readonly Variable[],
  parts: readonly Part[],
): View | null {
  const named = candidates(effect, variables);
  const tried = named.length > 0 ? named : variables.filter((variable) => variable.kind !== "order");
  const own = parts.find((part) => part.key === jointKey(turnedBy(effect)));
  const shown = own ? [own] : parts.filter((part) => part.isSigned && !part.key.startsWith("as "));
  const whole = meanSquare(done.map((error) => (error ? Math.hypot(...error) : null)));
  const columns = tried.map((variable) => readings.map((reading, i) => variable.of(reading, i)));
  let best: (View & {score: number}) | null = null;
  for (const part of shown) {
    const values = done.map((error, i) => (error ? part.of(error, i) : null));
    const share = own ? 1 : meanSquare(values) / (whole || 1);
    tried.forEach((variable, k) => {
      const score = share * followedShare(columns[k], values);
      if (!best || score > best.score + CLEARLY) best = {variable, part, score};
    });
  }
  return best;
}
