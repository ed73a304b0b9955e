// Documents of the state shared by all browsers.
import type {BaseStanding, Problem, Units, Vector3} from "./common_documents";
import type {UnitTable} from "./unit_table";

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
  /** Units of the cell's file, also where the figures are in others. */
  file_units?: {length: string; angle: string};
  base_known: boolean;
  has_sheet: boolean;
  has_truth: boolean;
  has_park: boolean;
  /** Park posture; null if the cell states none. */
  park: number[] | null;
  has_arm_file: boolean;
  joints: JointInfo[];
  identify: string[];
  loads: number[];
}

export interface EffectAt {
  effect: string;
  at: string;
  /** Title, where effect and place do not make one. */
  title?: string;
  /** Description for a reader who does not know the effect's name. */
  words?: string;
  /**
   * Kinds of variables on which the effect's law may depend, simplest first; if empty, it may depend on any variable.
   */
  varies_with?: string[];
  /** Text that requests the addition of the effect, with the sizes found. */
  add?: string;
  /** Formula of a user-defined effect. */
  formula?: string;
  /** Other effects that no reading could distinguish from this effect. */
  also?: {effect: string; at: string}[];
  /** The effects of `also` in words; missing in projects of earlier versions. */
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
  /** Number of readings set aside; `change` counts the changes of readings and marks. */
  set_aside: number;
  held_out: number;
  change: number;
  /** Number of readings that were added last and can be removed again. */
  joined: number;
  /** Assumptions under which the readings were read, in addition to the content of their file. */
  assumed: string[];
  checks: ReadingCheck[];
  missing_columns: MissingColumn[];
}

/** Mistake suspected when the readings were opened. */
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
  /** Ids of all models for which the result was computed. */
  models: number[];
}

/** Posture of a running arm from its encoders, or a problem with the received data. */
export interface LiveNews {
  source: string;
  joints?: number[];
  load?: number;
  tip?: Vector3;
  problem?: Problem;
}

export interface WorkbenchState {
  revision: number;
  /**
   * Number of this state; of two states or job messages, the one with the greater number is newer, regardless of the
   * order of arrival.
   */
  moment: number;
  version: string;
  folder: string;
  unit_table: UnitTable;
  cell: CellInfo;
  models: Model[];
  model: number;
  can_undo: boolean;
  can_redo: boolean;
  /** Descriptions of the next undo and redo; empty if there is none. */
  undo_words: string;
  redo_words: string;
  measurements: ReadingsInfo | null;
  results: Record<string, ResultMark | null>;
  jobs: Job[];
  touches?: number;
  project: {
    /** Project file last saved in the folder; null if there is none. */
    file: string | null;
    unsaved: boolean;
    /** True if every change is stored in the state folder; otherwise `problem` states the reason. */
    kept: boolean;
    problem: string;
  };
}
