// Documents of the sheet, the scene, postures, and fields over the holes.
import type {Units, Vector2, Vector3} from "./common_documents";

export interface SheetDocument {
  name: string;
  units: Units | string;
  pitch: number;
  hole_diameter: number;
  rows: number;
  columns: number;
  viewing_side: string;
  view_words: string;
  leg: string;
  leg_words: string;
  /**
   * Manway in the bowl, in the world frame; u and v: components of its direction from the sheet's middle in the
   * drawing. Null if the cell states none.
   */
  manway: {center: Vector3; diameter: number; u: number; v: number} | null;
  tool?: {diameters: number[]; tolerances: number[]; step_words: string[]} | null;
  holes: {
    row: number[];
    column: number[];
    x: number[];
    y: number[];
    z: number[];
    u: number[];
    v: number[];
    state: number[];
    states: string[];
    /** The hole states in words, in the order of `states`. */
    state_words: string[];
  };
}

/** Shape in a cell file, in the world frame or in the frame of its row: its kind, and the fields that regions are drawn by. */
export interface SolidShape {
  kind: string;
  name: string;
  radius?: number;
  center?: Vector3;
  point?: Vector3;
  normal?: Vector3;
  /** Coordinates of points on a solid's surface whose convex hull is drawn, one point after another. */
  outline?: number[] | null;
  /** Mesh whose bounding box the outline is; the corners of its triangles are missing if there are too many. */
  mesh?: {triangles: number; positions?: number[]};
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
  segments?: {tip_error: number | null; needed: number; warning: string};
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
  model: number;
  meaning?: string;
  values: (number | null)[];
  unit: string;
  steps?: (number | null)[];
}

export interface InverseDocument {
  /** "found", "not-found" or "out-of-reach". */
  status: string;
  branch: number;
  joints: number[] | null;
  branches: {status: string; reason: string; joints: number[]; tilt?: number; clearance: null | {distance: number}}[];
}
