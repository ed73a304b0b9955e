// The ladder of errors as figures: its models, and whether a model is accepted.
import {modelNames, type ComparedModel as BareModel} from "../../../drawing/ladder.js";
import {errorUnit, idsSetAside} from "../../../drawing/error_budget.js";
import type {CompareDocument, DiagnoseDocument, LadderDocument} from "../server/documents";

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
    unit: errorUnit(document),
  };
}

/** Of a comparison or a diagnosis alone: the model as it stands, refitted, and with each explanation. */
export function ladderOfOne(document: CompareDocument | DiagnoseDocument): Ladder {
  return {
    models: (document.ladder ?? []).map((model) => ({
      name: model.name,
      fitted: model.rms,
      heldout: model.heldout_rms,
      worst: null,
      centred: null,
    })),
    floor: document.rms.noise_floor,
    unit: errorUnit(document),
  };
}

/** The rows of a diagnosis that are the diagnosed model, as it stands and refitted. */
const DIAGNOSED_ROWS = 2;

/**
 * The models up to the diagnosed one, with the figures that its verdict is of. Where the diagnosis sets other readings
 * aside than the ladder, its own rows alone are of its readings.
 */
export function ladderOfDiagnosis(climbed: LadderDocument | null, diagnosed: DiagnoseDocument): Ladder {
  const own = ladderOfOne(diagnosed);
  const isOfSame =
    climbed?.model === diagnosed.model &&
    [...idsSetAside(climbed)].sort().join() === [...idsSetAside(diagnosed)].sort().join();
  if (!climbed || !isOfSame) return {...own, models: own.models.slice(0, DIAGNOSED_ROWS)};
  const {models} = ladderOf(climbed);
  const last = {...models.at(-1)!, fitted: diagnosed.rms.before, heldout: diagnosed.rms.heldout_before};
  return {...own, models: [...models.slice(0, -1), last]};
}

export type Acceptance = "accepted" | "in part" | "rejected";

/** A model against a tolerance: by its errors on readings that it has not seen, where there are any. */
export function acceptanceOf(model: ComparedModel, tolerance: number | null): Acceptance | null {
  const rms = model.heldout ?? model.fitted;
  if (tolerance === null || rms === null || model.worst === null) return null;
  if (model.worst <= tolerance) return "accepted";
  return rms <= tolerance ? "in part" : "rejected";
}
