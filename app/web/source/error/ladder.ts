// The ladder of errors as figures: its rungs, and where the axis of its bars ends.
import type {LadderDocument} from "../server/documents";

export interface Rung {
  name: string;
  fitted: number | null;
  heldout: number | null;
  /** The largest error: held out, else fitted. */
  worst: number | null;
  /** Of so many holes, in how many every step of the tool would go in; null where there is no sheet. */
  centred: {holes: number; all: number} | null;
}

export interface Ladder {
  rungs: Rung[];
  floor: number | null;
  unit: string;
}

/** Model names as files are long: their last part tells them apart. */
export function rungName(name: string): string {
  return name.replace(/^.*\//, "").replace(/\.yaml\b/, "");
}

export function ladderOf(document: LadderDocument): Ladder {
  return {
    rungs: document.rungs.map((rung) => ({
      name: rungName(rung.name),
      fitted: rung.rms.fitted,
      heldout: rung.rms.heldout,
      worst: rung.worst.heldout ?? rung.worst.fitted,
      centred: rung.steps ? {holes: rung.steps.holes, all: rung.steps.counts.at(-1) ?? 0} : null,
    })),
    floor: document.rungs.at(-1)?.rms.noise_floor ?? null,
    unit: document.units.length,
  };
}

export type Acceptance = "accepted" | "in part" | "rejected";

/** A model against a tolerance: by its errors on readings that it has not seen, where there are any. */
export function acceptanceOf(rung: Rung, tolerance: number | null): Acceptance | null {
  const rms = rung.heldout ?? rung.fitted;
  if (tolerance === null || rms === null || rung.worst === null) return null;
  if (rung.worst <= tolerance) return "accepted";
  return rms <= tolerance ? "in part" : "rejected";
}

/** Where the axis ends: at the largest error, unless that would press the others against the left. */
export function axisEnd(rungs: readonly Rung[], floor: number | null): number {
  const errors = rungs.map((rung) => Math.max(rung.fitted ?? 0, rung.heldout ?? 0));
  const others = Math.max(floor ?? 0, ...errors.slice(1));
  const largest = Math.max(floor ?? 0, ...errors) || 1;
  return errors.length > 1 && others > 0 && largest > 4 * others ? 1.7 * others : 1.06 * largest;
}
