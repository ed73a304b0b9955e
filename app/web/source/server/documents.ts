// The documents of the program's server, as far as the page reads them. Figures are in the cell's own units.

export type Vector3 = [number, number, number];
export type Vector2 = [number, number];

export interface Units {
  length: string;
  angle: string;
  force: string;
  temperature?: string;
  time?: string;
}

/** What is wrong with an input, as the program says it. */
export interface Problem {
  where?: string;
  found?: string;
  expected?: string;
  advice?: string;
  message: string;
}

// ---- the state that all browsers share

export interface JointInfo {
  name: string;
  unit: string;
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
  has_scene: boolean;
  has_tool: boolean;
  has_truth: boolean;
  joints: JointInfo[];
  identify: string[];
  loads: number[];
}

export interface EffectAt {
  effect: string;
  at: string;
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
  effects: EffectAt[];
  free: string[];
}

export interface ReadingsInfo {
  name: string;
  readings: number;
  kinds: Record<string, number>;
  setups: number;
  sigma: number | null;
}

export interface Job {
  id: number | string;
  kind: string;
  label: string;
  status: "running" | "done" | "failed" | "cancelled";
  stage: string;
  done: number;
  total: number;
  rate: number | null;
  left_s: number | null;
  error: Problem | null;
  result: string | null;
}

export interface ResultMark {
  model: number;
  revision: number;
}

export interface WorkbenchState {
  revision: number;
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
}

// ---- geometry

export interface SheetDocument {
  name: string;
  units: Units | string;
  pitch: number;
  hole_diameter: number;
  rows: number;
  columns: number;
  viewing_side: string;
  leg: string;
  /** In the bowl, in the world; u and v its direction from the sheet's middle as drawn. Null: the cell does not say. */
  manway: {center: Vector3; diameter: number; u: number; v: number} | null;
  tool?: {diameters: number[]; tolerances: number[]} | null;
  holes: {
    row: number[];
    column: number[];
    leg?: (string | number)[];
    x: number[];
    y: number[];
    z: number[];
    u: number[];
    v: number[];
    state: number[];
    states: string[];
  };
}

/** A shape of the cell file: its kind and the fields of that kind, in the world or in its row's frame. */
export interface SolidShape {
  kind: string;
  name: string;
  from?: Vector3;
  to?: Vector3;
  radius?: number;
  center?: Vector3;
  size?: Vector3;
  rpy?: Vector3;
  point?: Vector3;
  normal?: Vector3;
}

export interface ArmRow {
  row: number;
  name: string;
  moves?: boolean;
  bodies: SolidShape[];
}

export interface SceneDocument {
  units?: Units;
  clearance?: number;
  shapes: SolidShape[];
  arm: ArmRow[];
  tip?: Vector3;
  tool_axis?: Vector3;
}

export interface Frame {
  row: number;
  position: Vector3;
  quaternion: [number, number, number, number];
}

export interface TipPose {
  position: Vector3;
  fixed_angles: Vector3;
}

export interface PoseDocument {
  joints?: number[];
  rigid: TipPose;
  flexible: TipPose;
  change: TipPose;
  frames: {rigid: Frame[]; flexible: Frame[]};
  tip: {rigid: Vector3; flexible: Vector3};
  clearance: null | {distance: number; margin?: number; pair: [string, string]; from: Vector3; to: Vector3 | null};
  centring: null | {offset: Vector2; distance: number; height?: number; steps: number | null; tilt: number};
}

export interface ReachDocument {
  reachable: number[];
  reason: string[];
  branches: number[];
}

export interface FieldDocument {
  of: string;
  meaning?: string;
  values: (number | null)[];
  unit: string;
  steps?: (number | null)[];
}

export interface InverseDocument {
  /** found, not-found or out-of-reach. */
  status: string;
  branch: number;
  joints: number[] | null;
  predicted_tip?: Vector3 | null;
  branches: {status: string; reason: string; joints: number[]; tilt?: number; clearance: null | {distance: number}}[];
}

// ---- the error loop

export interface ErrorReading {
  id: string;
  kind: string;
  point: string;
  setup?: string;
  joints: number[];
  senses?: number[];
  load?: number;
  temperature?: number;
  time?: number;
  sigma?: number;
  held_out?: boolean;
}

export interface ComparedReading extends ErrorReading {
  error_before: Vector3;
  error_after: Vector3;
  size_before: number;
  size_after: number;
  sigmas_after?: number;
  measured?: Vector3;
  position_after?: Vector3;
}

export interface CompareDocument {
  verdict: string;
  sentence: string;
  chi2_per_dof: number;
  p_value: number;
  grounds: string[];
  joint_columns: string[];
  patterns: {sentence: string; variable: string; share_of_misfit: number; size: number}[];
  readings: ComparedReading[];
  rms: Record<string, number>;
  worst: {id: string; size: number; sigmas: number}[];
  units: Units;
  model: number;
  revision: number;
}

export interface Explanation {
  effects: EffectAt[];
  enough?: boolean;
  chi2: number;
  p_value: number;
  rms: number;
  heldout_rms: number | null;
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
}

/** A reading that would tell explanations apart, with the posture, load and sense of arrival to take it at. */
export interface NextReading {
  point?: string;
  kind?: string;
  load?: number;
  posture: Record<string, number>;
  senses?: Record<string, number>;
  splits?: string[];
  separation_sigmas?: number;
}

export interface DiagnoseDocument {
  verdict: string;
  sentence: string;
  chi2_per_dof: number;
  p_value: number;
  evidence: {best: number; noise_reaches: number};
  explanations: Explanation[];
  closest: Explanation[];
  ranking: RankedEffect[];
  readings: DiagnosedReading[];
  next_readings: NextReading[];
  splitting?: {
    advice?: string;
    other_means?: {what: string}[];
    columns_to_add?: string[];
    pairs?: {
      if_true: string;
      against: string;
      criterion_gap_now: number;
      criterion_gap_expected: number;
      probability_told: number;
    }[];
  };
  warnings: (string | {sentence: string})[];
  set_aside: string[];
  rms: Record<string, number>;
  joints: {name: string; unit: string}[];
  units: Units;
  model: number;
  revision: number;
}

export interface IdentifyDocument {
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
  units: Units;
  model: number;
  revision: number;
}

export interface LadderDocument {
  rungs: {
    name: string;
    chi2_per_dof: number;
    fitted_numbers: number;
    rms: {as_it_stands: number; fitted: number; heldout: number | null; noise_floor: number};
  }[];
  units: Units;
  model: number;
  revision: number;
}

export interface CatalogueDocument {
  effects: {
    effect: string;
    at: string;
    law: string;
    validity: string;
    source: string;
    parameters: {name: string; unit: string; neutral: number; low: number; high: number}[];
  }[];
}

// ---- calibration

export interface TouchesDocument {
  next_readings: {id: string; point: string; joints: number[]; place?: Vector3}[];
  base?: {tip_sigma?: Record<string, {rms: number; worst: number}>};
  units: Units;
}

export interface TouchList {
  touches: {hole: number; name?: string; joints: number[]; simulated?: boolean}[];
}

export interface CalibrateDocument {
  status: string;
  reason: string;
  base: {position: Vector3; rpy: Vector3};
  sigma: {position: Vector3; rotation: Vector3};
  covariance: number[][];
  chi2: number;
  p_value: number;
  degrees_of_freedom: number;
  rms: number;
  residuals: {id: string; hole: string; residual: Vector3; sigma: Vector3; size: number}[];
  distances: {from: string; to: string; by_arm: number; on_sheet: number; difference: number; sigma: number}[];
  suspects: unknown[];
  units: Units;
}

// ---- plan

export interface PlannedTube {
  name: string;
  leg: string;
  row: number;
  column: number;
  hole: Vector3;
  joints: number[];
  steps: number;
  tilt: number;
  centring_error: number;
  approach_deviation: number;
  probability_by_steps: number[];
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
  detours: number;
  counts?: Record<string, number[]>;
  units: Units;
}

export interface PathDocument {
  time: number[];
  segment: number[];
  kind: string[];
  joints: number[][];
  clearance: (number | null)[] | null;
  tube?: number[];
}
