// Documents of touches and of the base calibration.
import type {Units, Vector3} from "./common_documents";

export interface TouchesDocument {
  next_readings: {id: string; point: string; joints: number[]; place?: Vector3}[];
  base?: {tip_sigma?: Record<string, {rms: number; worst: number}>};
  units: Units;
}

export interface TouchList {
  touches: {id: string; hole: number; name?: string; joints: number[]; load?: number; simulated?: boolean}[];
}

/** Joint reading of a touch: a reading error `off` would explain the misfit of the touches. */
export interface SuspectReading {
  touch: string;
  joint: string;
  off: number;
  unit: string;
  p_value: number;
}

export interface TouchResidual {
  id: string;
  hole: string;
  residual: Vector3;
  sigma: Vector3;
  size: number;
}

/**
 * Result of a calibration. If the touches were refused, base, sigma, covariance and nominal are missing; with too few
 * or collinear touches, the residuals are missing too.
 */
export interface CalibrateDocument {
  status: "done" | "refused" | "not-converged";
  reason: string;
  base?: {position: Vector3; rpy: Vector3};
  sigma?: {position: Vector3; rotation: Vector3};
  covariance?: number[][];
  chi2?: number;
  p_value?: number;
  degrees_of_freedom?: number;
  rms?: number;
  residuals?: TouchResidual[];
  distances?: {from: string; to: string; by_arm: number; on_sheet: number; difference: number; sigma: number}[];
  suspects: string[];
  /**
   * Touch without which the others fit; null if there is none. Like suspect_readings, it is missing in projects of
   * earlier versions.
   */
  odd_touch?: string | null;
  suspect_readings?: SuspectReading[];
  verdict?: "adequate" | "falls-short";
  warnings?: string[];
  to_do?: string[];
  nominal?: {distance: number; angle: number; pitches: [number, number] | null; implausible: boolean};
  units: Units;
}
