// The ladder of errors as figures: its rungs, and where the axis of its bars ends.
import type {LadderDocument} from "../server/documents";

export interface Rung {
  name: string;
  fitted: number | null;
  heldout: number | null;
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
    })),
    floor: document.rungs.at(-1)?.rms.noise_floor ?? null,
    unit: document.units.length,
  };
}

/** Where the axis ends: at the largest error, unless that would press the others against the left. */
export function axisEnd(rungs: readonly Rung[], floor: number | null): number {
  const errors = rungs.map((rung) => Math.max(rung.fitted ?? 0, rung.heldout ?? 0));
  const others = Math.max(floor ?? 0, ...errors.slice(1));
  const largest = Math.max(floor ?? 0, ...errors) || 1;
  return errors.length > 1 && others > 0 && largest > 4 * others ? 1.7 * others : 1.06 * largest;
}
