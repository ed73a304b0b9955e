// Speed of a film, so that nobody waits long for the film of a long path.

/** Longest film of a whole path [s]. */
const LONGEST = 60;

/**
 * Returns the speed at which a film of a path of `seconds` starts: the given speed or, where the film would be longer
 * than a minute, the least of the offered speeds that is enough. Beyond all of them, the least that is enough.
 */
export function filmSpeed(seconds: number, speed: number, offered: readonly number[]): number {
  const least = seconds / LONGEST;
  if (speed >= least) return speed;
  return offered.find((factor) => factor >= least) ?? Math.ceil(least);
}
