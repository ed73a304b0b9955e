// Documents of the calibration loop: readings, their errors, missing effects, and model parameters.
import type {ErrorBudget} from "../../../drawing/error_budget.js";
import type {Units, Vector3} from "./common_documents";
import type {EffectAt, EffectNumber} from "./state_documents";

/** Common fields of all documents about errors: their unit, their budget, and the readings excluded from them. */
export interface JudgedDocument {
  /** Missing in projects of earlier versions, like error_budget and set_aside. */
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
  /** Verdict in words; missing in projects of earlier versions. */
  verdict_words?: string;
  /** Errors of the given model, of the refitted model, and of the model with each explanation. */
  ladder?: {name: string; rms: number | null; heldout_rms: number | null}[];
  sentence: string;
  /**
   * Sentences of the verdict, the error first, without the advice in `splitting`; missing in projects of earlier
   * versions.
   */
  sentences?: string[];
  chi2_per_dof: number;
  p_value: number;
  rms: Record<string, number>;
}

/** Reading with its errors. Further keys are conditions of the reading, under the names that the units state. */
export interface ErrorReading {
  id: string;
  kind: string;
  point: string;
  setup?: string;
  joints: number[];
  senses?: number[];
  load?: number;
  force?: Vector3; // force on the tip in addition to the load, along the world axes
  sigma?: number;
  held_out?: boolean;
}

export interface ComparedReading extends ErrorReading {
  error_before: Vector3;
  error_after: Vector3;
  /** Sizes of the two errors, in size_unit; angles if the reading measures only orientation. */
  size_before: number | null;
  size_after: number | null;
  size_unit: string;
  sigmas_before?: number;
  sigmas_after?: number;
  measured?: Vector3;
  position_after?: Vector3;
}

/** Test of how the error depends on a variable, in one frame. */
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
  /**
   * Sizes of the errors as in ComparedReading, before and with each explanation; missing in projects of earlier
   * versions.
   */
  size_before?: number | null;
  size_explained?: (number | null)[];
  size_unit?: string;
}

/** Proposed reading that would discriminate between explanations, with its posture, load and sense of arrival. */
export interface NextReading {
  point?: string;
  kind?: string;
  load?: number;
  posture: Record<string, number>;
  senses?: Record<string, number>;
  splits?: string[];
  separation_sigmas?: number;
  /** Columns to fill in; missing in projects of earlier versions. */
  fill_in?: FillIn;
}

/** Columns of the run sheet to fill in for a reading. */
export interface FillIn {
  columns: string[];
  /** Minimum number of columns that must be filled in for a valid reading. */
  least: number;
  /** Columns of conditions, such as those stated by the current readings, which may stay empty. */
  optional: string[];
}

/** Warning about an effect of the diagnosed model; the kind is missing in projects of earlier versions. */
export interface EffectWarning {
  sentence: string;
  kind?: string;
  effect?: string;
  at?: string;
  /** True if all fitted sizes of the effect are within two standard deviations of its neutral values. */
  at_neutral?: boolean;
}

export interface DiagnoseDocument extends VerdictDocument {
  probability: {nothing_missing: number; unknown_alone: number; scatter_alone?: number | null};
  not_tried: string[];
  explanations: Explanation[];
  closest: Explanation[];
  ranking: RankedEffect[];
  readings: DiagnosedReading[];
  next_readings: NextReading[];
  /** Proposed readings as a measurement table, one row each, with empty fields for the measured values. */
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
  warnings: (string | EffectWarning)[];
  /** Explanation of the probabilities in the ranking. */
  probability_words?: string;
  /** Smallest detectable size of each effect. */
  detectable?: {
    effect: string;
    at: string;
    number: string;
    size: number | null;
    unit: string;
    beyond_plausible: boolean;
  }[];
  /** Scatter of repeated readings as a multiple of the stated noise; missing without repeats. */
  repeats?: {groups: number; noise_ratio: number | null};
  /** Residual error that no known effect explains, and the variables that it follows. */
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
    start: number | null;
    unit: string;
    identifiable: string;
    interval: [number, number] | null;
    /** Words shown instead of the name, and their tooltip; set by the page. */
    title?: string;
    hint?: string;
  }[];
  /** Poses of the bases; like base_steps, missing in projects of earlier versions. */
  bases?: {setup: string; known: boolean; base: {position: Vector3; rpy: Vector3}}[];
  /** Fitted steps of the bases from their poses at the start, whose sigmas are those of the poses. */
  base_steps?: IdentifyDocument["parameters"];
  /** Warnings of the fit, in words or about one effect each. */
  warnings?: (string | EffectWarning)[];
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
 * Displacement of this arm's tip by an effect of half the usual size, as a function of a variable; without values if
 * the effect does not move the tip.
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

/** For each cause, the other causes that the readings can hardly distinguish from it. */
export interface ConfoundingDocument {
  readings: number;
  causes: {
    effect: string;
    at: string;
    kept: number;
    confounded: {effect: string; at: string; title?: string; share: number}[];
  }[];
}

/**
 * Leverage of joints and axes on the tip at each reading: three numbers for each name. Also the origin and the axis of
 * the base, and the axes of the tool.
 */
export interface LeverageDocument {
  units: string[];
  names: string[];
  base: Vector3;
  up: Vector3;
  tool: Record<string, number[]>;
  readings: Record<string, number[]>;
}

/** Moments about the axes of the rows of the undeflected arm, keyed by reading id. */
export interface MomentsDocument {
  unit: string;
  names: string[];
  readings: Record<string, number[]>;
}

/** Reading as in its file, with the tip position that the model predicts for it; null if unknown. */
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
