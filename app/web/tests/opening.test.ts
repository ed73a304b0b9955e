// For every effect of the catalogue: readings that hide it, made and diagnosed by the program itself, open the plot of the
// errors on the variable that its law lives on. Only where TUBEPLAN names the program.
import {execFileSync, spawn, type ChildProcess} from "node:child_process";
import {mkdtempSync, rmSync} from "node:fs";
import {tmpdir} from "node:os";
import path from "node:path";
import {afterAll, beforeAll, describe, expect, it} from "vitest";
import {turnedBy, viewOfCause} from "../source/error/own_variable";
import {partsOf} from "../source/error/parts";
import {variablesOf} from "../../drawing/variables.js";
import type {
  CatalogueDocument,
  DiagnoseDocument,
  EffectAt,
  LeverageDocument,
  MomentsDocument,
  Vector3,
} from "../source/server/documents";

const program = process.env.TUBEPLAN ?? "";
const cells = process.env.TUBEPLAN_CELLS ?? path.resolve(__dirname, "../../cells");

interface Row {
  cell?: string;
  /** What these readings are best explained by, where that is not what is hidden: it is drawn then. */
  namedAs?: string;
}

/** What is hidden, and the variable that it must open on; on the bench unless another cell is named. */
const TABLE: [string, RegExp, Row?][] = [
  ["joint-offset@theta2:0.3deg", /^theta2$/],
  ["joint-scale@theta3:0.004", /^theta3$/],
  ["encoder-eccentricity@theta3:sine=0.1deg", /^theta3$/],
  ["transmission-error@theta2:sine=0.08deg", /^theta2$/],
  ["hysteresis@theta4:0.06deg", /^theta4_dir$/],
  ["joint-coupling@theta3<-theta2:0.004", /^theta2$/],
  ["link-length@forearm:0.06in", /^theta\d$/],
  ["link-twist@base-link:0.3deg", /^theta\d$/],
  ["tool-offset@tool:x=0.08in,y=0.05in", /^theta\d$/],
  ["thermal-growth@arm", /^temperature$/],
  ["link-weight@forearm:10lbf", /^(theta\d|moment_.*)$/],
  ["tool-weight@tool:0.4", /^(theta\d|moment_.*)$/],
  ["payload-offset@payload:x=4in,y=3in", /^load$/],
  ["gravity-tilt@base:x=2deg,y=1deg", /^theta\d$/],
  ["hose-pull@forearm:x=8lbf,y=6lbf", /^theta\d$/],
  ["contact-force@tip:20lbf", /^(theta\d|moment_.*)$/],
  ["joint-compliance@base-link.y:0.0005", /^moment_base_link_y$/],
  ["link-bending@latch-link.y", /^moment_latch_link_y$/],
  ["link-torsion@latch-link", /^moment_latch_link_[xyz]$/],
  ["stiffening@tool.z", /^moment_tool_z$/],
  ["backlash@tool.z:0.15deg", /^moment_tool_z$/],
  ["base-slip@base:x=0.08,y=0.05,time=90", /^time$/],
  ["base-drift@base:x=0.0005,y=0.0004", /^time$/],
  ["scale-error@measurement:0.001", /^position_[xyz]$/],
  ["gravity-sag@theta4:own_x=0.15deg,own_y=0.1deg", /^moment_tool_z$/, {namedAs: "contact-force@tip"}],
  ["cable-stretch@theta2:stretch=0.0005", /^(moment_.*|theta2_dir)$/],
  ["slide-bending@column.y", /^moment_column_y$/, {cell: "column"}],
];

interface Server {
  address: string;
  child: ChildProcess;
}
const servers = new Map<string, Server>();
let folder = "";

async function serve(cell: string): Promise<Server> {
  const known = servers.get(cell);
  if (known) return known;
  const child = spawn(program, ["serve", path.join(cells, `${cell}.yaml`), "--port", "0", "--state", folder]);
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

async function ask<T>({address}: Server, name: string, body?: unknown): Promise<T> {
  const order = {method: "POST", headers: {"Content-Type": "application/json"}, body: JSON.stringify(body)};
  const answer = await fetch(`${address}api/${name}`, {
    ...(body === undefined ? {} : order),
    signal: AbortSignal.timeout(20000),
  });
  const document = await answer.json();
  if (!answer.ok) throw new Error(`${name}: ${JSON.stringify(document)}`);
  return document as T;
}

async function done(server: Server, name: string, body: unknown): Promise<void> {
  const {id} = await ask<{id: number}>(server, name, body);
  for (const start = Date.now(); Date.now() - start < 90000;) {
    const {jobs} = await ask<{jobs: {id: number; status: string; error: unknown}[]}>(server, "state");
    const job = jobs.find((entry) => entry.id === id)!;
    if (job.status === "done") return;
    if (job.status !== "running") throw new Error(`${name} ${job.status}: ${JSON.stringify(job.error)}`);
    await new Promise((resolve) => setTimeout(resolve, 40));
  }
  throw new Error(`${name} was not done within 90 s`);
}

/** The cause to look at: what was hidden where it is among the explanations, else the first of all. */
function causeOf(document: DiagnoseDocument, hidden: string): [EffectAt, number] {
  const isHidden = ({effect, at}: EffectAt) => `${effect}@${at}` === hidden;
  const index = Math.max(
    0,
    document.explanations.findIndex(({effects}) => effects.some(isHidden)),
  );
  const effects = document.explanations[index]?.effects ?? [];
  return [effects.find(isHidden) ?? effects[0], index];
}

async function opened(hide: string, cell: string): Promise<{cause: EffectAt; variable: string}> {
  const server = await serve(cell);
  const spread = cell === "bench" ? 0.1 : 0; // of the numbers that the cell sets free
  await done(server, "simulate", {design: "bench", readings: 120, seed: 7, hide: [hide], spread});
  await done(server, "diagnose", {effects: 3, next: 1});
  const document = await ask<DiagnoseDocument>(server, "results/diagnose");
  const [cause, index] = causeOf(document, hide.split(":")[0]);
  expect(cause, document.sentence).toBeDefined();
  const joints = document.joints.map((joint) => joint.name);
  const axis = /\.[xyz]$/.test(turnedBy(cause)) ? `,${turnedBy(cause)}` : "";
  const moments = await ask<MomentsDocument>(server, "moments");
  const leverage = await ask<LeverageDocument>(server, `leverage?at=${joints.join(",")}${axis}`);
  const places = document.readings.map((reading) => reading.position);
  const unit = document.units as unknown as Record<string, string>;
  const variables = variablesOf({readings: document.readings, joints: document.joints, places}, unit, moments);
  const parts = partsOf({ids: document.readings.map(({id}) => id), places, unit: document.units, leverage});
  const did = document.readings.map(({before, explained}): Vector3 | null => {
    const after = explained[index];
    return after ? [before[0] - after[0], before[1] - after[1], before[2] - after[2]] : null;
  });
  return {cause, variable: viewOfCause(cause, did, document.readings, variables, parts)?.variable.key ?? ""};
}

describe.skipIf(program === "")("the plot opens on the variable that a hidden effect lives on", () => {
  beforeAll(() => {
    folder = mkdtempSync(path.join(tmpdir(), "tubeplan-opening-"));
  });
  afterAll(() => {
    for (const {child} of servers.values()) child.kill("SIGKILL");
    rmSync(folder, {recursive: true, force: true});
  });
  for (const [hide, wanted, row] of TABLE)
    it(
      hide,
      async () => {
        const {cause, variable} = await opened(hide, row?.cell ?? "bench");
        if (process.env.TUBEPLAN_SHOW) console.log(`${hide} -> ${cause.effect}@${cause.at}: ${variable}`);
        expect(`${cause.effect}@${cause.at}`).toBe(row?.namedAs ?? hide.split(":")[0]);
        expect(variable).toMatch(wanted);
      },
      120000,
    );
  it("has a row for every effect that these arms can have", () => {
    for (const cell of ["bench", "column"]) {
      const text = execFileSync(program, ["effects", path.join(cells, `${cell}.yaml`), "--json", "-"]).toString();
      const {effects} = JSON.parse(text) as CatalogueDocument;
      const rows = new Set(TABLE.map(([hide]) => hide.split("@")[0]));
      for (const {effect, words, varies_with: variables} of effects) {
        expect(rows, effect).toContain(effect);
        expect(words, effect).toMatch(/ /);
        expect(variables.length, effect).toBeGreaterThan(0);
      }
    }
  });
});
