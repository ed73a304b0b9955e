// Documents of the calibration loop: readings, their errors, missing effects, the numbers of the model.
import type {ErrorBudget} from "../../../drawing/error_budget.js";
import type {Units, Vector3} from "./common_documents";
import type {EffectAt, EffectNumber} from "./state_documents";

/** Common part of all documents about errors: their unit, their budget, and the readings excluded from them. */
export interface JudgedDocument {
  /** Absent in projects of earlier programs, like the following ones. */
  error_unit?: string;
  error_budget?: ErrorBudget | null;
  set_aside?: string[];
  units: Units;
  model: number;
  revision: number;
}

/** Document about errors with a verdict. */
export interface VerdictDocument extends JudgedDocument {
  verdict: string;
  /** Absent in projects of earlier programs. */
  verdict_words?: string;
  /** Errors of the given model, of the refitted one, and with each explanation. */
  ladder?: {name: string; rms: number | null; heldout_rms: number | null}[];
  sentence: string;
  /** Sentences, the error first, without the advice of `splitting`; absent in projects of earlier programs. */
  sentences?: string[];
  chi2_per_dof: number;
  p_value: number;
  rms: Record<string, number>;
}

/** Reading with its errors. Its conditions are further keys, with the names stated in the units. */
export interface ErrorReading {
  id: string;
  kind: string;
  point: string;
  setup?: string;
  joints: number[];
  senses?: number[];
  load?: number;
  force?: Vector3; // on the tip in addition to the load, world axes
  sigma?: number;
  held_out?: boolean;
}

export interface ComparedReading extends ErrorReading {
  error_before: Vector3;
  error_after: Vector3;
  /** Sizes of those errors in their unit; an angle if the reading measures nothing else. */
  size_before: number | null;
  size_after: number | null;
  size_unit: string;
  sigmas_before?: number;
  sigmas_after?: number;
  measured?: Vector3;
  position_after?: Vector3;
}

/** Test of the error's dependence on a variable, in one frame. */
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
  /** Sizes as for a compared reading, before and with each explanation; absent in projects of earlier programs. */
  size_before?: number | null;
  size_explained?: (number | null)[];
  size_unit?: string;
}

/** Reading that would discriminate between explanations, with its posture, load and sense of arrival. */
export interface NextReading {
  point?: string;
  kind?: string;
  load?: number;
  posture: Record<string, number>;
  senses?: Record<string, number>;
  splits?: string[];
  separation_sigmas?: number;
  /** Absent in projects of earlier programs. */
  fill_in?: FillIn;
}

/** Columns of a run sheet to be filled in for a reading. */
export interface FillIn {
  columns: string[];
  /** Least number of filled columns that makes it a reading. */
  least: number;
  /** Conditions that the present readings state. */
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
  /** Proposed readings, row by row, as a measurement table with empty fields for the measured values. */
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
  /** Meaning of the ranking's probabilities. */
  probability_words?: string;
  /** Least detectable size of each effect. */
  detectable?: {
    effect: string;
    at: string;
    number: string;
    size: number | null;
    unit: string;
    beyond_plausible: boolean;
  }[];
  /** Remaining error that no known effect explains. */
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

/**
 * Displacement of this arm's tip by an effect of half the usual size; without values if the effect does not move the
 * tip.
 */
export interface SignatureDocument {
  effect: string;
  at: string;
  variable: string;
  unit: string;
  values: number[];
  shift: (number | null)[];
  shift_unit: string;
}

/** Causes that the readings can hardly distinguish. */
export interface ConfoundingDocument {
  readings: number;
  causes: {effect: string; at: string; kept: number; confounded: {effect: string; at: string; share: number}[]}[];
}

/** Leverage of joints and axes on the tip at each reading, three numbers for each name; the places of base and tool. */
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

/** Reading as in its file, with the tip that the model predicts there. */
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
