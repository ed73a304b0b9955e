// Residuals summed up along a variable: means of bins with their standard errors, and the law of a cause as what it does
// on average there, with its spread.
import {groupsOf} from "./own_variable";

export interface Bin {
  x: number;
  from: number;
  to: number;
  mean: number;
  /** Of the mean. */
  error: number;
  /** Of the values about it. */
  spread: number;
  count: number;
}

const MEANS = 10;
const LAW_STEPS = 40;

function binOf(group: [number, number][]): Bin {
  const count = group.length;
  const mean = group.reduce((sum, [, value]) => sum + value, 0) / count;
  const square = group.reduce((sum, [, value]) => sum + (value - mean) ** 2, 0);
  const spread = count > 1 ? Math.sqrt(square / (count - 1)) : 0;
  return {
    x: group.reduce((sum, [x]) => sum + x, 0) / count,
    from: group[0][0],
    to: group.at(-1)![0],
    mean,
    error: spread / Math.sqrt(count),
    spread,
    count,
  };
}

function rowsOf(xs: readonly (number | undefined)[], values: readonly (number | null)[]): [number, number][] {
  return xs.flatMap((x, i): [number, number][] => {
    const value = values[i];
    return x !== undefined && Number.isFinite(x) && value !== null && Number.isFinite(value) ? [[x, value]] : [];
  });
}

/** Bins of one reading say nothing of their scatter: they are left out. */
export function binnedMeans(xs: readonly (number | undefined)[], values: readonly (number | null)[]): Bin[] {
  return groupsOf(rowsOf(xs, values), MEANS)
    .map(binOf)
    .filter((bin) => bin.count > 1);
}

export function lawAlong(xs: readonly (number | undefined)[], done: readonly (number | null)[]): Bin[] {
  return groupsOf(rowsOf(xs, done), LAW_STEPS).map(binOf);
}
