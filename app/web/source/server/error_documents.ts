// The loop: readings, their errors, what is missing, the numbers of the model.
import type {ErrorBudget} from "../../../drawing/error_budget.js";
import type {Units, Vector3} from "./common_documents";
import type {EffectAt, EffectNumber} from "./state_documents";

/** What every document about errors says of them: their unit, what they divide into, and what is in none of them. */
export interface JudgedDocument {
  /** Not in what an earlier program left in a project, like the others. */
  error_unit?: string;
  error_budget?: ErrorBudget | null;
  set_aside?: string[];
  units: Units;
  model: number;
  revision: number;
}

/** The same with a verdict. */
export interface VerdictDocument extends JudgedDocument {
  verdict: string;
  /** Not in what an earlier program left in a project. */
  verdict_words?: string;
  /** The errors of the model as it stands, refitted, and with each explanation. */
  ladder?: {name: string; rms: number | null; heldout_rms: number | null}[];
  sentence: string;
  /** Sentence by sentence, the error first, without the advice of `splitting`; not in what an earlier program left in a
   *  project. */
  sentences?: string[];
  chi2_per_dof: number;
  p_value: number;
  rms: Record<string, number>;
}

/** Conditions that it states are beside these, under the names that the units have them by. */
export interface ErrorReading {
  id: string;
  kind: string;
  point: string;
  setup?: string;
  joints: number[];
  senses?: number[];
  load?: number;
  force?: Vector3; // on the tip beside the load, world axes
  sigma?: number;
  held_out?: boolean;
}

export interface ComparedReading extends ErrorReading {
  error_before: Vector3;
  error_after: Vector3;
  /** Lengths of those errors, an angle where the reading measures nothing else, in their unit. */
  size_before: number | null;
  size_after: number | null;
  size_unit: string;
  sigmas_before?: number;
  sigmas_after?: number;
  measured?: Vector3;
  position_after?: Vector3;
}

/** A test of whether the error follows a variable, in one frame. */
export interface PatternTest {
  kind: string;
  variable: string;
  frame: string;
  component?: string;
  p_value: number | null;
  chi2_fall: number | null;
}

export interface PatternFound extends PatternTest {
  sentence: string;
  share_of_misfit: number;
  size: number;
}

export interface CompareDocument extends VerdictDocument {
  joint_columns: string[];
  patterns: PatternFound[];
  tested: PatternTest[];
  readings: ComparedReading[];
  worst: {id: string; size: number; sigmas: number}[];
}

export interface Explanation {
  effects: EffectAt[];
  enough?: boolean;
  chi2: number;
  p_value: number;
  rms: number;
  heldout_rms: number | null;
  probability?: number;
}

export interface RankedEffect extends EffectAt {
  chi2_fall: number;
  kept_fraction: number;
  probability: number;
  p_value: number;
  size: (EffectNumber & {name: string}) | null;
  heldout_rms?: {before: number; after: number} | null;
}

export interface DiagnosedReading extends ErrorReading {
  before: Vector3;
  after: Vector3 | null;
  explained: (Vector3 | null)[];
  position: Vector3;
  /** As of a compared reading, before and with each explanation; not in what an earlier program left in a project. */
  size_before?: number | null;
  size_explained?: (number | null)[];
  size_unit?: string;
}

/** A reading that would discriminate between explanations, with the posture, load and sense of arrival to take it at. */
export interface NextReading {
  point?: string;
  kind?: string;
  load?: number;
  posture: Record<string, number>;
  senses?: Record<string, number>;
  splits?: string[];
  separation_sigmas?: number;
  /** Not in what an earlier program left in a project. */
  fill_in?: FillIn;
}

/** Columns of a run sheet that somebody has to fill in for a reading. */
export interface FillIn {
  columns: string[];
  /** So many of them make it a reading. */
  least: number;
  /** Conditions that the readings so far state. */
  optional: string[];
}

export interface DiagnoseDocument extends VerdictDocument {
  probability: {nothing_missing: number; unknown_alone: number; scatter_alone?: number | null};
  not_tried: string[];
  explanations: Explanation[];
  closest: Explanation[];
  ranking: RankedEffect[];
  readings: DiagnosedReading[];
  next_readings: NextReading[];
  /** They, row by row, as a measurement table in which what is measured is to be filled in. */
  run_sheet?: string;
  splitting?: {
    advice?: string;
    other_means?: {what: string}[];
    columns_to_add?: string[];
    pairs?: {
      if_true: string;
      against: string;
      criterion_gap_now: number;
      criterion_gap_expected: number;
      probability_distinguished: number;
    }[];
  };
  warnings: (string | {sentence: string})[];
  /** What the ranking's probabilities are of. */
  probability_words?: string;
  /** The least of each effect that would have been seen. */
  detectable?: {
    effect: string;
    at: string;
    number: string;
    size: number | null;
    unit: string;
    beyond_plausible: boolean;
  }[];
  /** What is left that no known effect explains. */
  remainder?: {size: number | null; follows: {variable: string; share: number}[]};
  alternatives: EffectAt[][];
  joints: {name: string; unit: string}[];
}

export interface IdentifyDocument extends JudgedDocument {
  chi2_per_dof: number;
  p_value: number;
  rms: Record<string, number>;
  parameters: {
    name: string;
    value: number;
    sigma: number | null;
    start: number;
    unit: string;
    identifiable: string;
    interval: [number, number] | null;
  }[];
}

export interface LadderDocument extends JudgedDocument {
  models: {
    name: string;
    chi2_per_dof: number;
    fitted_numbers: number;
    rms: {as_it_stands: number; fitted: number; heldout: number | null; noise_floor: number};
    worst: {as_it_stands: number; fitted: number; heldout: number | null};
    steps?: {holes: number; counts: number[]} | null;
  }[];
}

export interface CatalogueDocument {
  effects: {
    effect: string;
    at: string;
    words: string;
    varies_with: string[];
    law: string;
    validity: string;
    source: string;
    parameters: {name: string; unit: string; neutral: number; low: number; high: number; plausible?: number | null}[];
  }[];
}

/** What an effect of half the usual size does to the tip of this arm; no values where it does not move it. */
export interface SignatureDocument {
  effect: string;
  at: string;
  variable: string;
  unit: string;
  values: number[];
  shift: (number | null)[];
  shift_unit: string;
}

/** Which causes the readings can hardly distinguish. */
export interface ConfoundingDocument {
  readings: number;
  causes: {effect: string; at: string; kept: number; confounded: {effect: string; at: string; share: number}[]}[];
}

/** How far joints and axes take the tip at each reading, three numbers for each name; where base and tool stand. */
export interface LeverageDocument {
  units: string[];
  names: string[];
  base: Vector3;
  up: Vector3;
  tool: Record<string, number[]>;
  readings: Record<string, number[]>;
}

/** Moments about the rows of the undeflected arm, by the id of the reading. */
export interface MomentsDocument {
  unit: string;
  names: string[];
  readings: Record<string, number[]>;
}

/** A reading as it was read, with the tip that the model predicts there. */
export interface MeasurementRow extends ErrorReading {
  position: Vector3 | null;
  tip: Vector3 | null;
  set_aside: boolean;
}

export interface MeasurementsDocument {
  name: string;
  joints: {name: string; unit: string}[];
  rows: MeasurementRow[];
}
