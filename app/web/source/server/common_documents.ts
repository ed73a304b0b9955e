// Common parts of the server's documents.

export type Vector3 = [number, number, number];
export type Vector2 = [number, number];

export interface Units {
  length: string;
  angle: string;
  force: string;
  temperature?: string;
  time?: string;
  /** Further conditions that readings may state, with their names and units. */
  conditions?: {name: string; unit: string}[];
}

/** Origin of the base pose; `words` continue a sentence that begins with "proved" or "steps". */
export interface BaseStanding {
  status: string;
  words: string;
  placed: boolean;
  touches: number;
}

/**
 * Problem with an input, in the program's words. `found` is the wrong value; if `expected` is missing, `found` is a
 * sentence.
 */
export interface Problem {
  where?: string;
  found?: string;
  expected?: string;
  advice?: string;
  message: string;
  /** Choice that would avoid the error: `name` is the key of the request that names it; the first value is likeliest. */
  choice?: {name: string; label: string; values: {value: string; words: string}[]};
}
