// What several of the server's documents hold.

export type Vector3 = [number, number, number];
export type Vector2 = [number, number];

export interface Units {
  length: string;
  angle: string;
  force: string;
  temperature?: string;
  time?: string;
  /** That readings may state under these names. */
  conditions?: {name: string; unit: string}[];
}

/** How a base was placed; `words` continue "proved" and "steps". */
export interface BaseStanding {
  status: string;
  words: string;
  placed: boolean;
  touches: number;
}

/** What is wrong with an input, as the program says it. */
export interface Problem {
  where?: string;
  found?: string;
  expected?: string;
  advice?: string;
  message: string;
}
