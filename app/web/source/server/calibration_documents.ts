// Touches and where the base stands.
import type {Units, Vector3} from "./common_documents";

export interface TouchesDocument {
  next_readings: {id: string; point: string; joints: number[]; place?: Vector3}[];
  base?: {tip_sigma?: Record<string, {rms: number; worst: number}>};
  units: Units;
}

export interface TouchList {
  touches: {id: string; hole: number; name?: string; joints: number[]; simulated?: boolean}[];
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
  verdict: "adequate" | "falls-short";
  warnings: string[];
  to_do: string[];
  nominal: {distance: number; angle: number; pitches: [number, number] | null; implausible: boolean};
  units: Units;
}
