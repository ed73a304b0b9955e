// Documents of a plan, of its path and of the clearances along the path.
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
  /** Motion of the tool between tubes; missing in projects of earlier versions. */
  travel?: {kind: string; on_line?: number; line_deviation?: number | null};
  counts?: Record<string, number[]>;
  /** Scored compensation modes; like step_words, missing in projects of earlier versions. */
  modes?: {name: string; words: string; brief: string}[];
  /** Names of the cases in which 0, 1, ... steps of the tool enter. */
  step_words?: string[];
  /** Base for which the plan was made; its fields are missing in projects of earlier versions. */
  base?: Partial<BaseStanding>;
  warnings?: string[];
  sentence?: string;
  units: Units;
}

/** Distances to the nearest object at consecutive samples of a path, from index `from` on. */
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
