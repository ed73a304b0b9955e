// The ladder of errors as figures: its models, and whether a model is accepted.
import {modelNames, type ComparedModel as BareModel} from "../../../drawing/ladder.js";
import type {CompareDocument, LadderDocument} from "../server/documents";

export interface ComparedModel extends BareModel {
  /** The largest error: held out, else fitted. */
  worst: number | null;
  /** Of so many holes, in how many every step of the tool would go in; null where there is no sheet. */
  centred: {holes: number; all: number} | null;
}

export interface Ladder {
  models: ComparedModel[];
  floor: number | null;
  unit: string;
}

export function ladderOf(document: LadderDocument): Ladder {
  const names = modelNames(document.models.map(({name}) => name));
  return {
    models: document.models.map((model, k) => ({
      name: names[k],
      fitted: model.rms.fitted,
      heldout: model.rms.heldout,
      worst: model.worst.heldout ?? model.worst.fitted,
      centred: model.steps ? {holes: model.steps.holes, all: model.steps.counts.at(-1) ?? 0} : null,
    })),
    floor: document.models.at(-1)?.rms.noise_floor ?? null,
    unit: document.units.length,
  };
}

/** Of a comparison alone: the model as it stands, and refitted. */
export function ladderOfComparison({ladder, rms, units}: CompareDocument): Ladder {
  return {
    models: (ladder ?? []).map((model) => ({
      name: model.name,
      fitted: model.rms,
      heldout: model.heldout_rms,
      worst: null,
      centred: null,
    })),
    floor: rms.noise_floor,
    unit: units.length,
  };
}

export type Acceptance = "accepted" | "in part" | "rejected";

/** A model against a tolerance: by its errors on readings that it has not seen, where there are any. */
export function acceptanceOf(model: ComparedModel, tolerance: number | null): Acceptance | null {
  const rms = model.heldout ?? model.fitted;
  if (tolerance === null || rms === null || model.worst === null) return null;
  if (model.worst <= tolerance) return "accepted";
  return rms <= tolerance ? "in part" : "rejected";
}
