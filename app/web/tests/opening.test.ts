// Tests every effect of the catalogue with readings in which it is hidden, simulated and diagnosed by the program. The
// error plot must open on the variable of the effect's law, and the error must fall to the promised error after the
// effect is added. Runs only if TUBEPLAN names the program.
import {execFileSync, spawn, type ChildProcess} from "node:child_process";
import {mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import path from "node:path";
import {afterAll, beforeAll, describe, expect, it} from "vitest";
import {turnedBy, viewOfCause} from "../../drawing/own_variable.js";
import {partsOf} from "../../drawing/error_parts.js";
import {variablesOf} from "../../drawing/variables.js";
import type {
  CatalogueDocument,
  DiagnoseDocument,
  EffectAt,
  LadderDocument,
  LeverageDocument,
  MomentsDocument,
  Vector3,
} from "../source/server/documents";

const program = process.env.TUBEPLAN ?? "";
const cells = process.env.TUBEPLAN_CELLS ?? path.resolve(__dirname, "../../cells");

interface Row {
  hide: string;
  /** Another effect that is hidden as well, which the effect extends. */
  beside?: string;
  /** Regular expression that the variable on which the plot opens must match. */
  opens_on: string;
  /** Name of the cell; "bench" if missing. */
  cell?: string;
  /** True for an arm whose file states no weights. */
  weightless?: boolean;
  /**
   * Kind of the readings, which are taken anywhere in the room; if missing, the design `bench` with positions only is
   * used.
   */
  kind?: string;
}

/** Effects hidden in the readings of each row; tests/web/four_clicks.mjs also tries them in the browser. */
const TABLE = JSON.parse(readFileSync(path.join(__dirname, "hidden_effects.json"), "utf8")) as Row[];
/** Relative tolerance between the error after adding the effect and the promised error. */
const NEAR = 0.05;

interface Server {
  address: string;
  child: ChildProcess;
}
const servers = new Map<string, Server>();
let folder = "";

/** Returns the path of the cell file, without the weights of the arm if the row requests it. */
function fileOf({cell = "bench", weightless}: Row): string {
  const shipped = path.join(cells, `${cell}.yaml`);
  if (!weightless) return shipped;
  const own = path.join(folder, "weightless");
  mkdirSync(own, {recursive: true});
  const text = readFileSync(shipped, "utf8"),
    arm = /^arm: (\S+)/m.exec(text)![1];
  writeFileSync(path.join(own, arm), readFileSync(path.join(cells, arm), "utf8").replace(/^ *weight: .*\n/gm, ""));
  writeFileSync(path.join(own, `${cell}.yaml`), text);
  return path.join(own, `${cell}.yaml`);
}

async function serve(row: Row): Promise<Server> {
  const cell = fileOf(row);
  const known = servers.get(cell);
  if (known) return known;
  const child = spawn(program, ["serve", cell, "--port", "0", "--state", folder]);
  const address = await new Promise<string>((resolve, reject) => {
    let said = "";
    child.stdout.on("data", (chunk) => {
      said += chunk;
      const found = /https?:\/\/\S+/.exec(said);
      if (found) resolve(found[0]);
    });
    child.on("exit", () => reject(new Error(`tubeplan serve ended: ${said}`)));
    setTimeout(() => reject(new Error("tubeplan serve printed no address")), 20000).unref();
  });
  const server = {address, child};
  servers.set(cell, server);
  return server;
}

async function callApi<T>(server: Server, name: string, body?: unknown): Promise<T> {
  const json = {method: "POST", headers: {"Content-Type": "application/json"}, body: JSON.stringify(body)};
  return answerTo<T>(server, name, body === undefined ? {} : json);
}

async function takeText(server: Server, name: string, text: string): Promise<void> {
  await answerTo(server, name, {method: "POST", headers: {"Content-Type": "text/csv"}, body: text});
}

async function answerTo<T>({address}: Server, name: string, order: RequestInit): Promise<T> {
  const answer = await fetch(`${address}api/${name}`, {...order, signal: AbortSignal.timeout(20000)});
  const document = await answer.json();
  if (!answer.ok) throw new Error(`${name}: ${JSON.stringify(document)}`);
  return document as T;
}

async function done(server: Server, name: string, body: unknown): Promise<void> {
  const {id} = await callApi<{id: number}>(server, name, body);
  for (const start = Date.now(); Date.now() - start < 90000;) {
    const {jobs} = await callApi<{jobs: {id: number; status: string; error: unknown}[]}>(server, "state");
    const job = jobs.find((entry) => entry.id === id)!;
    if (job.status === "done") return;
    if (job.status !== "running") throw new Error(`${name} ${job.status}: ${JSON.stringify(job.error)}`);
    await new Promise((resolve) => setTimeout(resolve, 40));
  }
  throw new Error(`${name} was not done within 90 s`);
}

/** Loads readings with the row's hidden effect into the server. */
async function simulate(server: Server, row: Row): Promise<void> {
  const spread = row.cell ? 0 : 0.1; // spread of the free parameters of the cell
  if (!row.kind) {
    const hide = [row.hide, ...(row.beside ? [row.beside] : [])];
    await done(server, "simulate", {design: "bench", readings: 120, seed: 7, hide, spread});
    return;
  }
  const design = path.join(folder, `${row.kind}.yaml`),
    made = path.join(folder, `${row.kind}-readings`);
  writeFileSync(design, `kind: ${row.kind}\nat: anywhere\nloads: [0, 20, 40]\n`);
  const options = ["--readings", "120", "--seed", "7", "--hide", row.hide, "--spread", `${spread}`, "--out", made];
  execFileSync(program, ["simulate", fileOf(row), "--design", design, ...options]);
  await takeText(server, "measurements?name=readings.csv", readFileSync(path.join(made, "measurements.csv"), "utf8"));
}

/**
 * Returns the hidden cause if it is among the explanations, otherwise the first cause, with the index of the
 * explanation.
 */
function causeOf(document: DiagnoseDocument, hidden: string): [EffectAt, number] {
  const isHidden = ({effect, at}: EffectAt) => `${effect}@${at}` === hidden;
  const index = Math.max(
    0,
    document.explanations.findIndex(({effects}) => effects.some(isHidden)),
  );
  const effects = document.explanations[index]?.effects ?? [];
  return [effects.find(isHidden) ?? effects[0], index];
}

async function opened(row: Row): Promise<{cause: EffectAt; variable: string; promised: number; left: number}> {
  const {hide} = row,
    server = await serve(row);
  await simulate(server, row);
  await done(server, "diagnose", {effects: 3, next: 1});
  const document = await callApi<DiagnoseDocument>(server, "results/diagnose");
  const [cause, index] = causeOf(document, hide.split(":")[0]);
  expect(cause, document.sentence).toBeDefined();
  const joints = document.joints.map((joint) => joint.name);
  const axis = /\.[xyz]$/.test(turnedBy(cause)) ? `,${turnedBy(cause)}` : "";
  const moments = await callApi<MomentsDocument>(server, "moments");
  const leverage = await callApi<LeverageDocument>(server, `leverage?at=${joints.join(",")}${axis}`);
  const places = document.readings.map((reading) => reading.position);
  const variables = variablesOf(
    {readings: document.readings, joints: document.joints, places},
    document.units,
    moments,
  );
  const parts = partsOf({ids: document.readings.map(({id}) => id), places, unit: document.units, leverage});
  const did = document.readings.map(({before, explained}): Vector3 | null => {
    const after = explained[index];
    return after ? [before[0] - after[0], before[1] - after[1], before[2] - after[2]] : null;
  });
  const variable = viewOfCause(cause, did, document.readings, variables, parts)?.variable.key ?? "";
  const {effects, heldout_rms, rms} = document.explanations[index];
  await done(server, "add", {causes: effects.map(({add, effect, at}) => add ?? `${effect}@${at}`)});
  const ladder = await callApi<LadderDocument>(server, "results/ladder");
  await callApi(server, "undo", {});
  return {cause, variable, promised: heldout_rms ?? rms, left: ladder.models.at(-1)!.rms.heldout ?? NaN};
}

describe.skipIf(program === "")("the plot opens on the variable that a hidden effect lives on", () => {
  beforeAll(() => {
    folder = mkdtempSync(path.join(tmpdir(), "tubeplan-opening-"));
  });
  afterAll(() => {
    for (const {child} of servers.values()) child.kill("SIGKILL");
    rmSync(folder, {recursive: true, force: true});
  });
  for (const row of TABLE)
    it(`${row.hide}${row.weightless ? ", weights not stated" : ""}`, async () => {
      const {cause, variable, promised, left} = await opened(row);
      if (process.env.TUBEPLAN_SHOW) console.log(`${row.hide} -> ${cause.effect}@${cause.at}: ${variable}`);
      expect(`${cause.effect}@${cause.at}`).toBe(row.hide.split(":")[0]);
      expect(variable).toMatch(new RegExp(row.opens_on));
      expect(Math.abs(left / promised - 1), `promised ${promised}, left ${left}`).toBeLessThan(NEAR);
    }, 120000);
  it("has a row for every effect that these arms can have", () => {
    for (const cell of ["bench", "column"]) {
      const text = execFileSync(program, ["effects", path.join(cells, `${cell}.yaml`), "--json", "-"]).toString();
      const {effects} = JSON.parse(text) as CatalogueDocument;
      const rows = new Set(TABLE.map(({hide}) => hide.split("@")[0]));
      for (const {effect, words, varies_with: variables} of effects) {
        expect(rows, effect).toContain(effect);
        expect(words, effect).toMatch(/ /);
        expect(variables.length, effect).toBeGreaterThan(0);
      }
    }
  });
});
