// A plan, its path and what it keeps clear.
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
  /** How the tool goes from tube to tube; not in what an earlier program left in a project. */
  travel?: {kind: string; on_line?: number; line_deviation?: number | null};
  counts?: Record<string, number[]>;
  /** The ways of compensation that are scored; as step_words, not in what an earlier program left in a project. */
  modes?: {name: string; words: string; brief: string}[];
  /** What 0, 1, ... steps of the tool that enter are called. */
  step_words?: string[];
  /** What the plan is of; without the standing in what an earlier program left in a project. */
  base?: Partial<BaseStanding>;
  warnings?: string[];
  sentence?: string;
  units: Units;
}

/** The distance to what is nearest at some of a path's samples. */
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
