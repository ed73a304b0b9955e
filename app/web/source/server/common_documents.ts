// Common parts of the server's documents.

export type Vector3 = [number, number, number];
export type Vector2 = [number, number];

export interface Units {
  length: string;
  angle: string;
  force: string;
  temperature?: string;
  time?: string;
  /** Conditions that readings may state under these names. */
  conditions?: {name: string; unit: string}[];
}

/** Placement of a base; `words` continue "proved" and "steps". */
export interface BaseStanding {
  status: string;
  words: string;
  placed: boolean;
  touches: number;
}

/** Problem with an input, in the program's words. `found` is the wrong value; without `expected`, a sentence. */
export interface Problem {
  where?: string;
  found?: string;
  expected?: string;
  advice?: string;
  message: string;
}
