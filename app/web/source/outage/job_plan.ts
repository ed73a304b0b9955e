// The plan of a job as a document, with the fill patterns of its parts in charts.
import type {Fill} from "../drawing/hatching";

export interface PackagePlan {
  package: string;
  folder: string;
  reason: string;
  visits: number;
  unreachable: {tube: string; reason: string}[];
  change_s: number;
  total_s: number;
}

export interface LegPlan {
  steam_generator: string;
  leg: string;
  mount_s: number;
  total_s: number;
  arm: number;
  start_s: number;
  end_s: number;
  wait: {for: string; reason: string; words: string; idle_s: number} | null;
  packages: PackagePlan[];
}

export interface JobPlan {
  job: string;
  legs: LegPlan[];
  arms: number;
  end_s: number;
  lower_bound_s: number;
  schedule: string;
  visits: number;
  unreachable: number;
  times: {key: string; words: string; time_s: number; share: number}[];
}

export const legName = ({steam_generator, leg}: LegPlan) => `${steam_generator}/${leg}`;

export const hours = (seconds: number) => seconds / 3600;

/** Fills of the parts of the time, by their keys. */
const TIME_FILLS: Record<string, Fill> = {
  mount_s: {pattern: "crossed", colour: "muted"},
  change_s: {pattern: "plain", colour: "ink"},
  travel_s: {pattern: "plain", colour: "case2"},
  approaches_s: {pattern: "lines", colour: "accent"},
  in_tubes_s: {pattern: "dots", colour: "case3"},
  dwell_s: {pattern: "back", colour: "case1"},
};
const OTHER: Fill = {pattern: "diagonal", colour: "rose"};

export function timeFill(key: string): Fill {
  return Object.hasOwn(TIME_FILLS, key) ? TIME_FILLS[key] : OTHER;
}

/** Fills of packages, in the order of their first occurrence; with more packages they repeat. */
const PACKAGE_FILLS: readonly Fill[] = [
  {pattern: "diagonal", colour: "accent"},
  {pattern: "back", colour: "violet"},
  {pattern: "lines", colour: "case0"},
  {pattern: "dots", colour: "rose"},
  {pattern: "crossed", colour: "case1"},
  {pattern: "plain", colour: "case2"},
];

/** Returns the names of the packages with their fills. */
export function packageFills(plan: JobPlan): Map<string, Fill> {
  const names = [...new Set(plan.legs.flatMap(({packages}) => packages.map((of) => of.package)))];
  return new Map(names.map((name, k) => [name, PACKAGE_FILLS[k % PACKAGE_FILLS.length]]));
}
