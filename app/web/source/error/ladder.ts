// The ladder of errors as figures: its rungs, and whether a model is accepted.
import {rungNames, type Rung as BareRung} from "../../../drawing/ladder.js";
import type {CompareDocument, LadderDocument} from "../server/documents";

export interface Rung extends BareRung {
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

export function ladderOf(document: LadderDocument): Ladder {
  const names = rungNames(document.rungs.map(({name}) => name));
  return {
    rungs: document.rungs.map((rung, k) => ({
      name: names[k],
      fitted: rung.rms.fitted,
      heldout: rung.rms.heldout,
      worst: rung.worst.heldout ?? rung.worst.fitted,
      centred: rung.steps ? {holes: rung.steps.holes, all: rung.steps.counts.at(-1) ?? 0} : null,
    })),
    floor: document.rungs.at(-1)?.rms.noise_floor ?? null,
    unit: document.units.length,
  };
}

/** Of a comparison alone: the model as it stands, and refitted. */
export function ladderOfComparison({ladder, rms, units}: CompareDocument): Ladder {
  return {
    rungs: (ladder ?? []).map((rung) => ({
      name: rung.name,
      fitted: rung.rms,
      heldout: rung.heldout_rms,
      worst: null,
      centred: null,
    })),
    floor: rms.noise_floor,
    unit: units.length,
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
