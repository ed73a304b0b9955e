// The state that all browsers share.
import type {BaseStanding, Problem, Units, Vector3} from "./common_documents";

export interface JointInfo {
  name: string;
  unit: string;
  row: number;
  lower: number | null;
  upper: number | null;
  home: number;
}

export interface CellInfo {
  name: string;
  file: string;
  units: Units;
  base_known: boolean;
  has_sheet: boolean;
  has_truth: boolean;
  has_park: boolean;
  has_arm_file: boolean;
  joints: JointInfo[];
  identify: string[];
  loads: number[];
}

export interface EffectAt {
  effect: string;
  at: string;
  /** What it is, for a reader who does not know its name. */
  words?: string;
  /** What its law may hang on, by kinds of variables, the plainest first; empty: on anything. */
  varies_with?: string[];
  /** As the order to add it takes it, with the sizes that were found. */
  add?: string;
  /** The law of a formula of the user. */
  formula?: string;
  /** Other names of it, that no reading could distinguish from it. */
  also?: {effect: string; at: string}[];
  /** The same in words; not in what an earlier program left in a project. */
  also_words?: string;
  parameters?: Record<string, EffectNumber | number | string>;
}

export interface EffectNumber {
  value: number;
  sigma: number | null;
  unit: string;
}

export interface Model {
  id: number;
  label: string;
  origin: string;
  base?: BaseStanding;
  effects: EffectAt[];
  free: string[];
}

export interface ReadingsInfo {
  name: string;
  readings: number;
  kinds: Record<string, number>;
  sigma: number | null;
  /** How many are set aside, and how often that was changed. */
  set_aside: number;
  held_out: number;
  change: number;
  /** How many joined the others last: they can be taken out again. */
  joined: number;
  /** What they are taken with, otherwise than their file says. */
  assumed: string[];
  checks: ReadingCheck[];
  missing_columns: MissingColumn[];
}

/** What looked wrong with the readings when they were opened. */
export interface ReadingCheck {
  name: string;
  severity: "mistake" | "remark";
  sentence: string;
  error_as_is: number | null;
  error_if_mended: number | null;
  assume: string | null;
  equally: string[];
}

export interface MissingColumn {
  column: string;
  sentence: string;
}

export interface Job {
  id: number | string;
  kind: string;
  label: string;
  status: "running" | "done" | "failed" | "cancelled";
  stage: string;
  done: number;
  total: number;
  left_s: number | null;
  error: Problem | null;
  result: string | null;
  moment: number;
}

export interface ResultMark {
  model: number;
  revision: number;
  /** All that have one. */
  models: number[];
}

/** Where the encoders of a running arm say it is, or what is wrong with what came. */
export interface LiveNews {
  source: string;
  joints?: number[];
  load?: number;
  tip?: Vector3;
  problem?: Problem;
}

export interface WorkbenchState {
  revision: number;
  /** Of two states, and of two words of a job, the greater is the newer, whichever came first. */
  moment: number;
  version: string;
  folder: string;
  cell: CellInfo;
  models: Model[];
  model: number;
  can_undo: boolean;
  can_redo: boolean;
  measurements: ReadingsInfo | null;
  results: Record<string, ResultMark | null>;
  jobs: Job[];
  touches?: number;
  project: {
    /** What it was last saved as, in the folder. */
    file: string | null;
    unsaved: boolean;
    /** Whether every change is kept in the state folder, and why not. */
    kept: boolean;
    problem: string;
  };
}
