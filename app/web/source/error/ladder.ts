// The ladder of errors as numbers: its models and their acceptance.
import {heldOutOf, modelNames, type ComparedModel as BareModel} from "../../../drawing/ladder.js";
import {errorUnit, idsSetAside} from "../../../drawing/error_budget.js";
import type {CompareDocument, DiagnoseDocument, LadderDocument} from "../server/documents";

export interface ComparedModel extends BareModel {
  /** Largest held-out error, otherwise the largest fitted error. */
  worst: number | null;
  /** Number of holes, and number of holes that every step of the tool would enter; null without a sheet. */
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
      heldout: heldOutOf(model.rms.fitted, model.rms.heldout),
      worst: model.worst.heldout ?? model.worst.fitted,
      centred: model.steps ? {holes: model.steps.holes, all: model.steps.counts.at(-1) ?? 0} : null,
    })),
    floor: document.models.at(-1)?.rms.noise_floor ?? null,
    unit: errorUnit(document),
  };
}

/**
 * Returns the errors of the last two models, both held out or, if one has no held-out error, both fitted; null without
 * them.
 */
export function lastChange(models: readonly BareModel[]): {before: number; now: number; error: string} | null {
  const pair = models.slice(-2);
  const error = pair.every(({heldout}) => heldout !== null) ? "heldout" : "fitted";
  const [before, now] = pair.map((model) => model[error] ?? null);
  if (pair.length < 2 || before === null || now === null) return null;
  return {before, now, error: error === "fitted" ? "fitted" : "held-out"};
}

/**
 * Returns the ladder within a comparison or diagnosis: the given model, the refitted model, and the model with each
 * explanation.
 */
export function ladderOfOne(document: CompareDocument | DiagnoseDocument): Ladder {
  return {
    models: (document.ladder ?? []).map((model) => ({
      name: model.name,
      fitted: model.rms,
      heldout: heldOutOf(model.rms, model.heldout_rms),
      worst: null,
      centred: null,
    })),
    floor: document.rms.noise_floor,
    unit: errorUnit(document),
  };
}

/** Number of ladder rows of a diagnosis that show the diagnosed model: as given and refitted. */
const DIAGNOSED_ROWS = 2;

/**
 * Returns the models of the ladder up to the diagnosed model, which has the errors of the diagnosis. If ladder and
 * diagnosis exclude different readings, only the rows of the diagnosis are used.
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

/** Returns the acceptance of a model at a tolerance, from its held-out errors if there are any; null if unknown. */
export function acceptanceOf(model: ComparedModel, tolerance: number | null): Acceptance | null {
  const rms = model.heldout ?? model.fitted;
  if (tolerance === null || rms === null || model.worst === null) return null;
  if (model.worst <= tolerance) return "accepted";
  return rms <= tolerance ? "in part" : "rejected";
}
