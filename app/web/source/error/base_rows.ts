// Fitted poses of bases as rows of the table of fitted numbers.
import type {IdentifyDocument} from "../server/documents";

const AXES = ["x", "y", "z"] as const;

/** Returns position and turns of each fitted base, with the sigmas of its fitted steps. */
export function baseRows({
  bases = [],
  base_steps: steps = [],
  units,
}: IdentifyDocument): IdentifyDocument["parameters"] {
  return bases.flatMap(({setup, known, base: {position, rpy}}) => {
    if (known) return [];
    const at = setup === "" ? "" : `@${setup}`;
    const row = (word: string, kind: string, k: number, value: number, unit: string) => {
      const step = steps.find(({name}) => name === `base.${kind}.${AXES[k]}${at}`);
      const {sigma = null, identifiable = "yes"} = step ?? {};
      return {name: `base.${word}.${AXES[k]}${at}`, value, sigma, start: null, unit, identifiable, interval: null};
    };
    return [
      ...position.map((value, k) => row("position", "shift", k, value, units.length)),
      ...rpy.map((value, k) => row("turn", "turn", k, value, units.angle)),
    ];
  });
}
