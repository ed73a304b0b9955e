// Documents of a plan, its path and its clearances.
import type {BaseStanding, Units, Vector3} from "./common_documents";

export interface PlannedTube {
  name: string;
  leg: string;
  row: number;
  column: number;
  hole: Vector3;
  joints: number[];
  steps: number;
  tilt: number;
  approach_deviation: number;
  probability_by_steps: number[] | null;
  scored?: Record<string, null | {error: number; dx: number; dy: number; steps: number}>;
}

export interface PlanDocument {
  tubes: PlannedTube[];
  unreachable: {row: number; column: number; leg?: string; reason: string}[];
  gap: number;
  travel_time_s: number;
  total_time_s: number;
  lower_bound_s: number;
  row_by_row_time_s: number;
  min_clearance: number;
  clearance_required: number;
  tightest: string;
  /** Motion of the tool between tubes; absent in projects of earlier programs. */
  travel?: {kind: string; on_line?: number; line_deviation?: number | null};
  counts?: Record<string, number[]>;
  /** Scored ways of compensation; like step_words, absent in projects of earlier programs. */
  modes?: {name: string; words: string; brief: string}[];
  /** Names of 0, 1, ... steps of the tool that enter. */
  step_words?: string[];
  /** Base of the plan; without its standing in projects of earlier programs. */
  base?: Partial<BaseStanding>;
  warnings?: string[];
  sentence?: string;
  units: Units;
}

/** Distances to the nearest object at some of a path's samples. */
export interface PathClearances {
  from: number;
  samples: number;
  clearance: (number | null)[];
}

export interface PathDocument {
  time: number[];
  segment: number[];
  kind: string[];
  joints: number[][];
  clearance: (number | null)[] | null;
  tube?: number[];
}
