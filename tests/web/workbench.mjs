// Functions shared by the tests and the measuring script: the real server with the built page, and a browser.
import assert from "node:assert/strict";
import {spawn, execFileSync} from "node:child_process";
import {cpSync, mkdtempSync, readFileSync, rmSync, writeFileSync} from "node:fs";
import {createRequire} from "node:module";
import {tmpdir} from "node:os";
import path from "node:path";
import {fileURLToPath} from "node:url";

const here = path.dirname(fileURLToPath(import.meta.url));
export const source = path.resolve(here, "../..");
export const web = process.env.TUBEPLAN_WEB ?? path.join(source, "app/web");
const {chromium} = createRequire(path.join(web, "package.json"))("playwright-core");

export const program = process.env.TUBEPLAN ?? path.join(source, "build/tubeplan");
/** Folder of the built page; if empty, the server shows its embedded page. */
export const page = process.env.TUBEPLAN_PAGE ?? "";
/** Factor by which the page is slowed down, to test as on a busy machine. */
const slowness = Number(process.env.TUBEPLAN_SLOWNESS ?? 1);
/** Maximum delay of each request and each answer [ms], so that events overtake requests and answers. */
const jitter = Number(process.env.TUBEPLAN_JITTER ?? 0);
// Time limits [ms]; a failed start is reported within seconds.
const SIMULATE_LIMIT = 120_000;
const START_LIMIT = 20_000;
const ANSWER_LIMIT = 20_000;
const JOB_LIMIT = 120_000;
const STOP_LIMIT = 3000;

const browserPath = process.env.TUBEPLAN_CHROMIUM ?? "/usr/bin/chromium";

/** Makes a folder with the shipped cells, which is removed at the end of the tests. */
export function makeFolder() {
  const folder = mkdtempSync(path.join(tmpdir(), "tubeplan-web-"));
  cpSync(path.join(source, "app/cells"), folder, {recursive: true});
  return {
    folder,
    remove: () => rmSync(folder, {recursive: true, force: true}),
  };
}

/** Writes a design file with readings of the given kind anywhere in the room. */
export function writeDesign(folder, kind) {
  const file = path.join(folder, `design-${kind}.yaml`);
  writeFileSync(file, `kind: ${kind}\nat: anywhere\nloads: [0, 20, 40]\n`);
  return file;
}

/** Simulates practice readings with the program and writes them to NAME.csv in the folder. */
export function simulate(folder, name, options) {
  const out = path.join(folder, `${name}-made`);
  execFileSync(
    program,
    [
      "simulate",
      path.join(folder, options.cell ?? "bench.yaml"),
      "--design",
      options.design ?? "bench",
      "--readings",
      String(options.readings ?? 120),
      "--seed",
      String(options.seed ?? 7),
      "--spread",
      options.spread ?? "0.1",
      ...[options.hide, options.beside].flatMap((effect) => (effect ? ["--hide", effect] : [])),
      "--out",
      out,
    ],
    {stdio: "pipe", timeout: SIMULATE_LIMIT},
  );
  const file = path.join(folder, `${name}.csv`);
  cpSync(path.join(out, "measurements.csv"), file);
  rmSync(out, {recursive: true});
  return file;
}

/** Writes a copy of the cell, NAME-weightless.yaml, with an arm file that states no weights. */
export function writeWeightless(folder, cell) {
  const text = readFileSync(path.join(folder, `${cell}.yaml`), "utf8"),
    arm = /^arm: (\S+)/m.exec(text)[1];
  const bare = readFileSync(path.join(folder, arm), "utf8").replace(/^ *weight: .*\n/gm, "");
  writeFileSync(path.join(folder, `weightless-${arm}`), bare);
  writeFileSync(path.join(folder, `${cell}-weightless.yaml`), text.replace(`arm: ${arm}`, `arm: weightless-${arm}`));
  return `${cell}-weightless`;
}

/** Writes the mock-up cell with a different tube sheet: a full disc of 15,529 holes. */
export function writeDisc(folder) {
  const text = readFileSync(path.join(folder, "mockup.yaml"), "utf8")
    .replace(/layout: \{[^}]*\}/, "layout: {type: disc, pitch: 0.875, radius: 57.25}")
    .replace(/hole_diameter: .*/, "hole_diameter: 0.635")
    .replace(/leg: hot/, "leg: full")
    .replace(/^name: .*/m, "name: disc-mockup")
    .replace(/calibration_tool:[\s\S]*?(?=scene:)/, "");
  writeFileSync(path.join(folder, "disc.yaml"), text);
  return "disc.yaml";
}

let states = 0;

// A failed test does not stop its servers, which must neither keep this process alive nor outlive it.
const running = new Set();
process.on("exit", () => running.forEach((child) => child.kill("SIGKILL")));

function detach(child, isOn) {
  for (const handle of [child, child.stdout, child.stderr]) isOn ? handle.unref() : handle.ref();
}

/** Resolves with the address that the program prints. */
function addressOf(child, said, limit) {
  return new Promise((resolve, reject) => {
    const late = setTimeout(() => {
      child.kill("SIGKILL");
      reject(new Error(`tubeplan serve printed no address within ${limit / 1000} s: ${said.text}`));
    }, limit);
    const listen = (chunk) => {
      said.text += chunk;
      const found = /https?:\/\/[^\s]+/.exec(said.text);
      if (!found) return;
      clearTimeout(late);
      resolve(found[0]);
    };
    child.stdout.on("data", listen);
    child.stderr.on("data", listen);
    child.on("error", reject);
    child.on("exit", (code, signal) => {
      clearTimeout(late);
      running.delete(child);
      reject(new Error(`tubeplan serve ended with ${code ?? signal}: ${said.text}`));
    });
  });
}

/** Ends a server; fails if it has already ended. */
function end(child, signal, said) {
  return new Promise((resolve, reject) => {
    if (child.exitCode !== null || child.signalCode !== null) {
      reject(new Error(`tubeplan serve had ended with ${child.exitCode ?? child.signalCode}: ${said.text}`));
      return;
    }
    detach(child, false);
    const late = setTimeout(() => child.kill("SIGKILL"), STOP_LIMIT);
    child.on("exit", () => {
      clearTimeout(late);
      resolve();
    });
    child.kill(signal);
  });
}

/** Starts `tubeplan serve` on a free port with its session saved in `state`; resolves once the address is printed. */
export async function serve(
  folder,
  cell,
  more = [],
  state = path.join(folder, `state-${++states}`),
  limit = START_LIMIT,
) {
  const child = spawn(
    program,
    [
      "serve",
      path.join(folder, cell),
      ...["--port", "0", "--folder", folder, "--state", state],
      ...(page ? ["--page", page] : []),
      ...more,
    ],
    {stdio: ["ignore", "pipe", "pipe"]},
  );
  running.add(child);
  const said = {text: ""};
  const address = await addressOf(child, said, limit);
  detach(child, true);
  return {
    address,
    pid: child.pid,
    /** Kills the server with SIGKILL, as if the machine had stopped. */
    kill: () => end(child, "SIGKILL", said),
    stop: () => end(child, "SIGINT", said),
  };
}

/** Gets a document `name` from the server or, with a body, posts a request; fails if the server does not answer. */
export async function callApi({address}, name, body) {
  const signal = AbortSignal.timeout(ANSWER_LIMIT);
  const order = {method: "POST", headers: {"Content-Type": "application/json"}, body: JSON.stringify(body)};
  const answer = await fetch(`${address}api/${name}`, body === undefined ? {signal} : {...order, signal});
  return {status: answer.status, body: await answer.json()};
}

export const stateOf = async (server) => (await callApi(server, "state")).body;

/** Waits until the job `id` has ended and returns its status. */
export async function ended(server, id, limit = JOB_LIMIT) {
  for (const start = Date.now(); Date.now() - start < limit;) {
    const job = (await stateOf(server)).jobs.find((entry) => entry.id === id);
    if (job.status !== "running") return job.status;
    await new Promise((resolve) => setTimeout(resolve, 30));
  }
  throw new Error(`job ${id} was not done within ${limit / 1000} s`);
}

/** Starts Chromium, with a time limit shorter than Playwright's default of half a minute. */
export function launch(limit = START_LIMIT) {
  const launched = chromium.launch({
    executablePath: browserPath,
    args: ["--no-sandbox", "--enable-unsafe-swiftshader"],
  });
  return new Promise((resolve, reject) => {
    const late = setTimeout(() => {
      launched.then((browser) => browser.close()).catch(() => {});
      reject(new Error(`${browserPath} did not start within ${limit / 1000} s`));
    }, limit);
    launched.then(resolve, reject).finally(() => clearTimeout(late));
  });
}

const heldUp = () => new Promise((resolve) => setTimeout(resolve, Math.random() * jitter));

/** Delays requests and answers by random times; events are not delayed. */
async function holdUp(route) {
  await heldUp();
  try {
    const response = await route.fetch();
    await heldUp();
    await route.fulfill({response});
  } catch {
    await route.abort().catch(() => {}); // the tab was closed meanwhile
  }
}

/**
 * Opens a tab whose console errors are recorded, so that a test can assert that there are none. `prepare` is called
 * with the tab before the address is opened.
 */
export async function openTab(browser, address, {prepare = async () => {}, ...options} = {}) {
  const context = await browser.newContext({
    viewport: {width: 1280, height: 720},
    ...options,
  });
  const tab = await context.newPage();
  if (slowness > 1) {
    const session = await context.newCDPSession(tab);
    await session.send("Emulation.setCPUThrottlingRate", {rate: slowness});
    await session.send("Network.enable");
    const latency = 40 * slowness; // [ms]
    await session.send("Network.emulateNetworkConditions", {
      offline: false,
      latency,
      downloadThroughput: -1,
      uploadThroughput: -1,
    });
  }
  tab.errors = [];
  tab.on("console", (message) => message.type() === "error" && tab.errors.push(message.text()));
  tab.on("pageerror", (error) => tab.errors.push(error.stack ?? error.message));
  if (jitter > 0) await tab.route(/\/api\/(?!events)/, holdUp);
  await prepare(tab);
  await tab.goto(address);
  return tab;
}

/** Returns the labels of the controls that a telephone's window cuts off, except in rows that scroll sideways. */
export async function controlsCutOff(tab) {
  const before = tab.viewportSize();
  await tab.setViewportSize({width: 400, height: 800});
  await tab.waitForTimeout(300); // until the layout has settled
  const {count, cut} = await tab.evaluate(() => {
    const controls = [...document.querySelectorAll(".view .panel :is(button, input, select)")].filter(
      (control) => control.checkVisibility() && !control.closest(".tabs, .segments"),
    );
    const isCut = (control) => {
      const panel = control.closest(".panel").getBoundingClientRect(),
        {left, right} = control.getBoundingClientRect();
      return left < panel.left - 1 || right > panel.right + 1;
    };
    return {count: controls.length, cut: controls.filter(isCut).map((c) => c.textContent || c.ariaLabel || c.type)};
  });
  await tab.setViewportSize(before);
  assert.ok(count > 0, "controls were looked at");
  return cut;
}

/** Returns the tab's errors, except those that the browser logs for results that were gone before they were fetched. */
export function errorsOf(tab) {
  return tab.errors.filter((text) => !/status of 404/.test(text));
}

/** Drops a file, or a list of files given by names and contents, on the page. */
export async function drop(tab, name, text) {
  const data = await tab.evaluateHandle(
    (files) => {
      const transfer = new DataTransfer();
      for (const [file, content] of files) transfer.items.add(new File([content], file, {type: "text/csv"}));
      return transfer;
    },
    typeof name === "string" ? [[name, text]] : name,
  );
  await tab.dispatchEvent("main", "drop", {dataTransfer: data});
}

/** Prepares a test file: a folder with the shipped cells, and a browser. */
export async function begin() {
  return {made: makeFolder(), browser: await launch()};
}

export async function finish({made, browser}) {
  await browser?.close();
  made?.remove();
}

/** Returns the tab and the server with a function that closes both and asserts that the page reported no error. */
export function closable(tab, server) {
  const close = async () => {
    assert.deepEqual(tab.errors, []);
    await tab.context().close();
    await server.stop();
  };
  return {tab, server, close};
}
