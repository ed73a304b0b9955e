// Requests to the server: JSON in and out; a refusal carries the program's message.
import {inChosenUnits} from "./chosen_units";
import type {Problem} from "./documents";

/** Error for a refusal by the server, or for a missing answer. */
export class ServerProblem extends Error {
  constructor(
    readonly status: number,
    readonly problem: Problem,
  ) {
    super(problem.message);
  }
}

async function problemOf(response: Response): Promise<Problem> {
  try {
    const body = await response.json();
    if (body && typeof body.error === "object" && body.error !== null) {
      return {message: `The server answered ${response.status}.`, ...body.error};
    }
  } catch {
    // Without a JSON body, only the status is known.
  }
  return {message: `The server answered ${response.status} ${response.statusText}.`};
}

async function request<T>(path: string, options?: RequestInit): Promise<T> {
  let response: Response;
  try {
    response = await fetch(inChosenUnits(path), {credentials: "same-origin", cache: "no-store", ...options});
  } catch {
    throw new ServerProblem(0, {
      message: "The program does not respond.",
      advice: "Check whether it still runs in its terminal; this page reconnects by itself.",
    });
  }
  if (!response.ok) throw new ServerProblem(response.status, await problemOf(response));
  return (await response.json()) as T;
}

export function get<T>(path: string): Promise<T> {
  return request<T>(path);
}

export function post<T>(path: string, body: unknown = {}): Promise<T> {
  return request<T>(path, {method: "POST", headers: {"Content-Type": "application/json"}, body: JSON.stringify(body)});
}

export function postText<T>(path: string, text: string | Blob, type = "text/csv"): Promise<T> {
  return request<T>(path, {method: "POST", headers: {"Content-Type": type}, body: text});
}

export function remove<T>(path: string): Promise<T> {
  return request<T>(path, {method: "DELETE"});
}

export function isMissing(error: unknown): boolean {
  return error instanceof ServerProblem && error.status === 404;
}

export function asProblem(error: unknown): Problem {
  if (error instanceof ServerProblem) return error.problem;
  return {message: error instanceof Error ? error.message : String(error)};
}
