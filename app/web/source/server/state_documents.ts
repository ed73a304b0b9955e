// Documents of the state shared by all browsers.
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
  /** Description for a reader who does not know the name. */
  words?: string;
  /** Kinds of variables on which its law may depend, the plainest first; empty: on anything. */
  varies_with?: string[];
  /** Text for a request to add it, with the sizes found. */
  add?: string;
  /** Law of a user's formula. */
  formula?: string;
  /** Other effects that no reading could distinguish from it. */
  also?: {effect: string; at: string}[];
  /** Those effects in words; absent in projects of earlier programs. */
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
  /** Number of readings set aside; `change` counts the changes. */
  set_aside: number;
  held_out: number;
  change: number;
  /** Number of readings that joined last and can be removed again. */
  joined: number;
  /** Assumptions about the readings that differ from their file. */
  assumed: string[];
  checks: ReadingCheck[];
  missing_columns: MissingColumn[];
}

/** Suspected mistake found when the readings were opened. */
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
  /** Ids of all models that have the result. */
  models: number[];
}

/** Posture of a running arm by its encoders, or a problem with the received data. */
export interface LiveNews {
  source: string;
  joints?: number[];
  load?: number;
  tip?: Vector3;
  problem?: Problem;
}

export interface WorkbenchState {
  revision: number;
  /** Number of the state or of a job's message; the greater one is newer, whichever arrived first. */
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
    /** File in the folder of the last save. */
    file: string | null;
    unsaved: boolean;
    /** True if every change is kept in the state folder; otherwise `problem` is the reason. */
    kept: boolean;
    problem: string;
  };
}
